#pragma once

#include "core/base/setupError.hpp"
#include "core/base/tolerances.hpp"

namespace chesil
{

/// Throws ValueError unless a shape's size [m] lies between tolerances::leastSize and largestSize; also if it is not a
/// number. `what` is its name for the message.
inline void requireSize(double size, const char* what)
{
    if (!(size >= tolerances::leastSize && size <= tolerances::largestSize))
    {
        throw ValueError(
            numberText(size),
            std::string(what) + " > 0 [m], from " + numberText(tolerances::leastSize) + " to " + numberText(tolerances::largestSize));
    }
}

} // namespace chesil
