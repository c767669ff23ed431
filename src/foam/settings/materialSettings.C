/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "materialSettings.H"
#include "checkedDictionary.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

void addMaterial
(
    const std::string& name,
    const Foam::dictionary& dict,
    Foam::materialSettings& settings
)
{
    const Foam::checkedDictionary entries
        (dict, {"density", "youngsModulus", "poissonsRatio"});
    settings.materials.push_back({name, entries.positive("density")});
    chesil::ElasticMaterial elastic{0, 0};
    if (entries.found("youngsModulus") || entries.found("poissonsRatio"))
    {
        elastic.youngsModulus = entries.positive("youngsModulus");
        elastic.poissonsRatio = entries.numberIn
            ("poissonsRatio", -0.999, 0.5, "a number in [-0.999, 0.5]");
    }
    settings.elastic.push_back(elastic);
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<std::string> Foam::materialSettings::names() const
{
    std::vector<std::string> result;
    for (const chesil::Material& material : materials)
    {
        result.push_back(material.name);
    }
    return result;
}


int Foam::materialSettings::read(const checkedDictionary& entries) const
{
    if (materials.size() == 1 && !entries.found("material"))
    {
        return 0;
    }
    const std::string name = entries.choice("material", names());
    const std::vector<std::string> known = names();
    return int(std::find(known.begin(), known.end(), name) - known.begin());
}


Foam::materialSettings Foam::readMaterials(const checkedDictionary& entries)
{
    materialSettings result;
    if (!entries.found("materials"))
    {
        addMaterial("material", entries.subDict("material"), result);
        return result;
    }
    if (entries.found("material"))
    {
        entries.fail("material", "materials, too", "one of both");
    }
    const dictionary& materials = entries.subDict("materials");
    for (const word& name : checkedDictionary::subDictNames(materials))
    {
        addMaterial(name, materials.subDict(name), result);
    }
    if (result.materials.empty())
    {
        entries.fail("materials", "an empty dictionary", "at least one material");
    }
    return result;
}


// ************************************************************************* //
