#pragma once

#include "core/base/smallTurn.hpp"
#include "core/base/supportContract.hpp"
#include "core/base/vector.hpp"

#include <cmath>

namespace chesil
{

/// What a pair hands from one query to the next.
struct SearchStart
{
    /// The direction that separated it, or its contact's normal; zero: none yet.
    Vector2 direction = Vector2::Zero();
    /// By how much the normal has turned since the query before [rad, counter-clockwise]: as a rule it goes on so.
    double turn = 0;
    PieceGuess pieces{};

    /// Where to look first.
    Vector2 expected() const { return turn == 0 ? direction : turnedBy(turn, direction); }

    /// Without contact, or where there is no saying where the next normal will be.
    void standAt(const Vector2& normal)
    {
        direction = normal;
        turn = 0;
    }

    /// The normal of a contact found from here.
    void turnTo(const Vector2& normal)
    {
        const double sine = cross(direction, normal);
        turn = std::abs(sine) < smallTurn && direction.dot(normal) > 0 ? sine : 0;
        direction = normal;
    }
};

} // namespace chesil
