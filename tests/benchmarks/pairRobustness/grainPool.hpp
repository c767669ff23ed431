#pragma once

#include "benchmarks/pairRobustness/stretchedGrain.hpp"
#include "core/base/setupError.hpp"
#include "unit/preciseDepth.hpp"

namespace chesil::benchmark
{

/// A shape and its reference.
struct Grain
{
    Shape shape;
    test::PreciseShape precise;
    /// Bounding radius [m].
    double size;
};

/// Grains made beforehand from a seed, in groups of one scale of 1e-6..1e6 m. A group has for each type,
/// well-scaled and not, some grains of the scale itself (large) and some that are smaller: ratio log-uniform
/// to 10 (well-scaled) or 1000. Stretches are log-uniform to 5 (a round grain's own aspect may be 2) or 1000;
/// a quarter has none.
class GrainPool
{
public:
    GrainPool(std::uint64_t seed, int groups) : groups_(groups)
    {
        test::RandomSource random(seed);
        for (int group = 0; group < groups; ++group)
        {
            const double scale = random.logUniform(1e-6, 1e6);
            for (int type = 0; type < shapeTypes; ++type)
            {
                for (const bool well : {false, true})
                {
                    for (const bool large : {false, true})
                    {
                        addSome(static_cast<ShapeType>(type), well, large ? scale : -scale, random);
                    }
                }
            }
        }
    }

    int groups() const { return groups_; }
    std::size_t size() const { return grains_.size(); }

    /// Random grains that the shapes' constructors refused.
    int refused() const { return refused_; }

    const Grain& any(int group, int type, bool well, bool large, test::RandomSource& random) const
    {
        const int list = ((group * shapeTypes + type) * 2 + (well ? 1 : 0)) * 2 + (large ? 1 : 0);
        return grains_[static_cast<std::size_t>(list * grainsOfAKind + random.integer(0, grainsOfAKind - 1))];
    }

private:
    static constexpr int grainsOfAKind = 8;

    /// A negative scale: smaller grains than that.
    void addSome(ShapeType type, bool well, double scale, test::RandomSource& random)
    {
        for (int i = 0; i < grainsOfAKind; ++i)
        {
            const double smaller = scale > 0 ? 1 : random.logUniform(1, well ? 10 : 1000);
            const double ratio = i % 4 == 0   ? 1
                                 : i % 4 == 1 ? 1 + random.logUniform(1e-15, 1e-1)
                                              : random.logUniform(1, well ? 5 : 1000);
            addOne(type, std::abs(scale) / smaller, ratio, random);
        }
    }

    /// Until one is accepted: the rounding of a sliver's short edges may turn inwards by more than the shapes
    /// allow.
    void addOne(ShapeType type, double size, double ratio, test::RandomSource& random)
    {
        for (;;)
        {
            try
            {
                const Shape shape = stretchedGrain(type, size, ratio, random);
                grains_.push_back({shape, test::PreciseShape(shape), boundingRadius(shape)});
                return;
            }
            catch (const ValueError&)
            {
                ++refused_;
            }
        }
    }

    int groups_;
    std::vector<Grain> grains_;

    int refused_ = 0;
};

} // namespace chesil::benchmark
