#pragma once

namespace chesil
{

/// What a pair query cost; counted only by queries that are handed one.
struct QueryCost
{
    /// Support points of A - B asked for: one an iteration in every solver. Formulas and separating axes need none.
    int supportCalls = 0;
    /// The nearest valley could not be proved the deepest: the sweep over all directions decided.
    bool swept = false;
};

/// Counts nothing and takes no room.
struct NoCost
{
    void countSupport() const {}
    void countSweep() const {}
};

/// Adds to a QueryCost.
struct CostCounter
{
    QueryCost* cost;

    void countSupport() const { ++cost->supportCalls; }
    void countSweep() const { cost->swept = true; }
};

} // namespace chesil
