#pragma once

#include "benchmarks/contactPeers/measurement.hpp"
#include "benchmarks/contactPeers/prism.hpp"

#include <ccd/ccd.h>

/// libccd: GJK with EPA, and MPR. Its tolerances are absolute: of lengths in MPR, of squared lengths in EPA.
namespace chesil::benchmark
{

enum class LibccdAlgorithm
{
    gjkEpa,
    mpr,
};

template <class ShapeType>
struct LibccdBody
{
    const ShapeType* shape;
    Pose<2> pose;
    PrismHeight height;
    mutable Vector2 lookFirst = Vector2::Zero();
    mutable int calls = 0;
};

/// The bodies of all pairs, shared by the methods.
template <class ShapeType>
struct LibccdBodies
{
    std::vector<LibccdBody<ShapeType>> a;
    /// b[s][i] after s moves.
    std::vector<std::vector<LibccdBody<ShapeType>>> b;

    LibccdBodies(const PairSet<ShapeType>& set, SidewaysSupport sideways) : b(set.posesB.size())
    {
        for (std::size_t i = 0; i < set.pairs.size(); ++i)
        {
            const Pair<ShapeType>& pair = set.pairs[i];
            a.push_back({&pair.exactA, pair.poseA, heightOfA(pair.size(), sideways)});
            for (std::size_t step = 0; step < b.size(); ++step)
            {
                b[step].push_back({&pair.exactB, set.posesB[step][i], PrismHeight()});
            }
        }
    }
};

template <class ShapeType>
class LibccdPeer
{
public:
    using Bodies = LibccdBodies<ShapeType>;

    LibccdPeer(std::shared_ptr<const Bodies> bodies, LibccdAlgorithm algorithm, double tolerance)
        : bodies_(std::move(bodies)), algorithm_(algorithm)
    {
        CCD_INIT(&settings_);
        settings_.max_iterations = 100; // as in libccd's own example; its default is no limit
        settings_.epa_tolerance = tolerance;
        settings_.mpr_tolerance = tolerance;
        settings_.first_dir = lookFirst;
        settings_.center1 = centre;
        settings_.center2 = centre;
        settings_.support1 = support<false>;
        settings_.support2 = support<false>;
        counting_ = settings_;
        counting_.support1 = support<true>;
    }

    template <bool judged>
    Answer query(std::size_t step, std::size_t i, SearchStart& start, int& calls) const
    {
        const Body& a = bodies_->a[i];
        const Body& b = bodies_->b[step][i];
        const ccd_t& settings = judged ? counting_ : settings_;
        a.lookFirst = start.direction != Vector2::Zero() ? start.direction : Vector2(b.pose.position - a.pose.position);
        a.calls = 0;
        double depth = 0;
        ccd_vec3_t normal{};
        ccd_vec3_t point{};
        const int status = algorithm_ == LibccdAlgorithm::gjkEpa
                               ? ccdGJKPenetration(&a, &b, &settings, &depth, &normal, &point)
                               : ccdMPRPenetration(&a, &b, &settings, &depth, &normal, &point);
        calls += a.calls;
        if (status == 0)
        {
            start.direction = Vector2(normal.v[0], normal.v[1]);
        }
        return {status == 0, depth};
    }

private:
    using Body = LibccdBody<ShapeType>;

    template <bool counting>
    static void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point)
    {
        const Body& body = *static_cast<const Body*>(object);
        const Vector2 local = body.pose.rotation.applyInverse(Vector2(direction->v[0], direction->v[1]));
        const Vector2 plane = body.pose.toWorld(planeSupport(*body.shape, local.x(), local.y()));
        ccdVec3Set(point, plane.x(), plane.y(), body.height.along(direction->v[2]));
        if constexpr (counting)
        {
            ++body.calls;
        }
    }

    static void centre(const void* object, ccd_vec3_t* point)
    {
        const Body& body = *static_cast<const Body*>(object);
        ccdVec3Set(point, body.pose.position.x(), body.pose.position.y(), 0);
    }

    static void lookFirst(const void* a, const void*, ccd_vec3_t* direction)
    {
        const Body& body = *static_cast<const Body*>(a);
        ccdVec3Set(direction, body.lookFirst.x(), body.lookFirst.y(), 0);
    }

    std::shared_ptr<const Bodies> bodies_;
    LibccdAlgorithm algorithm_;
    ccd_t settings_;
    ccd_t counting_;
};

} // namespace chesil::benchmark
