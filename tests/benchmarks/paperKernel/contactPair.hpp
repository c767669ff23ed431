#pragma once

#include "benchmarks/paperKernel/packing.hpp"
#include "benchmarks/paperKernel/residuals.hpp"
#include "core/narrowphase/epa.hpp"

#include <optional>

namespace chesil::benchmark
{

enum class Method
{
    epa,
    /// EPA until its normal is good for Newton, then Newton.
    newtonAfterEpa,
    /// Newton from the contact's normal turned by a little: what a step of a time loop begins with.
    newtonFromNear,
};

/// Where EPA hands over to Newton: its residual over the pair's size.
constexpr double handOver = 1e-2;

/// By which the contact's normal is turned before Newton starts from it [rad].
constexpr double turned = 1e-3;

/// Two grains in contact, what GJK left of them, and a normal to start near.
class ContactPair
{
public:
    /// Nothing if the two do not overlap.
    static std::optional<ContactPair> from(const NearPair& near)
    {
        ContactPair pair(near);
        const bool overlapping = pair.visitDifference(
            [&](const auto& difference)
            {
                const GjkResult<2> search = gjk<2>(difference, difference.centreToCentre());
                if (search.status != GjkStatus::overlapping)
                {
                    return false;
                }
                pair.simplex_ = search.simplex;
                pair.near_ = Rotation<2>(turned).apply(epa<2>(difference, search.simplex).normal);
                return true;
            });
        return overlapping ? std::optional<ContactPair>(pair) : std::nullopt;
    }

    bool smooth() const
    {
        return !std::holds_alternative<ConvexPolygon>(*pair_.a) &&
               !std::holds_alternative<ConvexPolygon>(*pair_.b);
    }

    bool bothPolyBezier() const
    {
        return std::holds_alternative<PolyBezier>(*pair_.a) && std::holds_alternative<PolyBezier>(*pair_.b);
    }

    /// The residuals of the first `calls` support calls; Newton's iteration wants a smooth pair.
    Residuals follow(Method method, int calls) const
    {
        Residuals residuals;
        visitDifference(
            [&](const auto& difference)
            {
                if (method == Method::newtonFromNear)
                {
                    iterateNewton(difference, near_, 0, calls, residuals);
                    return true;
                }
                const double enough = method == Method::epa ? 0 : handOver;
                const EpaState state = iterateEpa(difference, simplex_, calls, enough, residuals);
                if (method == Method::newtonAfterEpa && state.calls < calls)
                {
                    // Known already but for its curvature: no call more.
                    const CurvedVertex<2> vertex = difference.curvedSupport(state.normal);
                    iterateNewton(difference, newtonStep(state.normal, vertex), state.calls, calls,
                                  residuals);
                }
                return true;
            });
        return residuals;
    }

private:
    explicit ContactPair(const NearPair& near) : pair_(near) {}

    template <class Work>
    bool visitDifference(Work work) const
    {
        return std::visit(
            [&](const auto& a, const auto& b)
            {
                using A = std::decay_t<decltype(a)>;
                using B = std::decay_t<decltype(b)>;
                return work(MinkowskiDifference<2, A, B>(a, pair_.poseA, b, pair_.poseB));
            },
            *pair_.a, *pair_.b);
    }

    NearPair pair_;
    Simplex<2> simplex_;
    Vector2 near_ = Vector2::Zero();
};

} // namespace chesil::benchmark
