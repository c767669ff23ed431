#include "coupling/forcing/grainForcing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace chesil
{

namespace
{

/// Square cells of width 1 covering [0, n] x [0, n].
CellView squareMesh(int n)
{
    std::vector<int> offsets{0};
    std::vector<Vector2> vertices;
    for (int row = 0; row < n; ++row)
    {
        for (int column = 0; column < n; ++column)
        {
            for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            {
                vertices.emplace_back(column + dx, row + dy);
            }
            offsets.push_back(static_cast<int>(vertices.size()));
        }
    }
    return CellView(offsets, vertices);
}

WorldSettings disks(double radius, const std::vector<GrainState>& grains)
{
    WorldSettings settings;
    settings.shapes.push_back({"disk", Circle(radius)});
    settings.grains = grains;
    settings.materials[0].density = 2;
    settings.linear().normalStiffness = 1;
    return settings;
}

GrainState moving(double x, double y, const Vector2& velocity, double angularVelocity = 0)
{
    GrainState grain;
    grain.position = Vector2(x, y);
    grain.velocity = velocity;
    grain.angularVelocity = angularVelocity;
    return grain;
}

const auto viscosity = [](int) { return 0.1; };

/// A fluid that is nowhere the same.
Vector2 someVelocity(int cell)
{
    return Vector2(std::sin(1.0 + cell), std::cos(3.0 * cell));
}

/// Force that the source puts into the fluid.
Vector2 forceOnFluid(const GrainForcing& forcing, const CellView& mesh, double density)
{
    Vector2 sum = Vector2::Zero();
    for (const int cell : forcing.touched())
    {
        sum += density * forcing.rate(cell) * mesh.area(cell) * (forcing.velocity(cell) - someVelocity(cell));
    }
    return sum;
}

} // namespace

TEST(GrainForcing, whatTheFluidGetsTheGrainsLose)
{
    const CellView mesh = squareMesh(12);
    const World world(disks(2.1, {moving(3.3, 3.4, {1, 2}, 0.7), moving(7.4, 3.6, {-1, 0.5}, -2)}));
    GrainForcing forcing(world, mesh, PenaltyRate());
    forcing.updateGeometry(world);
    forcing.updateRates(someVelocity, viscosity);

    GrainLoads loads(2);
    forcing.addLoads(someVelocity, 1000, loads);
    const Vector2 onFluid = forceOnFluid(forcing, mesh, 1000);
    // Sums of some tens of terms in another order.
    EXPECT_LT((loads.force[0] + loads.force[1] + onFluid).norm(), 1e-12 * loads.force[0].norm());
}

TEST(GrainForcing, velocityIsThatOfTheRigidBody)
{
    const CellView mesh = squareMesh(8);
    const World world(disks(3, {moving(4, 4, {1, -2}, 0.5)}));
    GrainForcing forcing(world, mesh, PenaltyRate());
    forcing.updateGeometry(world);
    // Cell 3 + 8*5 is all solid: centre (3.5, 5.5), arm (-0.5, 1.5).
    EXPECT_EQ(forcing.fraction(43), 1);
    EXPECT_LT((forcing.velocity(43) - Vector2(1 - 0.5 * 1.5, -2 - 0.5 * 0.5)).norm(), 1e-14);
}

TEST(GrainForcing, torqueOfAFluidThatTurnsAgainstTheGrain)
{
    const CellView mesh = squareMesh(8);
    const World world(disks(3, {moving(4, 4, Vector2::Zero())}));
    GrainForcing forcing(world, mesh, PenaltyRate());
    forcing.updateGeometry(world);
    const auto turning = [&](int cell) -> Vector2 { return velocityAt(1.0, mesh.centre(cell) - Vector2(4, 4)); };
    forcing.updateRates(turning, viscosity);
    GrainLoads loads(1);
    forcing.addLoads(turning, 1, loads);
    EXPECT_GT(loads.torque[0], 1);
    EXPECT_LT(loads.force[0].norm(), 1e-12 * loads.torque[0]);
}

TEST(GrainForcing, grainsThatLeaveACellAreForgotten)
{
    const CellView mesh = squareMesh(12);
    World world(disks(1.5, {moving(3, 3, {6, 6})}));
    GrainForcing forcing(world, mesh, PenaltyRate());
    forcing.updateGeometry(world);
    world.step(1);
    forcing.updateGeometry(world);
    double area = 0;
    for (int cell = 0; cell < mesh.size(); ++cell)
    {
        area += forcing.fraction(cell) * mesh.area(cell);
    }
    EXPECT_NEAR(area, world.areaOf(0), 1e-12 * area);
    EXPECT_EQ(forcing.fraction(3 + 12 * 3), 0);
}

TEST(GrainForcing, grainsInOneCellFeelNoForceFromEachOther)
{
    // Opposite velocities in shared cells, fluid at the blend's velocity: no dashpot between the two.
    const CellView mesh = squareMesh(2);
    const World world(disks(0.2, {moving(0.3, 0.5, {1, 0}), moving(0.7, 0.5, {-1, 0})}));
    GrainForcing forcing(world, mesh, PenaltyRate());
    forcing.updateGeometry(world);
    const auto still = [](int) { return Vector2(0, 0); };
    forcing.updateRates(still, viscosity);
    GrainLoads loads(2);
    forcing.addLoads(still, 1, loads);
    EXPECT_LT(loads.force[0].norm(), 1e-14);
    EXPECT_LT(loads.force[1].norm(), 1e-14);
}

TEST(PenaltyRate, doesNotPassItsLimitWhereGrainsOverlap)
{
    const PenaltyRate rate;
    EXPECT_EQ(rate(1.3, 0.1, 1, 0), rate(1, 0.1, 1, 0));
    EXPECT_EQ(rate(0, 0.1, 1, 0), 0);
    EXPECT_GT(rate(1, 0.1, 1, 0), 1e4 * rate(0.5, 0.1, 1, 0));
}

} // namespace chesil
