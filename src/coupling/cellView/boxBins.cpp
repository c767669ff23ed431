#include "coupling/cellView/boxBins.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

BoxBins::BoxBins(const std::vector<Box>& boxes) : boxes_(boxes)
{
    if (boxes_.empty())
    {
        return;
    }
    Vector2 meanSize = Vector2::Zero();
    for (const Box& box : boxes_)
    {
        bounds_.add(box);
        meanSize += (box.high - box.low) / static_cast<double>(boxes_.size());
    }

    const Vector2 span = bounds_.high - bounds_.low;
    const Vector2 wanted = span.cwiseQuotient(meanSize);
    // Boxes that leave room between them, or lie on each other, would ask for too many or too few bins.
    const double scale = std::sqrt(static_cast<double>(boxes_.size()) / wanted.prod());
    for (int axis = 0; axis < 2; ++axis)
    {
        const double most = static_cast<double>(boxes_.size());
        count_[axis] = static_cast<int>(std::clamp(std::round(wanted[axis] * scale), 1.0, most));
        binsPerMetre_[axis] = count_[axis] / span[axis];
    }
    fill();
}

int BoxBins::binAlong(int axis, double coordinate) const
{
    const double place = (coordinate - bounds_.low[axis]) * binsPerMetre_[axis];
    return static_cast<int>(std::clamp(place, 0.0, count_[axis] - 1.0));
}

BoxBins::BinRange BoxBins::rangeOf(const Box& box) const
{
    return {{binAlong(0, box.low.x()), binAlong(1, box.low.y())},
            {binAlong(0, box.high.x()), binAlong(1, box.high.y())}};
}

void BoxBins::fill()
{
    const auto forEachBin = [this](const auto& visit)
    {
        for (std::size_t box = 0; box < boxes_.size(); ++box)
        {
            const BinRange range = rangeOf(boxes_[box]);
            for (int j = range.first[1]; j <= range.last[1]; ++j)
            {
                for (int i = range.first[0]; i <= range.last[0]; ++i)
                {
                    visit(j * count_[0] + i, static_cast<int>(box));
                }
            }
        }
    };

    offsets_.assign(static_cast<std::size_t>(count_[0]) * count_[1] + 1, 0);
    forEachBin([this](int bin, int) { ++offsets_[bin + 1]; });
    for (std::size_t bin = 1; bin < offsets_.size(); ++bin)
    {
        offsets_[bin] += offsets_[bin - 1];
    }
    members_.resize(offsets_.back());
    std::vector<int> next(offsets_.begin(), offsets_.end() - 1);
    forEachBin([&](int bin, int box) { members_[next[bin]++] = box; });
}

void BoxBins::overlapping(const Box& query, std::vector<int>& found) const
{
    found.clear();
    if (boxes_.empty() || !bounds_.overlaps(query))
    {
        return;
    }
    const BinRange range = rangeOf(query);
    for (int j = range.first[1]; j <= range.last[1]; ++j)
    {
        for (int i = range.first[0]; i <= range.last[0]; ++i)
        {
            const int bin = j * count_[0] + i;
            for (int k = offsets_[bin]; k < offsets_[bin + 1]; ++k)
            {
                const int box = members_[k];
                const BinRange own = rangeOf(boxes_[box]);
                // Of all bins that hold the box under the query, the first one reports it.
                const bool first = i == std::max(range.first[0], own.first[0]) &&
                                   j == std::max(range.first[1], own.first[1]);
                if (first && boxes_[box].overlaps(query))
                {
                    found.push_back(box);
                }
            }
        }
    }
    std::sort(found.begin(), found.end());
}

} // namespace chesil
