#pragma once

#include "benchmarks/contactPeers/measurement.hpp"

#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>

#include <map>

/// Box2D: the manifold of two polygons of up to 8 sides, in float, without the skin that it gives them.
namespace chesil::benchmark
{

class Box2dPeer
{
public:
    explicit Box2dPeer(const PairSet<ConvexPolygon>& set) : transformsB_(set.posesB.size())
    {
        for (std::size_t i = 0; i < set.pairs.size(); ++i)
        {
            const Pair<ConvexPolygon>& pair = set.pairs[i];
            polygonsA_.push_back(polygon(pair.exactA));
            polygonsB_.push_back(polygon(pair.exactB));
            transformsA_.push_back(transform(pair.poseA));
            for (std::size_t step = 0; step < set.posesB.size(); ++step)
            {
                transformsB_[step].push_back(transform(set.posesB[step][i]));
            }
        }
    }

    /// The time is that of the manifold, whose points and normal are in the frame of one of the polygons.
    template <bool judged>
    Answer query(std::size_t step, std::size_t i, SearchStart&, int& calls) const
    {
        b2Manifold manifold;
        b2CollidePolygons(&manifold, polygonsA_[i], transformsA_[i], polygonsB_[i], transformsB_[step][i]);
        double depth = manifold.pointCount > 0 ? manifold.localPoint.x : 0.0F;
        if constexpr (judged)
        {
            calls -= 1; // it knows none
            b2WorldManifold world;
            world.Initialize(&manifold, transformsA_[i], 0, transformsB_[step][i], 0);
            depth = 0;
            for (int k = 0; k < manifold.pointCount; ++k)
            {
                depth = std::max(depth, -static_cast<double>(world.separations[k]));
            }
        }
        return {manifold.pointCount > 0, depth};
    }

private:
    const b2PolygonShape* polygon(const ConvexPolygon& shape)
    {
        const auto [place, isNew] = polygons_.try_emplace(&shape);
        b2PolygonShape& result = place->second;
        if (isNew)
        {
            std::vector<b2Vec2> vertices;
            for (const Vector2& vertex : shape.vertices())
            {
                vertices.emplace_back(static_cast<float>(vertex.x()), static_cast<float>(vertex.y()));
            }
            result.Set(vertices.data(), static_cast<int>(vertices.size()));
            result.m_radius = 0;
        }
        return &result;
    }

    static b2Transform transform(const Pose<2>& pose)
    {
        return b2Transform(
            b2Vec2(static_cast<float>(pose.position.x()), static_cast<float>(pose.position.y())),
            b2Rot(static_cast<float>(pose.rotation.angle())));
    }

    std::map<const ConvexPolygon*, b2PolygonShape> polygons_;
    std::vector<const b2PolygonShape*> polygonsA_;
    std::vector<const b2PolygonShape*> polygonsB_;
    std::vector<b2Transform> transformsA_;
    std::vector<std::vector<b2Transform>> transformsB_;
};

} // namespace chesil::benchmark
