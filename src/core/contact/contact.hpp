#pragma once

#include "core/base/pairKey.hpp"
#include "core/base/supportContract.hpp"
#include "core/base/vector.hpp"

namespace chesil
{

/// A pair of near bodies and what is carried from step to step. World frame.
template <int Dim>
struct Contact : PairKey
{
    PieceGuess pieces{};
    /// By how much the normal turned in the last step [rad].
    float turn = 0;
    /// Overlap [m]; 0 without contact.
    double depth = 0;
    /// Unit, from first to second, of the last contact; without contact the direction that separated them.
    Vector<Dim> normal = Vector<Dim>::Zero();
    /// Middle of the overlap [m].
    Vector<Dim> point = Vector<Dim>::Zero();
    /// On the first body [N].
    Vector<Dim> force = Vector<Dim>::Zero();

    const PairKey& key() const { return *this; }
};

static_assert(sizeof(Contact<2>) == 72, "a time step streams through all contacts: their size is its time");

} // namespace chesil
