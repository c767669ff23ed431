/// The contact of two grains by Chesil's kernel and by libccd, Bullet and Box2D, on the same pairs in one
/// run.

#include "benchmarks/contactPeers/bars.hpp"
#include "benchmarks/contactPeers/box2dPeer.hpp"
#include "benchmarks/contactPeers/bulletPeer.hpp"
#include "benchmarks/contactPeers/chesilMethods.hpp"
#include "benchmarks/contactPeers/libccdPeer.hpp"

#include <type_traits>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr std::uint64_t seed = 20261122;
constexpr int grainCount = 60;
constexpr int pairCount = 2000;
constexpr int rounds = 9;

template <class ShapeType>
std::vector<Row> contest(const std::string& shape, const std::vector<Shape>& grains, Situation situation)
{
    const PairSet<ShapeType> set = makePairs<ShapeType>(grains, situation, pairCount, seed);
    Contest<ShapeType> methods(shape, set);

    const auto kernel = std::make_shared<ChesilKernel<ShapeType>>(set);
    methods.add("Chesil", "cold", kernel, Start::cold);
    methods.add("Chesil", "warm", kernel, Start::warm);
    for (int exponent = 3; exponent <= 14; ++exponent)
    {
        const auto expansion = std::make_shared<PlainExpansion<ShapeType>>(set, std::pow(10.0, -exponent));
        methods.add("GJK and EPA", text("1e-%d", exponent), expansion, Start::cold);
    }

    using Libccd = LibccdPeer<ShapeType>;
    using Bodies = LibccdBodies<ShapeType>;
    const auto bodies = std::make_shared<const Bodies>(set, SidewaysSupport::upperRim);
    for (int exponent = 2; exponent <= 10; ++exponent)
    {
        const auto libccd =
            std::make_shared<Libccd>(bodies, LibccdAlgorithm::gjkEpa, std::pow(10.0, -exponent));
        methods.add("libccd", text("1e-%d", exponent), libccd, Start::cold);
    }
    const auto libccd = std::make_shared<Libccd>(bodies, LibccdAlgorithm::gjkEpa, 1e-8);
    methods.add("libccd warm", "1e-8", libccd, Start::warm);
    methods.add("libccd moves", "1e-8", std::make_shared<ForgetDirection<Libccd>>(libccd), Start::warm);
    methods.add("libccd MPR", "1e-8", std::make_shared<Libccd>(bodies, LibccdAlgorithm::mpr, 1e-8),
                Start::cold);
    const auto inOnePlane = std::make_shared<const Bodies>(set, SidewaysSupport::middle);
    methods.add("libccd in one plane", "1e-8",
                std::make_shared<Libccd>(inOnePlane, LibccdAlgorithm::gjkEpa, 1e-8), Start::cold);
    methods.add("Bullet double", "built in", std::make_shared<BulletPeer<ShapeType>>(set), Start::cold);

    if constexpr (std::is_same_v<ShapeType, ConvexPolygon>)
    {
        const auto box2d = std::make_shared<Box2dPeer>(set);
        methods.add("Box2D manifold", "cold", box2d, Start::cold);
        methods.add("Box2D manifold", "warm", box2d, Start::warm);
    }

    const std::vector<Row> rows = methods.run(rounds);
    std::for_each(rows.begin(), rows.end(), print);
    return rows;
}

/// The picture of one kind of shapes: the shallow contacts.
Results pictureOf(const std::string& shape, const std::vector<Row>& rows)
{
    Results results;
    results.comments = {
        {"title", "Shallow contacts of " + shape + " pairs by Chesil and its peers"},
        {"error", "largest error of the depth over the pair's size [-]"},
        {"time", "time of a query [ns]"},
        {"knob", "tolerance of the depth (libccd's EPA: of its square)"},
        {"pairs", text("%d, depth 1e-6..1e-2 of the size, the sum of both bounding radii", pairCount)},
        {"reference", "minimum over all directions, in long double"},
        {"clock", text("CPU time, median of %d rounds", rounds)},
        {"seed", std::to_string(seed)},
    };
    for (const Row& row : rows)
    {
        const bool drawn = row.method != "libccd warm" && row.method != "libccd moves" &&
                           row.method != "libccd in one plane";
        if (drawn && row.shape == shape && row.situation == Situation::shallow)
        {
            results.measurements.push_back({row.method, row.knob, row.worstError, row.time});
        }
    }
    return results;
}

Results measure()
{
    std::printf("    seed %llu, %d pairs a set out of %d grains of mean radius 1: 10 segments; aspect 1..3; "
                "4-7 sides\n",
                static_cast<unsigned long long>(seed), pairCount, grainCount);
    std::printf("    errors over the size, the sum of both bounding radii; far: above %g; %d rounds\n",
                farOff, rounds);

    test::RandomSource random(seed);
    std::vector<Shape> grains;
    std::vector<Shape> ellipses;
    std::vector<Shape> polygons;
    for (int i = 0; i < grainCount; ++i)
    {
        grains.emplace_back(test::randomPolyBezier(test::RandomGrainOptions(), random));
        const double root = std::sqrt(random.uniform(1, 3));
        ellipses.emplace_back(Ellipse(root, 1 / root));
        polygons.emplace_back(test::randomPolygon(random.integer(4, 7), 1, random));
    }

    std::vector<Row> rows;
    const auto gather = [&](const std::vector<Row>& more)
    { rows.insert(rows.end(), more.begin(), more.end()); };
    printHeader();
    for (const Situation situation : {Situation::separate, Situation::shallow, Situation::deep})
    {
        gather(contest<PolyBezier>("polybezier", grains, situation));
        gather(contest<Ellipse>("ellipse", ellipses, situation));
        gather(contest<ConvexPolygon>("polygon", polygons, situation));
    }
    handSpeedups(rows);
    handPolygons(rows);
    handCalls(rows);

    Results results = pictureOf("polybezier", rows);
    results.beside = {pictureOf("ellipse", rows), pictureOf("polygon", rows)};
    results.beside[0].suffix = "Ellipse";
    results.beside[1].suffix = "Polygon";
    return results;
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
