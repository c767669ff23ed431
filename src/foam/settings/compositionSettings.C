/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "compositionSettings.H"

#include <set>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using chesil::ShapeShare;
using chesil::SizeDistribution;
using Foam::checkedDictionary;
using Foam::dictionary;
using Foam::shapeGroups;

std::vector<ShapeShare> equalShares
(
    const checkedDictionary& entries,
    const shapeGroups& shapes
)
{
    std::vector<ShapeShare> result;
    for (const int shape : Foam::readShapeNames(entries, "shapes", shapes))
    {
        result.push_back({shape, 1});
    }
    return result;
}


std::vector<ShapeShare> readMixture
(
    const checkedDictionary& entries,
    const shapeGroups& shapes
)
{
    std::vector<ShapeShare> result;
    std::set<std::string> names;
    for (const auto& [name, share] : entries.namedNumbers("mixture"))
    {
        if (!names.insert(name).second)
        {
            entries.fail("mixture", name + " twice", "each name once");
        }
        if (!(share > 0))
        {
            entries.fail
            (
                "mixture",
                "share " + chesil::numberText(share) + " of " + name,
                "shares > 0"
            );
        }
        const auto& group =
            Foam::groupNamed(entries, "mixture", name, shapes);
        for (const int shape : group)
        {
            result.push_back({shape, share/double(group.size())});
        }
    }
    if (result.empty())
    {
        entries.fail("mixture", "no shape", "at least one");
    }
    return result;
}


const std::vector<std::string> sizeTypes{"lognormal", "sieve", "uniform"};

SizeDistribution readDistribution
(
    const dictionary& dict,
    const std::string& type
)
{
    if (type == "uniform")
    {
        const checkedDictionary entries
            (dict, {"type", "ratioMin", "ratioMax", "classes"});
        return chesil::UniformRatio
            (entries.positive("ratioMin"), entries.positive("ratioMax"));
    }
    if (type == "lognormal")
    {
        const checkedDictionary entries
        (
            dict,
            {"type", "median", "deviation", "min", "max", "classes"}
        );
        return chesil::LognormalSize
        (
            entries.positive("median"),
            entries.positive("deviation"),
            entries.positive("min"),
            entries.positive("max")
        );
    }
    const checkedDictionary entries
        (dict, {"type", "sizes", "passing", "classes"});
    return chesil::SieveCurve
        (entries.numbers("sizes"), entries.numbers("passing"));
}


chesil::SizeClasses readSizes(const checkedDictionary& entries)
{
    constexpr Foam::label usualClasses = 32;
    const dictionary& dict = entries.subDict("sizes");
    const checkedDictionary sizes(dict);
    const std::string type = sizes.choice("type", sizeTypes);
    try
    {
        const SizeDistribution distribution = readDistribution(dict, type);
        return chesil::sizeClasses
            (distribution, sizes.count("classes", 1, usualClasses));
    }
    catch (const chesil::ValueError& error)
    {
        throw error.at(entries.file(), entries.fullName("sizes"));
    }
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<int> Foam::readShapeNames
(
    const checkedDictionary& entries,
    const word& name,
    const shapeGroups& shapes
)
{
    std::vector<int> result;
    for (const std::string& one : entries.words(name))
    {
        const auto& group = groupNamed(entries, name, one, shapes);
        result.insert(result.end(), group.begin(), group.end());
    }
    if (result.empty())
    {
        entries.fail(name, "no shape", "at least one");
    }
    return result;
}


chesil::Composition Foam::readComposition
(
    const checkedDictionary& entries,
    const shapeGroups& shapes
)
{
    chesil::Composition result;
    if (entries.found("shapes") && entries.found("mixture"))
    {
        entries.fail("mixture", "shapes and mixture", "one of the two");
    }
    result.mixture =
        entries.found("mixture")
      ? readMixture(entries, shapes)
      : equalShares(entries, shapes);
    if (entries.found("sizes"))
    {
        result.sizes = readSizes(entries);
    }
    return result;
}


// ************************************************************************* //
