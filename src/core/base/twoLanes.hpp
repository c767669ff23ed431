#pragma once

#include <cmath>

namespace chesil
{

/// Two numbers that go through the same arithmetic side by side, each with the bits that it would have alone: a register of
/// any x86-64 (SSE2); elsewhere the compiler takes what there is. Formulas written for a Number, this or double, need
/// the functions below where operators differ.
using TwoLanes = double __attribute__((vector_size(16)));

/// What a comparison of TwoLanes gives.
using TwoVerdicts = decltype(TwoLanes() < TwoLanes());

inline double squareRoot(double a) { return std::sqrt(a); }
inline TwoLanes squareRoot(TwoLanes a) { return TwoLanes{std::sqrt(a[0]), std::sqrt(a[1])}; }

inline double magnitude(double a) { return std::abs(a); }
inline TwoLanes magnitude(TwoLanes a) { return TwoLanes{std::abs(a[0]), std::abs(a[1])}; }

inline bool areAll(bool verdict) { return verdict; }
inline bool areAll(TwoVerdicts verdicts)
{
#if defined(__SSE2__)
    return __builtin_ia32_movmskpd(reinterpret_cast<TwoLanes>(verdicts)) == 3;
#else
    return (verdicts[0] & verdicts[1]) != 0;
#endif
}

} // namespace chesil
