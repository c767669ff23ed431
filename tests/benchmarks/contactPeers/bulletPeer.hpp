#pragma once

#include "benchmarks/contactPeers/measurement.hpp"
#include "benchmarks/contactPeers/prism.hpp"

#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

#include <deque>

/// Bullet in double precision: btGjkEpaSolver2, without margins. Its tolerances are compiled in.
namespace chesil::benchmark
{

template <class ShapeType>
class BulletPrism : public btConvexInternalShape
{
public:
    BulletPrism(const ShapeType& shape, const PrismHeight& height) : shape_(shape), height_(height)
    {
        m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
        m_collisionMargin = 0;
    }

    btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override
    {
        ++calls;
        const Vector2 plane = planeSupport(shape_, direction.x(), direction.y());
        return btVector3(plane.x(), plane.y(), height_.along(direction.z()));
    }

    void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* points,
                                                           int count) const override
    {
        for (int i = 0; i < count; ++i)
        {
            points[i] = localGetSupportingVertexWithoutMargin(directions[i]);
        }
    }

    void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
    const char* getName() const override { return "prism"; }

    /// One addition a call, counted always: the class is virtual anyway.
    mutable int calls = 0;

private:
    const ShapeType& shape_;
    PrismHeight height_;
};

template <class ShapeType>
class BulletPeer
{
public:
    explicit BulletPeer(const PairSet<ShapeType>& set) : posesB_(set.posesB.size())
    {
        for (std::size_t i = 0; i < set.pairs.size(); ++i)
        {
            const Pair<ShapeType>& pair = set.pairs[i];
            prismsA_.emplace_back(pair.exactA, heightOfA(pair.size(), SidewaysSupport::upperRim));
            prismsB_.emplace_back(pair.exactB, PrismHeight());
            posesA_.push_back(transform(pair.poseA));
            for (std::size_t step = 0; step < set.posesB.size(); ++step)
            {
                posesB_[step].push_back(transform(set.posesB[step][i]));
            }
        }
    }

    template <bool judged>
    Answer query(std::size_t step, std::size_t i, SearchStart&, int& calls) const
    {
        const BulletPrism<ShapeType>& a = prismsA_[i];
        const btTransform& poseA = posesA_[i];
        const btTransform& poseB = posesB_[step][i];
        const int callsBefore = a.calls;
        btGjkEpaSolver2::sResults results;
        // First along the line of centres, as Bullet's own btGjkEpaPenetrationDepthSolver
        const bool overlap = btGjkEpaSolver2::Penetration(
            &a, poseA, &prismsB_[i], poseB, poseA.getOrigin() - poseB.getOrigin(), results, false);
        calls += a.calls - callsBefore;
        return {overlap, -results.distance};
    }

private:
    static btTransform transform(const Pose<2>& pose)
    {
        return btTransform(btQuaternion(btVector3(0, 0, 1), pose.rotation.angle()),
                           btVector3(pose.position.x(), pose.position.y(), 0));
    }

    std::deque<BulletPrism<ShapeType>> prismsA_;
    std::deque<BulletPrism<ShapeType>> prismsB_;
    std::vector<btTransform> posesA_;
    std::vector<std::vector<btTransform>> posesB_;
};

} // namespace chesil::benchmark
