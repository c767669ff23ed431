#pragma once

#include "benchmarks/pairRobustness/judge.hpp"

#include <cstdio>

/// Pairs in numbers that a unit test can take over to the bit.
namespace chesil::benchmark
{

inline void print(const Vector2& point) { std::printf("Vector2(%a, %a)", point.x(), point.y()); }

inline void print(const Circle& circle) { std::printf("Circle(%a)", circle.radius()); }

inline void print(const Ellipse& ellipse) { std::printf("Ellipse(%a, %a)", ellipse.a(), ellipse.b()); }

inline void print(const CubicBezier& segment);

template <class Points>
void printAll(const Points& points)
{
    const char* separator = "{";
    for (const auto& point : points)
    {
        std::printf("%s", separator);
        print(point);
        separator = ", ";
    }
    std::printf("}");
}

inline void print(const ConvexPolygon& polygon)
{
    std::printf("ConvexPolygon(");
    printAll(polygon.vertices());
    std::printf(")");
}

inline void print(const CubicBezier& segment)
{
    std::printf("\n            CubicBezier({");
    printAll(segment.controlPoints());
    std::printf("})");
}

inline void print(const PolyBezier& grain)
{
    std::printf("PolyBezier(");
    printAll(grain.segments());
    std::printf(")");
}

inline void print(const char* name, const Pose<2>& pose)
{
    std::printf("        %s: {", name);
    print(pose.position);
    std::printf(", Rotation<2>(%a)}\n", pose.rotation.angle());
}

inline std::string statusName(PairStatus status)
{
    return status == PairStatus::separated     ? "separated"
           : status == PairStatus::overlapping ? "overlapping"
                                               : "status " + std::to_string(static_cast<int>(status));
}

inline void print(const char* name, const RandomPair& pair, const Pose<2>& poseB, const Answer& answer)
{
    const Judgement judgement = judge(pair, poseB, answer);
    std::printf("        %s: %s, depth %a, normal (%a, %a), direction (%a, %a)\n", name,
                statusName(answer.status).c_str(), answer.overlaps() ? answer.contact.depth : 0.0,
                answer.contact.normal.x(), answer.contact.normal.y(), answer.start.direction.x(),
                answer.start.direction.y());
    std::printf("            reference %La after %d supports; error %.3g of the larger size, %.3g of the "
                "bound; normal "
                "%.3g of the bound%s%s%s%s%s\n",
                judgement.depth, judgement.supports, judgement.error / pair.larger(),
                judgement.error / roundingBound(pair), judgement.normalError / roundingBound(pair),
                judgement.failure ? ", FAILURE" : "", judgement.wrongVerdict ? ", WRONG" : "",
                judgement.flawed ? ", flawed" : "", judgement.misdirected ? ", misdirected" : "",
                judgement.unsettled ? ", reference unsettled" : "");
}

/// Asks anew, cold and then warm. `shapes` prints these too, which may be a hundred lines.
inline void print(const Stratum& stratum, std::int64_t index, const RandomPair& pair, bool shapes)
{
    std::printf("    pair %lld: %s %s, %s; sizes %a and %a\n", static_cast<long long>(index),
                situationName(static_cast<int>(stratum.situation)), stratum.types().c_str(),
                stratum.wellScaled ? "well-scaled" : "wide", pair.a->size, pair.b->size);
    if (shapes)
    {
        std::printf("        a: ");
        std::visit([](const auto& shape) { print(shape); }, pair.a->shape);
        std::printf("\n        b: ");
        std::visit([](const auto& shape) { print(shape); }, pair.b->shape);
        std::printf("\n");
    }
    print("pose of a", pair.poseA);
    print("pose of b", pair.poseB);
    print("later b", pair.laterB);
    Answer answer;
    ask(pair, pair.poseB, answer);
    print("cold", pair, pair.poseB, answer);
    ask(pair, pair.laterB, answer);
    print("warm", pair, pair.laterB, answer);
}

} // namespace chesil::benchmark
