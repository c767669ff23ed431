/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "contactSettings.H"
#include "checkedDictionary.H"
#include "materialSettings.H"

#include "core/contact/restitution.hpp"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using chesil::HertzMindlinLaw;
using chesil::LawTable;
using chesil::LinearLaw;
using Foam::checkedDictionary;
using Foam::dictionary;
using Foam::materialSettings;

const std::vector<std::string> surfaceNames
{
    "friction", "restitution", "cohesion", "rollingFriction"
};

template<class Law>
void readSurface(const checkedDictionary& entries, Law& law)
{
    law.friction = entries.notNegative("friction", 0);
    law.cohesion = entries.notNegative("cohesion", 0);
    law.rollingFriction = entries.notNegative("rollingFriction", 0);
    if (entries.found("restitution"))
    {
        law.dampingRatio = chesil::dampingRatioOf
        (
            entries.numberIn("restitution", 1e-3, 1, "a number in [0.001, 1]")
        );
    }
}

LinearLaw linearLaw(const checkedDictionary& entries)
{
    LinearLaw law;
    law.normalStiffness = entries.positive("normalStiffness");
    law.tangentialStiffness =
        entries.notNegative("tangentialStiffness", law.normalStiffness);
    readSurface(entries, law);
    return law;
}

HertzMindlinLaw hertzMindlinLaw
(
    const checkedDictionary& entries,
    const materialSettings& materials,
    std::size_t a,
    std::size_t b
)
{
    HertzMindlinLaw law;
    law.effectiveModulus =
        chesil::effectiveModulusOf(materials.elastic[a], materials.elastic[b]);
    law.effectiveShearModulus = chesil::effectiveShearModulusOf
        (materials.elastic[a], materials.elastic[b]);
    law.workOfAdhesion = entries.notNegative("workOfAdhesion", 0);
    readSurface(entries, law);
    return law;
}

//- Entries of one pair in the place of those of all
dictionary merged(const dictionary& all, const dictionary* pair)
{
    dictionary result(all.parent(), all);
    result.remove("pairs");
    if (pair)
    {
        result.merge(*pair);
        result.remove("materials");
        result.name() = pair->name();
    }
    return result;
}

std::size_t indexOf
(
    const checkedDictionary& entries,
    const std::string& name,
    const std::vector<std::string>& known
)
{
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
    {
        entries.fail
        (
            "materials", name, "two of: " + chesil::listOfNames(known)
        );
    }
    return std::size_t(found - known.begin());
}

//- lawFrom(entries, a, b) for each pair of materials
template<class Law, class LawFrom>
LawTable<Law> readTable
(
    const dictionary& dict,
    const std::vector<std::string>& names,
    const std::vector<std::string>& materials,
    const LawFrom& lawFrom
)
{
    std::vector<std::string> namesOfAll(names);
    namesOfAll.insert(namesOfAll.end(), {"law", "pairs"});
    const checkedDictionary all(dict, namesOfAll);

    LawTable<Law> table(materials.size());
    const auto fill = [&](std::size_t a, std::size_t b, const dictionary* pair)
    {
        const dictionary entries(merged(dict, pair));
        table.set(a, b, lawFrom(checkedDictionary(entries, namesOfAll), a, b));
    };
    for (std::size_t a = 0; a < materials.size(); ++a)
    {
        for (std::size_t b = 0; b <= a; ++b)
        {
            fill(a, b, nullptr);
        }
    }
    if (!all.found("pairs"))
    {
        return table;
    }
    std::vector<std::string> namesOfPair(names);
    namesOfPair.push_back("materials");
    const dictionary& pairs = all.subDict("pairs");
    std::vector<std::pair<std::size_t, std::size_t>> given;
    for (const Foam::word& name : checkedDictionary::subDictNames(pairs))
    {
        const dictionary& pair = pairs.subDict(name);
        const checkedDictionary entries(pair, namesOfPair);
        const std::vector<std::string> two = entries.words("materials");
        if (two.size() != 2)
        {
            entries.fail
            (
                "materials",
                std::to_string(two.size()) + " names",
                "two of: " + chesil::listOfNames(materials)
            );
        }
        // A list: of two temporaries std::minmax would keep references
        const std::pair<std::size_t, std::size_t> key = std::minmax
        ({
            indexOf(entries, two[0], materials),
            indexOf(entries, two[1], materials)
        });
        if (std::count(given.begin(), given.end(), key))
        {
            entries.fail
                ("materials", two[0] + " and " + two[1] + " again", "each pair once");
        }
        given.push_back(key);
        fill(key.first, key.second, &pair);
    }
    return table;
}

void requireElasticity
(
    const checkedDictionary& entries,
    const materialSettings& materials
)
{
    for (std::size_t i = 0; i < materials.elastic.size(); ++i)
    {
        if (!(materials.elastic[i].youngsModulus > 0))
        {
            entries.fail
            (
                "law",
                "hertzMindlin, but material " + materials.materials[i].name
              + " has no youngsModulus",
                "youngsModulus and poissonsRatio of every material, or law linear"
            );
        }
    }
}

void requireCurvature
(
    const checkedDictionary& entries,
    const std::vector<chesil::NamedShape>& shapes
)
{
    for (const chesil::NamedShape& shape : shapes)
    {
        if (!chesil::isSmooth(shape.shape))
        {
            entries.fail
            (
                "law",
                "hertzMindlin, but shape " + shape.name
              + " has corners or straight sides",
                "shapes that are curved all round, or law linear"
            );
        }
    }
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

chesil::ContactLaws Foam::readContactLaws
(
    const dictionary& dict,
    const materialSettings& materials,
    const std::vector<chesil::NamedShape>& shapes
)
{
    const checkedDictionary any(dict);
    std::vector<std::string> names(surfaceNames);
    const bool linear =
        !any.found("law")
     || any.choice("law", {LinearLaw::typeName, HertzMindlinLaw::typeName})
     == LinearLaw::typeName;
    if (linear)
    {
        names.insert(names.begin(), {"normalStiffness", "tangentialStiffness"});
        return readTable<LinearLaw>
        (
            dict,
            names,
            materials.names(),
            [](const checkedDictionary& entries, std::size_t, std::size_t)
            {
                return linearLaw(entries);
            }
        );
    }
    names.push_back("workOfAdhesion");
    requireElasticity(any, materials);
    requireCurvature(any, shapes);
    return readTable<HertzMindlinLaw>
    (
        dict,
        names,
        materials.names(),
        [&](const checkedDictionary& entries, std::size_t a, std::size_t b)
        {
            return hertzMindlinLaw(entries, materials, a, b);
        }
    );
}


// ************************************************************************* //
