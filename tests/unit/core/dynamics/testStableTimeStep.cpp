#include "core/dynamics/stableTimeStep.hpp"

#include "core/base/vector.hpp"
#include "core/dynamics/localDamping.hpp"
#include "core/dynamics/velocityVerlet.hpp"
#include "unit/randomGrain.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

using namespace chesil;

namespace
{

struct Disk
{
    Vector2 centre;
    double radius;

    double mass() const { return 2650 * M_PI * radius * radius; }
    double inertia() const { return mass() * radius * radius / 2; }
};

/// Disks in contact, each contact with a normal and a tangential spring and dashpot, linearised.
class Cluster
{
public:
    Cluster(const std::vector<Disk>& disks, double normalStiffness, double tangentialStiffness,
            double dampingRatio)
        : disks_(disks), stiffness_(Eigen::MatrixXd::Zero(unknowns(), unknowns())),
          damping_(Eigen::MatrixXd::Zero(unknowns(), unknowns())), inverseMass_(unknowns())
    {
        for (std::size_t i = 0; i < disks.size(); ++i)
        {
            const auto row = 3 * static_cast<Eigen::Index>(i);
            inverseMass_[row] = inverseMass_[row + 1] = 1 / disks[i].mass();
            inverseMass_[row + 2] = 1 / disks[i].inertia();
            bound_.add(disks[i].mass(), disks[i].inertia(), disks[i].radius, 1);
            for (std::size_t j = i + 1; j < disks.size(); ++j)
            {
                const Vector2 offset = disks[j].centre - disks[i].centre;
                const double reach = disks[i].radius + disks[j].radius;
                if (offset.norm() < reach * (1 + 1e-9))
                {
                    const Vector2 normal = offset.normalized();
                    const double effectiveMass = 1 / (1 / disks[i].mass() + 1 / disks[j].mass());
                    add(i, j, normal, normalStiffness, dampingRatio, effectiveMass, normal);
                    add(i, j, normal, tangentialStiffness, dampingRatio, effectiveMass,
                        perpendicular(normal));
                    ++contacts_;
                }
            }
        }
        largestStiffness_ = std::max(normalStiffness, tangentialStiffness);
        dampingRatio_ = dampingRatio;
    }

    int contacts() const { return contacts_; }

    /// The bound to be tested [s].
    double stableStep() const { return bound_.of(dampingRatio_, 0) / std::sqrt(largestStiffness_); }

    /// Largest eigenvalue of K v = w^2 M v [1/s2].
    double largestSquaredFrequency() const
    {
        const Eigen::VectorXd root = inverseMass_.cwiseSqrt();
        const Eigen::MatrixXd scaled = root.asDiagonal() * stiffness_ * root.asDiagonal();
        return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
            .eigenvalues()
            .maxCoeff();
    }

    /// Largest modulus of the eigenvalues of one step, x' = x + h u, u' = u - h M^-1 (K x' + C u).
    double growthOfAStep(double timeStep) const
    {
        const Eigen::Index n = unknowns();
        const Eigen::MatrixXd k = inverseMass_.asDiagonal() * stiffness_;
        const Eigen::MatrixXd c = inverseMass_.asDiagonal() * damping_;
        const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(n, n);
        // The velocity times the step, so that all entries are of one size.
        Eigen::MatrixXd step(2 * n, 2 * n);
        step.topLeftCorner(n, n) = one;
        step.topRightCorner(n, n) = one;
        step.bottomLeftCorner(n, n) = -timeStep * timeStep * k;
        step.bottomRightCorner(n, n) = one - timeStep * timeStep * k - timeStep * c;
        return Eigen::EigenSolver<Eigen::MatrixXd>(step, false).eigenvalues().cwiseAbs().maxCoeff();
    }

private:
    Eigen::Index unknowns() const { return 3 * static_cast<Eigen::Index>(disks_.size()); }

    void add(std::size_t i, std::size_t j, const Vector2& normal, double k, double ratio,
             double effectiveMass, const Vector2& along)
    {
        // Relative velocity of the contact point along a direction, as a row that multiplies (v, w) of all.
        Eigen::VectorXd row = Eigen::VectorXd::Zero(unknowns());
        const auto enter = [&](std::size_t disk, double sign, const Vector2& arm)
        {
            const auto first = 3 * static_cast<Eigen::Index>(disk);
            row[first] = sign * along.x();
            row[first + 1] = sign * along.y();
            row[first + 2] = sign * cross(arm, along);
        };
        enter(i, 1, disks_[i].radius * normal);
        enter(j, -1, -disks_[j].radius * normal);
        stiffness_ += k * row * row.transpose();
        damping_ += 2 * ratio * std::sqrt(k * effectiveMass) * row * row.transpose();
    }

    std::vector<Disk> disks_;
    Eigen::MatrixXd stiffness_;
    Eigen::MatrixXd damping_;
    Eigen::VectorXd inverseMass_;
    StableTimeStep bound_;
    double largestStiffness_ = 0;
    double dampingRatio_ = 0;
    int contacts_ = 0;
};

/// A disk with `rings` rings of equal ones around it: 7, 19, 37 disks.
std::vector<Disk> hexagon(int rings, double radius)
{
    std::vector<Disk> disks;
    for (int i = -rings; i <= rings; ++i)
    {
        for (int j = -rings; j <= rings; ++j)
        {
            if (std::abs(i + j) <= rings)
            {
                disks.push_back({2 * radius * Vector2(i + 0.5 * j, std::sqrt(0.75) * j), radius});
            }
        }
    }
    return disks;
}

/// One disk with as many smaller ones around it as have room.
std::vector<Disk> flower(double ratio)
{
    std::vector<Disk> disks{{Vector2::Zero(), 1}};
    const int petals = static_cast<int>(M_PI / std::asin(ratio / (1 + ratio)));
    for (int i = 0; i < petals; ++i)
    {
        const double angle = 2 * M_PI * i / petals;
        disks.push_back({(1 + ratio) * Vector2(std::cos(angle), std::sin(angle)), ratio});
    }
    return disks;
}

/// Disks put one by one against two that are there already, where that overlaps none.
std::vector<Disk> randomCluster(int number, test::RandomSource& random)
{
    const double first = random.uniform(0.3, 1);
    const double second = random.uniform(0.3, 1);
    std::vector<Disk> disks{{Vector2::Zero(), first}, {Vector2(first + second, 0), second}};
    for (int trial = 0; trial < 1000 && static_cast<int>(disks.size()) < number; ++trial)
    {
        const int last = static_cast<int>(disks.size()) - 1;
        const Disk& a = disks[static_cast<std::size_t>(random.integer(0, last))];
        const Disk& b = disks[static_cast<std::size_t>(random.integer(0, last))];
        const double radius = random.uniform(0.3, 1);
        const Vector2 base = b.centre - a.centre;
        const double toA = a.radius + radius;
        const double toB = b.radius + radius;
        const double along = (base.squaredNorm() + toA * toA - toB * toB) / (2 * base.norm());
        if (base.norm() == 0 || std::abs(along) >= toA)
        {
            continue;
        }
        const Vector2 unit = base.normalized();
        const Vector2 centre =
            a.centre + along * unit + std::sqrt(toA * toA - along * along) * perpendicular(unit);
        const auto overlaps = [&](const Disk& disk)
        { return (disk.centre - centre).norm() < (disk.radius + radius) * (1 - 1e-12); };
        if (std::none_of(disks.begin(), disks.end(), overlaps))
        {
            disks.push_back({centre, radius});
        }
    }
    return disks;
}

void expectStable(const std::vector<Disk>& disks, int contacts)
{
    for (const double tangential : {0.0, 0.3e7, 1e7, 2e7})
    {
        const Cluster undamped(disks, 1e7, tangential, 0);
        EXPECT_GE(undamped.contacts(), contacts);
        EXPECT_LE(undamped.largestSquaredFrequency(), std::pow(2 / undamped.stableStep(), 2) * (1 + 1e-12));
        for (const double ratio : {0.05, 0.3, 1.0})
        {
            const Cluster damped(disks, 1e7, tangential, ratio);
            EXPECT_LE(damped.growthOfAStep(damped.stableStep()), 1 + 1e-6)
                << "ratio " << ratio << " kt " << tangential;
        }
    }
}

} // namespace

TEST(StableTimeStep, holdsForHexagonsOfDisks)
{
    expectStable(hexagon(1, 0.02), 12);
    expectStable(hexagon(2, 0.02), 42);
    expectStable(hexagon(3, 0.02), 90);
}

TEST(StableTimeStep, holdsForADiskAmongSmallerAndLargerOnes)
{
    for (const double ratio : {0.1, 0.3, 1.0, 3.0})
    {
        expectStable(flower(ratio), static_cast<int>(flower(ratio).size()) - 1);
    }
}

TEST(StableTimeStep, holdsForRandomClusters)
{
    test::RandomSource random(121);
    for (int i = 0; i < 10; ++i)
    {
        expectStable(randomCluster(12, random), 20);
    }
}

TEST(StableTimeStep, isNotManyTimesTooSmall)
{
    for (const double ratio : {0.0, 0.3})
    {
        const Cluster cluster(hexagon(3, 0.02), 1e7, 1e7, ratio);
        EXPECT_GT(cluster.growthOfAStep(2 * cluster.stableStep()), 1.1) << "damping ratio " << ratio;
    }
}

TEST(StableTimeStep, localDampingMakesBrakingForcesStiffer)
{
    // One body on a spring under local damping, just below and above 2/(w sqrt(1 + share)).
    const double share = 0.7;
    const auto largestAfter = [&](double timeStep)
    {
        Bodies<2> bodies;
        bodies.pose = {{Vector2(1, 0), {}}};
        bodies.velocity = {Vector2(-2 / timeStep, 0)};
        bodies.angularVelocity = {0};
        bodies.inverseMass = {1};
        bodies.inverseInertia = {1};
        bodies.force = {Vector2::Zero()};
        bodies.torque = {0};
        for (int i = 0; i < 500; ++i)
        {
            kick(bodies, timeStep / 2);
            drift(bodies, timeStep);
            bodies.force[0] = -bodies.pose[0].position;
            dampLocally(bodies, share, [](std::size_t) { return Vector2(0, 0); });
            kick(bodies, timeStep / 2);
        }
        return bodies.pose[0].position.norm();
    };
    const double limit = 2 / std::sqrt(1 + share);
    EXPECT_LT(largestAfter(0.98 * limit), 1);
    EXPECT_GT(largestAfter(1.02 * limit), 1e6);

    StableTimeStep bound;
    bound.add(1, 1, 1, 1);
    EXPECT_DOUBLE_EQ(bound.of(0, share), bound.of(0, 0) / std::sqrt(1 + share));
}

TEST(StableTimeStep, isInfiniteWithoutGrains)
{
    EXPECT_EQ(StableTimeStep().of(0.3, 0.7), std::numeric_limits<double>::infinity());
}
