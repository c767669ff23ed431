#pragma once

namespace chesil
{

/// What a pair query cost; counted only by queries that are handed one.
struct QueryCost
{
    /// Support points of A - B asked for.
    int supportCalls = 0;
    /// The search for the nearest valley ended elsewhere, or could not prove its answer: GJK and EPA decided.
    bool fellBack = false;
};

/// Counts nothing and takes no room.
struct NoCost
{
    void countSupport() const {}
    void countFallBack() const {}
};

/// Adds to a QueryCost.
struct CostCounter
{
    QueryCost* cost;

    void countSupport() const { ++cost->supportCalls; }
    void countFallBack() const { cost->fellBack = true; }
};

} // namespace chesil
