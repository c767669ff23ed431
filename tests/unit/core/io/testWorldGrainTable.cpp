#include "core/io/worldGrainTable.hpp"

#include "core/base/setupError.hpp"
#include "core/shapes/scaledShape.hpp"
#include "core/world/composition.hpp"
#include "core/world/randomInsertion.hpp"
#include "unit/core/world/worldScenes.hpp"
#include "unit/temporaryFolder.hpp"

#include <set>

using namespace chesil;

namespace
{

class WorldGrainTable : public test::TemporaryFolder
{
protected:
    std::string path() const { return folder_ + "/grains.csv"; }

    std::vector<GrainState> throughFile(const World& world, const std::vector<GrainState>& start,
                                        std::vector<NamedShape>& shapes) const
    {
        writeGrainTable(path(), grainRows(world, start));
        return placeGrains(path(), readGrainTable(path()), shapes, world.settings().materials);
    }

    void refuses(const GrainRow& row, const std::string& found, const std::string& expected) const
    {
        std::vector<NamedShape> shapes{{"ball", Circle(1)}, {"egg", Ellipse(2, 1)}};
        const auto error = test::errorOf<SetupError>(
            [&] {
                placeGrains("some.csv", {{"ball"}, row}, shapes, {{"quartz", 1}, {"glass", 1}});
            });
        EXPECT_EQ(error.file(), "some.csv");
        EXPECT_EQ(error.entry(), "line 7");
        EXPECT_EQ(error.found(), found);
        EXPECT_EQ(error.expected(), expected);
        EXPECT_EQ(shapes.size(), 2u);
    }
};

/// Shapes of all kinds, each in a size of its own or in random ones, of two materials.
WorldSettings sizedScene(const SizeDistribution& distribution, std::uint64_t seed)
{
    WorldSettings settings = test::mixedScene(1, seed);
    settings.materials = {{"quartz", 2650}, {"glass", 2500}};
    LawTable<LinearLaw> laws(2);
    for (const std::size_t other : {0, 1})
    {
        laws.set(0, other, settings.linear());
        laws.set(1, other, settings.linear());
    }
    settings.contact = laws;
    const Composition composition{{{0, 1}, {1, 2}, {2, 1}, {3, 3}}, sizeClasses(distribution, 8)};
    const PlacementBox box{Vector2(0, 0), Vector2(0.6, 2)};
    RandomEngine engine(seed);
    const std::vector<int> shapeOfGrain = composeNumber(settings.shapes, composition, 60, engine);
    settings.grains = insertAtRandom(settings.shapes, shapeOfGrain, box, 0, engine);
    test::RandomSource random(seed);
    for (GrainState& grain : settings.grains)
    {
        grain.velocity = 0.3 * random.direction();
        grain.angularVelocity = random.uniform(-3, 3);
        grain.material = random.integer(0, 1);
    }
    return settings;
}

std::vector<Vector2> controlPoints(const Shape& shape)
{
    std::vector<Vector2> points;
    if (const auto* grain = std::get_if<PolyBezier>(&shape))
    {
        for (const CubicBezier& segment : grain->segments())
        {
            points.insert(points.end(), segment.controlPoints().begin(), segment.controlPoints().end());
        }
    }
    else if (const auto* polygon = std::get_if<ConvexPolygon>(&shape))
    {
        points = polygon->vertices();
    }
    else if (const auto* ellipse = std::get_if<Ellipse>(&shape))
    {
        points.emplace_back(ellipse->a(), ellipse->b());
    }
    else
    {
        points.emplace_back(std::get<Circle>(shape).radius(), 0);
    }
    return points;
}

} // namespace

TEST_F(WorldGrainTable, givesTheSameGrainsToTheBit)
{
    const std::vector<SizeDistribution> distributions{UniformRatio(0.3, 1.1),
                                                      LognormalSize(0.03, 0.4, 0.02, 0.07),
                                                      SieveCurve({0.01, 0.03, 0.06}, {0, 0.4, 1})};
    std::uint64_t seed = 1;
    for (const SizeDistribution& distribution : distributions)
    {
        const WorldSettings settings = sizedScene(distribution, seed);
        World world(settings);
        world.updateForces();
        for (int step = 0; step < 50; ++step)
        {
            ASSERT_EQ(world.step(1e-4), StepStatus::done);
        }
        // Beside other shapes this time, and without the sizes
        std::vector<NamedShape> shapes{{"other", Circle(1)}};
        const std::vector<NamedShape> originals = test::shapesOfEachKind(seed++);
        shapes.insert(shapes.end(), originals.rbegin(), originals.rend());
        const std::vector<GrainState> grains = throughFile(world, settings.grains, shapes);

        ASSERT_EQ(grains.size(), world.bodies().size());
        std::set<int> used;
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            used.insert(grains[i].shape);
            EXPECT_EQ(controlPoints(shapes[std::size_t(grains[i].shape)].shape),
                      controlPoints(world.shapeOf(i)));
            EXPECT_EQ(grains[i].position, world.bodies().pose[i].position);
            EXPECT_EQ(grains[i].angle, world.bodies().pose[i].rotation.angle());
            EXPECT_EQ(grains[i].velocity, world.bodies().velocity[i]);
            EXPECT_EQ(grains[i].angularVelocity, world.bodies().angularVelocity[i]);
            EXPECT_EQ(grains[i].material, settings.grains[i].material);
            EXPECT_FALSE(grains[i].driven);
        }
        EXPECT_EQ(used.size() + 5, shapes.size()) << "each size of a shape is kept once";

        // And once more, from the new world with its sizes
        WorldSettings again = settings;
        again.shapes = shapes;
        again.grains = grains;
        const std::string first = test::contentOf(path());
        throughFile(World(again), grains, shapes);
        EXPECT_EQ(used.size() + 5, shapes.size()) << "sizes that are there are found again";
        EXPECT_EQ(test::contentOf(path()), first);
    }
}

TEST_F(WorldGrainTable, keepsShapesOfTheirOwnSize)
{
    WorldSettings settings = test::mixedScene(20, 4);
    settings.materials[0].name = "quartz";
    settings.grains[3].driven = true;
    const World world(settings);
    std::vector<NamedShape> shapes = settings.shapes;
    const std::vector<GrainState> grains = throughFile(world, settings.grains, shapes);
    EXPECT_EQ(shapes.size(), settings.shapes.size());
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        EXPECT_EQ(grains[i].shape, settings.grains[i].shape);
        EXPECT_EQ(grains[i].driven, i == 3);
    }
    const std::vector<GrainRow> unsized{{"tile", std::nullopt, Vector2(1, 2)}};
    EXPECT_EQ(placeGrains("", unsized, shapes, settings.materials).front().shape, 2);
}

TEST_F(WorldGrainTable, tellsVelocitiesOnTopOfACellsFlow)
{
    WorldSettings settings = test::mixedScene(20, 4);
    settings.materials[0].name = "quartz";
    settings.walls.clear();
    Eigen::Matrix2d shear = Eigen::Matrix2d::Zero();
    shear(0, 1) = 3;
    settings.cell = StrainedCell(PeriodicCell(Vector2(0, 0), Vector2(0.6, 0), Vector2(0, 2)), shear);
    settings.grains[0].velocity = Vector2(0.5, 0.25);
    std::vector<NamedShape> shapes = settings.shapes;
    const std::vector<GrainState> grains = throughFile(World(settings), settings.grains, shapes);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        EXPECT_LT((grains[i].velocity - settings.grains[i].velocity).norm(), 1e-15 * 6);
    }
}

TEST_F(WorldGrainTable, refusesUnknownNamesByLine)
{
    GrainRow row{"disc"};
    row.line = 7;
    refuses(row, "the shape 'disc'", "one of ball, egg");
    row = {"ball", std::nullopt, Vector2(0, 0), 0, Vector2(0, 0), 0, "glas", false, 7};
    refuses(row, "the material 'glas'", "one of quartz, glass");
    row = {"ball", 1e-300};
    row.line = 7;
    refuses(row, "5e-301", "a radius > 0 [m], from 1e-60 to 1e+60");
}

TEST_F(WorldGrainTable, refusesShapesThatNoNameTells)
{
    const std::vector<Material> materials{{"quartz", 1}};
    const NamedShape ball{"ball", Circle(1)};
    EXPECT_NO_THROW(requireTableNames({ball, ofSize(ball, 1), ofSize(ball, 3)}, materials));
    const auto error = test::errorOf<ValueError>(
        [&] {
            requireTableNames({ball, {"ball", Circle(2)}}, materials);
        });
    EXPECT_EQ(error.found(), "two shapes ball");
    EXPECT_THROW(requireTableNames({{"a,b", Circle(1)}}, materials), ValueError);
    EXPECT_THROW(requireTableNames({ball}, {{"a#b", 1}}), ValueError);
    std::vector<NamedShape> shapes{ball, ball};
    EXPECT_THROW(placeGrains("", {{"ball"}}, shapes, materials), ValueError);
}
