/// How well polybezier grains and polygons of ever more pieces render smooth irregular grains, and what a
/// contact between them costs.

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/common/overlappingPoses.hpp"
#include "benchmarks/shapeSegments/wavyReference.hpp"
#include "core/world/pairContact.hpp"
#include "generate/fit/smoothOutline.hpp"

#include <cstdint>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr std::uint64_t seed = 20240612;
constexpr int grainCount = 40;
constexpr int pairCount = 2000;
constexpr int rounds = 25;
/// Sides of the polygon that fitSmoothOutline gets; it has the grain's area and leaves it by 3e-6 of the
/// radius.
constexpr int fitSides = 1440;

struct Pair
{
    const Shape& a;
    const Shape& b;
    OverlappingPoses poses;
};

/// All grains in one representation.
struct Representation
{
    std::string method;
    int pieces = 0;
    double error = 0;
    std::vector<Shape> shapes;
    std::vector<Pair> pairs;
};

std::vector<CubicBezier> edges(const std::vector<Vector2>& vertices)
{
    std::vector<CubicBezier> result;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        result.push_back(CubicBezier::straight(vertices[i], vertices[(i + 1) % vertices.size()]));
    }
    return result;
}

template <class ShapeType, class Approximate, class OutlineOf>
Representation represent(const char* method, int pieces, const std::vector<WavyReference>& references,
                         Approximate approximate, OutlineOf outlineOf)
{
    Representation result;
    result.method = method;
    result.pieces = pieces;
    std::vector<double> errors;
    for (const WavyReference& reference : references)
    {
        const auto approximation = approximate(reference, pieces);
        errors.push_back(reference.difference(outlineOf(approximation)));
        result.shapes.push_back(ShapeType(approximation));
    }
    result.error = median(errors);

    test::RandomSource random(seed);
    const auto anyShape = [&]() -> const Shape&
    { return result.shapes[static_cast<std::size_t>(random.integer(0, grainCount - 1))]; };
    for (int i = 0; i < pairCount; ++i)
    {
        const Shape& a = anyShape();
        const Shape& b = anyShape();
        const double depth = random.logUniform(1e-4, 1e-2);
        result.pairs.push_back(
            {a, b, shallowPoses(std::get<ShapeType>(a), std::get<ShapeType>(b), depth, random)});
    }
    return result;
}

double queryAll(const Representation& representation)
{
    double sum = 0;
    for (const Pair& pair : representation.pairs)
    {
        SearchStart start{pair.poses.lookFirst};
        ContactGeometry<2> contact;
        pairContact(pair.a, pair.poses.a, pair.b, pair.poses.b, start, contact);
        sum += contact.depth;
    }
    return sum;
}

std::vector<Representation> representations(const std::vector<WavyReference>& references)
{
    std::vector<Representation> all;
    const auto same = [](const std::vector<CubicBezier>& segments) { return segments; };
    for (const int segments : {3, 4, 5, 6, 8, 10, 12, 16, 20})
    {
        const auto fit = [](const WavyReference& reference, int count)
        { return fitSmoothOutline(reference.polygon(fitSides), count); };
        all.push_back(represent<PolyBezier>("polybezier, chesilFit", segments, references, fit, same));
    }
    for (const int sides : {3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 200, 400})
    {
        const auto polygon = [](const WavyReference& reference, int count)
        { return reference.polygon(count); };
        all.push_back(represent<ConvexPolygon>("polygon", sides, references, polygon, edges));
    }
    for (const int segments : {3, 4, 5, 6, 8, 10, 12, 16, 20})
    {
        const auto rule = [](const WavyReference& reference, int count) { return reference.segments(count); };
        all.push_back(represent<PolyBezier>("polybezier, fixed joints", segments, references, rule, same));
    }
    return all;
}

/// Order in the number of pieces, from 6 on.
void printOrder(const std::string& method, const std::vector<Representation>& all, Results& results)
{
    std::vector<double> pieces;
    std::vector<double> errors;
    for (const Representation& representation : all)
    {
        if (representation.method == method && representation.pieces >= 6)
        {
            pieces.push_back(representation.pieces);
            errors.push_back(representation.error);
        }
    }
    const std::string order =
        text("error ~ pieces^%.1f from 6 pieces on (%s)", logarithmicSlope(pieces, errors), method.c_str());
    std::printf("    %s\n", order.c_str());
    results.comments.emplace_back("order", order);
}

Results measure()
{
    std::printf("    seed %llu, %d smooth grains, %d contacts of each representation\n",
                static_cast<unsigned long long>(seed), grainCount, pairCount);
    test::RandomSource random(seed);
    std::vector<WavyReference> references;
    for (int i = 0; i < grainCount; ++i)
    {
        references.emplace_back(random);
    }
    std::printf("    approximating ...\n");
    const std::vector<Representation> all = representations(references);

    std::printf("    timing ...\n");
    std::vector<std::function<double()>> works;
    for (const Representation& representation : all)
    {
        works.push_back([&representation]() { return queryAll(representation); });
    }
    const std::vector<double> seconds = medianSeconds(works, rounds);

    Results results;
    results.comments = {
        {"title", "Segments against sides: smooth irregular grains"},
        {"error", "area of the symmetric difference over the area [-]"},
        {"time", "time of a contact query [ns]"},
        {"knob", "segments or sides"},
        {"grains", text("%d smooth ones, support function 1 + waves 2..5 of random size and phase, seed %llu",
                        grainCount, static_cast<unsigned long long>(seed))},
        {"contacts",
         text("%d random pairs, depth 1e-4..1e-2 of the size, sought along last step's normal", pairCount)},
        {"median", text("of the grains for the error, of %d rounds for the CPU time", rounds)},
    };
    std::printf("    %-24s  pieces     error      ns\n", "method");
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const double nanoseconds = 1e9 * seconds[i] / pairCount;
        results.measurements.push_back(
            {all[i].method, std::to_string(all[i].pieces), all[i].error, nanoseconds});
        std::printf("    %-24s  %6d  %8.1e  %6.0f\n", all[i].method.c_str(), all[i].pieces, all[i].error,
                    nanoseconds);
    }
    for (const char* method : {"polybezier, chesilFit", "polygon", "polybezier, fixed joints"})
    {
        printOrder(method, all, results);
    }
    return results;
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
