/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "grainFileSettings.H"
#include "checkedDictionary.H"
#include "materialSettings.H"

#include "OSspecific.H"

#include "core/io/worldGrainTable.hpp"

#include <filesystem>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::checkedDictionary;

//- Of the file that the entry names
Foam::fileName grainsPath
(
    const checkedDictionary& entries,
    const Foam::fileName& caseFolder
)
{
    Foam::fileName path(entries.text("file"));
    const std::string shown(path);
    if (!path.isAbsolute())
    {
        path = caseFolder/path;
    }
    if (!Foam::isFile(path, false))
    {
        entries.fail
        (
            "file",
            shown + ", which is no file",
            "a table of grains as chesilDEM writes it (grains.csv), relative"
            " to the case"
        );
    }
    const std::string written(caseFolder/"grains.csv");
    std::error_code missing;
    if (std::filesystem::equivalent(std::string(path), written, missing))
    {
        entries.fail
        (
            "file",
            shown + ", which runs of this case replace",
            "a file that stays, as constant/grains.csv"
        );
    }
    return path;
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<chesil::GrainState> Foam::readGrainFile
(
    const dictionary& dict,
    shapeGroups& shapes,
    const materialSettings& materials,
    const fileName& caseFolder
)
{
    const checkedDictionary entries(dict, {"type", "file", "material"});
    const fileName path = grainsPath(entries, caseFolder);
    std::vector<chesil::GrainRow> rows = chesil::readGrainTable(path);
    if (entries.found("material") || rows.front().material.empty())
    {
        const auto material = std::size_t(materials.read(entries));
        for (chesil::GrainRow& row : rows)
        {
            row.material = materials.materials[material].name;
        }
    }
    try
    {
        return chesil::placeGrains
            (path, rows, shapes.shapes, materials.materials);
    }
    catch (const chesil::ValueError& error)
    {
        throw error.at(entries.file(), entries.fullName("file"));
    }
}


// ************************************************************************* //
