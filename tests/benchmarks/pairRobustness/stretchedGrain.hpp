#pragma once

#include "core/shapes/shape.hpp"
#include "unit/randomGrain.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

/// Random shapes of a given bounding radius and stretch. An affine image of a convex polygon or polybezier is
/// one again, so that slivers are made by stretching round ones.
namespace chesil::benchmark
{

enum class ShapeType
{
    circle,
    ellipse,
    polygon,
    polyBezier,
};

constexpr int shapeTypes = 4;

inline const char* typeName(int type)
{
    static const char* const names[shapeTypes] = {Circle::typeName, Ellipse::typeName,
                                                  ConvexPolygon::typeName, PolyBezier::typeName};
    return names[type];
}

/// Scales a shape along one direction, and by `scale` all over.
struct Stretch
{
    Rotation<2> along;
    double ratio = 1;
    double scale = 1;

    Vector2 operator()(const Vector2& point) const
    {
        const Vector2 local = along.applyInverse(point);
        return scale * along.apply(Vector2(local.x(), local.y() / ratio));
    }

    CubicBezier operator()(const CubicBezier& segment) const
    {
        const auto& p = segment.controlPoints();
        return CubicBezier({(*this)(p[0]), (*this)(p[1]), (*this)(p[2]), (*this)(p[3])});
    }

    template <class Piece>
    std::vector<Piece> operator()(std::vector<Piece> pieces) const
    {
        for (Piece& piece : pieces)
        {
            piece = (*this)(piece);
        }
        return pieces;
    }
};

/// Joints on a wavy body, about half of them corners: there the segments leave and arrive between the tangent
/// and their chord.
inline std::vector<CubicBezier> segmentsWithCorners(int count, test::RandomSource& random)
{
    const std::vector<double> angles = test::randomNormalAngles(count, random);
    const test::WavyBody body(0.7, random);
    std::vector<Vector2> joints;
    std::vector<bool> corner;
    for (const double angle : angles)
    {
        joints.push_back(body.point(angle, 0));
        corner.push_back(random.uniform(0, 1) < 0.5);
    }
    std::vector<CubicBezier> segments;
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
        const std::size_t next = (i + 1) % joints.size();
        const Vector2 chord = joints[next] - joints[i];
        const double end = next == 0 ? angles[0] + 2 * M_PI : angles[next];
        double across = std::atan2(-chord.x(), chord.y());
        across += 2 * M_PI * std::round(((angles[i] + end) / 2 - across) / (2 * M_PI));
        const double leaving =
            corner[i] ? across + random.uniform(0.2, 0.9) * (angles[i] - across) : angles[i];
        const double arriving = corner[next] ? across + random.uniform(0.2, 0.9) * (end - across) : end;
        const double share0 = random.uniform(0.3, 0.8);
        const double share1 = random.uniform(0.3, 0.8);
        segments.push_back(test::tangentSegment(joints[i], leaving, joints[next], arriving, share0, share1));
    }
    return segments;
}

/// A circle's usual approximation, in arcs of random lengths: off by 1e-2..1e-9 of the radius.
inline std::vector<CubicBezier> nearlyCircularSegments(int count, test::RandomSource& random)
{
    const std::vector<double> angles = test::randomNormalAngles(count, random);
    const auto at = [](double angle) { return Vector2(std::cos(angle), std::sin(angle)); };
    std::vector<CubicBezier> segments;
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
        const std::size_t next = (i + 1) % angles.size();
        const double turn = angles[next] - angles[i] + (next == 0 ? 2 * M_PI : 0);
        const double share = 4.0 / 3 * std::tan(turn / 4) / std::tan(turn / 2);
        segments.push_back(
            test::tangentSegment(at(angles[i]), angles[i], at(angles[next]), angles[next], share, share));
    }
    return segments;
}

/// 3..20 segments: with corners, nearly circular, or smooth with straight and nearly straight ones.
inline std::vector<CubicBezier> anySegments(test::RandomSource& random)
{
    const int count = random.integer(3, 20);
    const double choice = random.uniform(0, 1);
    if (choice < 0.5)
    {
        return choice < 0.15 ? nearlyCircularSegments(count, random) : segmentsWithCorners(count, random);
    }
    test::RandomGrainOptions options;
    options.segments = count;
    const int edges = std::min(count / 2, count - 3);
    options.straight = random.integer(0, edges);
    options.nearlyStraight = random.integer(0, edges - options.straight);
    options.waviness = random.uniform(0, 0.9);
    return test::randomSegments(options, random);
}

inline Shape anyRoundPolygon(test::RandomSource& random)
{
    return test::randomPolygon(random.integer(3, 20), 1, random);
}

/// Stretched, then scaled to the bounding radius [m].
inline Shape stretchedPolygon(double radius, Stretch stretch, test::RandomSource& random)
{
    const std::vector<Vector2> round = std::get<ConvexPolygon>(anyRoundPolygon(random)).vertices();
    stretch.scale = radius / ConvexPolygon(stretch(round)).boundingRadius();
    return ConvexPolygon(stretch(round));
}

inline Shape stretchedPolyBezier(double radius, Stretch stretch, test::RandomSource& random)
{
    const std::vector<CubicBezier> round = PolyBezier(anySegments(random)).segments();
    stretch.scale = radius / PolyBezier(stretch(round)).boundingRadius();
    return PolyBezier(stretch(round));
}

inline Shape stretchedGrain(ShapeType type, double radius, double ratio, test::RandomSource& random)
{
    const Stretch stretch{Rotation<2>(random.uniform(-M_PI, M_PI)), ratio, 1};
    switch (type)
    {
    case ShapeType::circle:
        return Circle(radius);
    case ShapeType::ellipse:
        return random.uniform(0, 1) < 0.5 ? Ellipse(radius, radius / ratio) : Ellipse(radius / ratio, radius);
    case ShapeType::polygon:
        return stretchedPolygon(radius, stretch, random);
    case ShapeType::polyBezier:
        return stretchedPolyBezier(radius, stretch, random);
    }
    throw std::invalid_argument("stretchedGrain: no such type");
}

} // namespace chesil::benchmark
