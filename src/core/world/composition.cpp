#include "core/world/composition.hpp"

#include "core/base/setupError.hpp"
#include "core/shapes/scaledShape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

namespace
{

/// One grain: places in the lists of the mixture and of the classes of size.
struct Part
{
    std::size_t shape;
    std::size_t size;
};

std::vector<double> shapeShares(const Composition& composition)
{
    std::vector<double> shares;
    for (const ShapeShare& one : composition.mixture)
    {
        shares.push_back(one.share);
    }
    return shares;
}

std::vector<double> sizeShares(const Composition& composition)
{
    std::vector<double> shares;
    for (const SizeClass& one : composition.sizes.classes)
    {
        shares.push_back(one.share);
    }
    return shares.empty() ? std::vector<double>{1} : shares;
}

double sumOf(const std::vector<double>& shares)
{
    double sum = 0;
    for (const double share : shares)
    {
        sum += share;
    }
    return sum;
}

/// Systematic sampling: the points (i + start)/number of the shares' running sum, with one random start for
/// all.
std::vector<std::size_t> inShares(const std::vector<double>& shares, std::size_t number, RandomEngine& engine)
{
    const double start = uniform(engine);
    const double spacing = sumOf(shares) / static_cast<double>(number);
    std::vector<std::size_t> result;
    double end = 0;
    for (std::size_t i = 0; i < shares.size(); ++i)
    {
        end += shares[i];
        const bool last = i + 1 == shares.size();
        while (result.size() < number &&
               (last || (static_cast<double>(result.size()) + start) * spacing < end))
        {
            result.push_back(i);
        }
    }
    shuffle(result, engine);
    return result;
}

std::vector<Part> draw(const Composition& composition, std::size_t number, RandomEngine& engine)
{
    const std::vector<std::size_t> shape = inShares(shapeShares(composition), number, engine);
    const std::vector<std::size_t> size = inShares(sizeShares(composition), number, engine);
    std::vector<Part> parts;
    for (std::size_t i = 0; i < number; ++i)
    {
        parts.push_back({shape[i], size[i]});
    }
    return parts;
}

/// For each shape of the mixture and each class of size.
class PartTable
{
public:
    PartTable(const std::vector<NamedShape>& shapes, const Composition& composition)
        : composition_(composition)
    {
        for (const ShapeShare& one : composition.mixture)
        {
            const Shape& shape = shapes[static_cast<std::size_t>(one.shape)].shape;
            areas_.push_back(massProperties(shape).area);
            diameters_.push_back(diameterOf(shape));
        }
    }

    bool ownSize() const { return composition_.sizes.classes.empty(); }

    double scale(const Part& part) const { return diameter(part) / diameters_[part.shape]; }
    double area(const Part& part) const { return scale(part) * scale(part) * areas_[part.shape]; }

    double diameter(const Part& part) const
    {
        const double own = diameters_[part.shape];
        if (ownSize())
        {
            return own;
        }
        const double size = composition_.sizes.classes[part.size].size;
        return composition_.sizes.areRatios ? size * own : size;
    }

    double meanArea() const
    {
        const std::vector<double> shapes = shapeShares(composition_);
        const std::vector<double> sizes = sizeShares(composition_);
        double sum = 0;
        for (std::size_t i = 0; i < shapes.size(); ++i)
        {
            for (std::size_t k = 0; k < sizes.size(); ++k)
            {
                sum += shapes[i] * sizes[k] * area({i, k});
            }
        }
        return sum / (sumOf(shapes) * sumOf(sizes));
    }

private:
    const Composition& composition_;
    std::vector<double> areas_;
    std::vector<double> diameters_;
};

/// Leaves out, or doubles, each grain from the last on that is no bigger than what is left of `excess`;
/// returns what is left then.
double approachArea(std::vector<Part>& parts, const PartTable& table, double excess)
{
    std::vector<Part> doubled;
    for (std::size_t i = parts.size(); i-- > 0;)
    {
        const double own = table.area(parts[i]);
        if (own <= excess)
        {
            excess -= own;
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
        }
        else if (own <= -excess)
        {
            excess += own;
            doubled.push_back(parts[i]);
        }
    }
    parts.insert(parts.end(), doubled.begin(), doubled.end());
    return excess;
}

void meetArea(std::vector<Part>& parts, const PartTable& table, double area)
{
    double excess = -area;
    for (const Part& part : parts)
    {
        excess += table.area(part);
    }
    for (double before = 0; before != excess;)
    {
        before = excess;
        excess = approachArea(parts, table, excess);
    }
}

/// Appends the scaled shapes that grains need, in the order of the lists.
std::vector<int> shapesOf(const std::vector<Part>& parts, const PartTable& table,
                          const Composition& composition, std::vector<NamedShape>& shapes)
{
    constexpr int none = -1;
    const std::size_t classes = sizeShares(composition).size();
    std::vector<int> places(composition.mixture.size() * classes, none);
    std::vector<int> result;
    for (const Part& part : parts)
    {
        int& place = places[part.shape * classes + part.size];
        if (place == none)
        {
            place = composition.mixture[part.shape].shape;
            if (!table.ownSize())
            {
                const NamedShape original = shapes[static_cast<std::size_t>(place)];
                place = static_cast<int>(shapes.size());
                shapes.push_back(ofSize(original, table.diameter(part)));
            }
        }
        result.push_back(place);
    }
    return result;
}

} // namespace

std::vector<int> composeNumber(std::vector<NamedShape>& shapes, const Composition& composition, int number,
                               RandomEngine& engine)
{
    const PartTable table(shapes, composition);
    return shapesOf(draw(composition, static_cast<std::size_t>(number), engine), table, composition, shapes);
}

std::vector<int> composeArea(std::vector<NamedShape>& shapes, const Composition& composition, double area,
                             RandomEngine& engine)
{
    const PartTable table(shapes, composition);
    const double number = std::round(area / table.meanArea());
    if (!(number >= 1 && number <= std::numeric_limits<int>::max()))
    {
        throw ValueError(numberText(area) + " m2 of grains with a mean area of " +
                             numberText(table.meanArea()) + " m2",
                         "from 1 to " + std::to_string(std::numeric_limits<int>::max()) + " grains");
    }
    std::vector<Part> parts = draw(composition, static_cast<std::size_t>(number), engine);
    meetArea(parts, table, area);
    return shapesOf(parts, table, composition, shapes);
}

} // namespace chesil
