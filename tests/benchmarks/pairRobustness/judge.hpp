#pragma once

#include "benchmarks/pairRobustness/randomPair.hpp"
#include "core/base/tolerances.hpp"
#include "core/world/pairContact.hpp"

namespace chesil::benchmark
{

/// What the kernel said.
struct Answer
{
    PairStatus status = PairStatus::notFinite;
    SearchStart start;
    ContactGeometry<2> contact{0, Vector2::Zero(), Vector2::Zero()};

    /// A query that failed may have left a depth, too.
    bool overlaps() const
    {
        return status == PairStatus::overlapping || (status != PairStatus::separated && contact.depth > 0);
    }
};

/// Asks with the start that `answer` holds: an empty one is a cold query.
inline void ask(const RandomPair& pair, const Pose<2>& poseB, Answer& answer)
{
    answer.contact.depth = 0;
    answer.status =
        pairContact(pair.a->shape, pair.poseA, pair.b->shape, poseB, answer.start, answer.contact);
}

/// First-order bound [m] on the rounding of a depth n.(p_A - p_B - x_AB) in double, S = R_A + R_B, u =
/// epsilon/2, |x_AB| <= S as in all overlapping pairs:
///
///     p_A, p_B by the Bernstein form        9 u of control points that reach up to 5/3 R     15 u S
///     turned into the world                 2 sqrt(2) u                                       3 u S
///     x_AB; p_A - p_B; minus x_AB           (1 + 1 + 2) u                                     4 u S
///     the dot product, |p| <= 2 S           (sqrt(2) + 1) u of 2 S                            5 u S
///     |n| = 1 +- 2 u, depth <= 2 S                                                            4 u S
///
/// in all 31 u S < 16 epsilon S. A support point found for a direction that is off by some u is lower by the
/// square of that only, or by u S at a corner or along an edge, which the 15 u S hold (they take the whole
/// control polygon at its largest). Where the pair lies does not matter: x_AB is the difference of the
/// positions as given, one rounding of its own length.
inline double roundingBound(const RandomPair& pair)
{
    return 16 * tolerances::epsilon * (pair.a->size + pair.b->size);
}

enum class Flaw
{
    status,
    verdict,
    geometry,
    direction,
    depth,
};

constexpr int flaws = 5;

/// What the reference says of an answer.
struct Judgement
{
    /// Neither separated nor overlapping.
    bool failure = false;
    /// Contact or none, in contradiction to the reference beyond the bound.
    bool wrongVerdict = false;
    /// Depth not positive, normal not of unit length, or a point that is not finite.
    bool flawed = false;
    /// Separated, by a direction that does not separate (beyond the bound), though the bounding circles
    /// overlap.
    bool misdirected = false;
    /// The depth is off by more than the bound.
    bool inexact = false;
    /// The reference's own bounds are further apart than its tolerance; errors are those to the nearer bound.
    bool unsettled = false;
    /// Signed [m].
    long double depth = 0;
    /// Of the depth [m]; of a separated pair, the depth that was missed.
    double error = 0;
    /// Height along the normal less the depth [m].
    double normalError = 0;
    int supports = 0;

    bool has(Flaw flaw) const
    {
        const bool all[flaws] = {failure, wrongVerdict, flawed, misdirected, inexact};
        return all[static_cast<int>(flaw)];
    }
};

/// The reference settles within this share of the sizes: a tenth of what one rounding in double leaves.
constexpr long double referenceTolerance = 1e-17L;

inline test::PreciseDepth referenceOf(const RandomPair& pair, const test::PreciseDifference& difference,
                                      const test::PrecisePoint& claim)
{
    const long double size =
        static_cast<long double>(pair.a->size) + pair.b->size + test::preciseNorm(difference.offset());
    return test::DepthSearch(difference).run(claim, referenceTolerance * size);
}

inline void judgeContact(const RandomPair& pair, const Answer& answer,
                         const test::PreciseDifference& difference, Judgement& judgement)
{
    const ContactGeometry<2>& contact = answer.contact;
    const bool usable = contact.normal.allFinite() && contact.normal != Vector2::Zero();
    const test::PrecisePoint normal = usable ? test::precise(contact.normal) : test::PrecisePoint{1, 0};
    const test::PreciseDepth least = referenceOf(pair, difference, normal);
    const long double tooDeep = contact.depth - least.highest;
    const long double tooShallow = least.lowest - contact.depth;
    judgement.flawed = !usable || !contact.point.allFinite() || !(contact.depth > 0) ||
                       !(std::abs(contact.normal.norm() - 1) <= 4 * tolerances::epsilon);
    judgement.depth = least.highest;
    judgement.error = std::isfinite(contact.depth)
                          ? static_cast<double>(std::max({tooDeep, tooShallow, 0.0L}))
                          : std::numeric_limits<double>::infinity();
    judgement.normalError = static_cast<double>(difference.height(normal) - least.highest);
    judgement.wrongVerdict = least.highest < -roundingBound(pair);
    judgement.unsettled = least.unsettled;
    judgement.supports = least.supports;
}

/// One height below zero proves that two shapes are apart; only without it their distance is searched for.
inline void judgeSeparation(const RandomPair& pair, const Answer& answer,
                            const test::PreciseDifference& difference, Judgement& judgement)
{
    const bool told = answer.start.direction.allFinite() && answer.start.direction != Vector2::Zero();
    const bool concentric = difference.offset().x == 0 && difference.offset().y == 0;
    const test::PrecisePoint claim = told         ? test::precise(answer.start.direction)
                                     : concentric ? test::PrecisePoint{1, 0}
                                                  : difference.offset();
    judgement.depth = difference.height(claim);
    judgement.supports = 1;
    // No direction is promised for those that the bounding circles tell apart.
    const long double reach = static_cast<long double>(pair.a->size) + pair.b->size;
    judgement.misdirected = test::preciseNorm(difference.offset()) < reach - roundingBound(pair) &&
                            (!told || judgement.depth > roundingBound(pair));
    if (judgement.depth > 0)
    {
        const test::PreciseDepth least = referenceOf(pair, difference, claim);
        judgement.depth = least.highest;
        judgement.error = static_cast<double>(std::max(least.lowest, 0.0L));
        judgement.wrongVerdict = least.lowest > roundingBound(pair);
        judgement.unsettled = least.unsettled;
        judgement.supports += least.supports;
    }
}

inline Judgement judge(const RandomPair& pair, const Pose<2>& poseB, const Answer& answer)
{
    const test::PreciseDifference difference(pair.a->precise, pair.poseA, pair.b->precise, poseB);
    Judgement judgement;
    judgement.failure = answer.status != PairStatus::overlapping && answer.status != PairStatus::separated;
    if (answer.overlaps())
    {
        judgeContact(pair, answer, difference, judgement);
    }
    else if (!judgement.failure)
    {
        judgeSeparation(pair, answer, difference, judgement);
    }
    judgement.inexact = !(judgement.error <= roundingBound(pair));
    return judgement;
}

} // namespace chesil::benchmark
