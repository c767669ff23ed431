#pragma once

#include "benchmarks/pairRobustness/grainPool.hpp"

#include <cstdint>
#include <string>

namespace chesil::benchmark
{

/// How a pair lies when it is asked for the first time.
enum class Situation
{
    separate,
    touching,
    shallow,
    deep,
    concentric,
    identical,
};

constexpr int situations = 6;

inline const char* situationName(int situation)
{
    static const char* const names[situations] = {"separate", "touching",   "shallow",
                                                  "deep",     "concentric", "identical"};
    return names[situation];
}

/// The classes over which errors are gathered.
struct Stratum
{
    Situation situation = Situation::separate;
    /// typeA <= typeB; which of them is the first of a pair is random.
    int typeA = 0;
    int typeB = 0;
    bool wellScaled = false;

    std::string types() const { return std::string(typeName(typeA)) + "-" + typeName(typeB); }
};

/// Situations by shares of 20 (more where it is difficult), every second batch well-scaled, types in turn.
inline Stratum stratumOf(std::int64_t batch)
{
    constexpr int shares[20] = {0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 5};
    constexpr int typePairs = shapeTypes * (shapeTypes + 1) / 2;
    Stratum stratum;
    stratum.wellScaled = batch % 2 == 0;
    stratum.situation = static_cast<Situation>(shares[(batch / 2) % 20]);
    int rank = static_cast<int>((batch / 40) % typePairs);
    for (stratum.typeA = 0; rank >= shapeTypes - stratum.typeA; ++stratum.typeA)
    {
        rank -= shapeTypes - stratum.typeA;
    }
    stratum.typeB = stratum.typeA + rank;
    if (stratum.situation == Situation::identical)
    {
        stratum.typeA = stratum.typeB = static_cast<int>((batch / 40) % shapeTypes);
    }
    return stratum;
}

/// Two placed grains, and where they are a step later.
struct RandomPair
{
    const Grain* a = nullptr;
    const Grain* b = nullptr;
    Pose<2> poseA;
    Pose<2> poseB;
    Pose<2> laterB;

    double larger() const { return std::max(a->size, b->size); }
    double smaller() const { return std::min(a->size, b->size); }
};

/// Pair `index` of a seed and stratum, the same in any order of making.
class PairMaker
{
public:
    PairMaker(const GrainPool& pool, std::uint64_t seed) : pool_(pool), seed_(seed) {}

    RandomPair make(const Stratum& stratum, std::int64_t index) const
    {
        test::RandomSource random(seed_ + 0x9E3779B97F4A7C15u * static_cast<std::uint64_t>(index + 1));
        RandomPair pair = grains(stratum, random);
        const double reach = stratum.wellScaled ? random.uniform(0, 10) : random.logUniform(1, 1e6);
        const double turnA = random.uniform(0, 1) < 0.1 ? 0 : random.uniform(-M_PI, M_PI);
        pair.poseA = {reach * pair.larger() * random.direction(), Rotation<2>(turnA)};
        pair.poseB = {pair.poseA.position, Rotation<2>(random.uniform(-M_PI, M_PI))};
        place(stratum.situation, pair, random);
        const double step = 1e-3 * (random.uniform(0, 1) < 0.5 ? pair.larger() : pair.smaller());
        pair.laterB.position = pair.poseB.position + step * random.uniform(0, 1) * random.direction();
        pair.laterB.rotation = Rotation<2>(pair.poseB.rotation.angle() + random.uniform(-1e-3, 1e-3));
        return pair;
    }

private:
    RandomPair grains(const Stratum& stratum, test::RandomSource& random) const
    {
        const int group = random.integer(0, pool_.groups() - 1);
        const bool firstLarge = random.uniform(0, 1) < 0.5;
        RandomPair pair;
        pair.a = &pool_.any(group, stratum.typeA, stratum.wellScaled, firstLarge, random);
        pair.b = &pool_.any(group, stratum.typeB, stratum.wellScaled, !firstLarge, random);
        if (stratum.situation == Situation::identical)
        {
            pair.b = pair.a;
        }
        if (random.uniform(0, 1) < 0.5)
        {
            std::swap(pair.a, pair.b);
        }
        return pair;
    }

    /// Outward normal, in the shape's frame, of one of its sides: a polygon's edge, the chord of a
    /// polybezier's segment (it may be straight), an ellipse's axis.
    static Vector2 sideNormal(const Shape& shape, test::RandomSource& random)
    {
        const double choice = random.uniform(0, 1);
        const auto any = [&](const auto& list)
        { return static_cast<std::size_t>(choice * static_cast<double>(list.size())); };
        if (const auto* polygon = std::get_if<ConvexPolygon>(&shape))
        {
            const std::size_t i = any(polygon->vertices());
            const std::size_t next = i + 1 < polygon->vertices().size() ? i + 1 : 0;
            return -perpendicular(polygon->vertices()[next] - polygon->vertices()[i]).normalized();
        }
        if (const auto* grain = std::get_if<PolyBezier>(&shape))
        {
            const CubicBezier& segment = grain->segments()[any(grain->segments())];
            return -perpendicular(segment.end() - segment.start()).normalized();
        }
        return choice < 0.5 ? Vector2(Vector2::UnitX()) : Vector2(Vector2::UnitY());
    }

    /// Parallel, to rounding or a little less, or anyhow.
    static double anyTilt(test::RandomSource& random)
    {
        const double choice = random.uniform(0, 1);
        return choice < 0.3 ? 0 : choice < 0.6 ? random.logUniform(1e-16, 1e-3) : random.uniform(-M_PI, M_PI);
    }

    /// x_B - x_A at which the support points along n lie `depth` [m] over each other.
    static Vector2 laidOver(const RandomPair& pair, const Vector2& n, double depth)
    {
        const Rotation<2>& turnA = pair.poseA.rotation;
        const Rotation<2>& turnB = pair.poseB.rotation;
        const Vector2 onA = turnA.apply(support(pair.a->shape, turnA.applyInverse(n)));
        const Vector2 onB = turnB.apply(support(pair.b->shape, turnB.applyInverse(-n)));
        return onA - onB - depth * n;
    }

    static double anyDepth(Situation situation, const RandomPair& pair, test::RandomSource& random)
    {
        switch (situation)
        {
        case Situation::separate:
            return -pair.larger() * random.logUniform(1e-9, 10);
        case Situation::touching:
            return pair.larger() * random.uniform(-1e-12, 1e-12);
        case Situation::shallow:
            return pair.smaller() * random.logUniform(1e-6, 1e-2);
        default:
            return 0;
        }
    }

    /// Turns and moves B, which lies on A in any turn. Half of the pairs that are near lie side to side; of
    /// those a shift along the side changes nothing.
    static void place(Situation situation, RandomPair& pair, test::RandomSource& random)
    {
        Vector2 n = random.direction();
        const double choice = random.uniform(0, 1);
        if (situation == Situation::identical)
        {
            pair.poseB.rotation = Rotation<2>(pair.poseA.rotation.angle() + anyTilt(random));
            return;
        }
        if (situation == Situation::concentric)
        {
            pair.poseB.position += (choice < 0.5 ? 0 : pair.smaller() * random.logUniform(1e-16, 1e-3)) * n;
            return;
        }
        if (situation == Situation::deep)
        {
            pair.poseB.position += random.uniform(0.05, 0.9) * laidOver(pair, n, 0);
            return;
        }
        double shift = 0;
        if (choice < 0.5)
        {
            const Vector2 side = sideNormal(pair.b->shape, random);
            n = pair.poseA.rotation.apply(sideNormal(pair.a->shape, random));
            shift = random.uniform(-0.3, 0.3) * pair.smaller();
            pair.poseB.rotation =
                Rotation<2>(std::atan2(-n.y(), -n.x()) - std::atan2(side.y(), side.x()) + anyTilt(random));
        }
        pair.poseB.position +=
            laidOver(pair, n, anyDepth(situation, pair, random)) + shift * perpendicular(n);
    }

    const GrainPool& pool_;
    std::uint64_t seed_;
};

} // namespace chesil::benchmark
