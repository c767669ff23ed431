#pragma once

#include "coupling/cellView/box.hpp"

#include <array>
#include <vector>

namespace chesil
{

/// Finds which of many boxes overlap a given one. The plane that they span is divided into about as many
/// equal bins as there are boxes, of the mean box's proportions; each bin lists the boxes that touch it. A
/// query reads the bins under its own box: its cost grows with what it finds. Where boxes differ in size,
/// large ones stand in many bins and small ones share a bin, which costs time and nothing else.
class BoxBins
{
public:
    BoxBins() = default;

    /// The boxes must be finite and not empty.
    explicit BoxBins(const std::vector<Box>& boxes);

    /// Replaces `found` by the indices of all boxes that overlap the query, each once, rising. Allocates
    /// only if `found` has to grow. A query that is not finite finds nothing.
    void overlapping(const Box& query, std::vector<int>& found) const;

private:
    /// First and last bin along x and y.
    struct BinRange
    {
        std::array<int, 2> first;
        std::array<int, 2> last;
    };

    BinRange rangeOf(const Box& box) const;
    int binAlong(int axis, double coordinate) const;
    void fill();

    std::vector<Box> boxes_;
    Box bounds_;
    std::array<int, 2> count_{0, 0};
    Vector2 binsPerMetre_ = Vector2::Zero();
    std::vector<int> offsets_;
    std::vector<int> members_;
};

} // namespace chesil
