/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "shapeSettings.H"

#include "OSspecific.H"

#include "core/io/templateFile.hpp"

#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using chesil::NamedShape;
using Foam::checkedDictionary;
using Foam::dictionary;

std::vector<NamedShape> readTemplateFile
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
            "a template file as chesilFit writes it, relative to the case"
        );
    }
    const chesil::TemplateFile file = chesil::readTemplates(path);
    if (file.unit != "m")
    {
        entries.fail
        (
            "file",
            shown + " with unit " + file.unit,
            "templates in metres (chesilFit -scale <metres per pixel>)"
        );
    }
    return file.grains;
}

//- How each type of shape is read: a new shape is a line here
const std::map
<
    std::string,
    std::function<std::vector<NamedShape>
    (
        const Foam::word&, const dictionary&, const Foam::fileName&
    )>
>
readers
{
    {"circle",
    [](const Foam::word& name, const dictionary& dict, const Foam::fileName&)
    {
        const checkedDictionary entries(dict, {"type", "radius"});
        return std::vector<NamedShape>
            {{name, chesil::Circle(entries.positive("radius"))}};
    }},
    {"ellipse",
    [](const Foam::word& name, const dictionary& dict, const Foam::fileName&)
    {
        const checkedDictionary entries
            (dict, {"type", "halfAxisX", "halfAxisY"});
        return std::vector<NamedShape>
        {{
            name,
            chesil::Ellipse
            (
                entries.positive("halfAxisX"),
                entries.positive("halfAxisY")
            )
        }};
    }},
    {"polygon",
    [](const Foam::word& name, const dictionary& dict, const Foam::fileName&)
    {
        const checkedDictionary entries(dict, {"type", "vertices"});
        const auto vertices = entries.planePoints("vertices");
        try
        {
            return std::vector<NamedShape>
                {{name, chesil::ConvexPolygon(vertices)}};
        }
        catch (const chesil::ValueError& error)
        {
            throw error.at(entries.file(), entries.fullName("vertices"));
        }
    }},
    {"templates",
    [](const Foam::word&, const dictionary& dict, const Foam::fileName& folder)
    {
        const checkedDictionary entries(dict, {"type", "file"});
        return readTemplateFile(entries, folder);
    }}
};

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const std::vector<int>& Foam::groupNamed
(
    const checkedDictionary& entries,
    const word& entryName,
    const std::string& name,
    const shapeGroups& shapes
)
{
    const auto group = shapes.groups.find(name);
    if (group == shapes.groups.end())
    {
        std::vector<std::string> known;
        for (const auto& g : shapes.groups)
        {
            known.push_back(g.first);
        }
        entries.fail
        (
            entryName,
            name,
            "a name of the dictionary shapes: "
          + (known.empty() ? "it is empty" : chesil::listOfNames(known))
        );
    }
    return group->second;
}


Foam::shapeGroups Foam::readShapes
(
    const dictionary& dict,
    const fileName& caseFolder
)
{
    std::vector<std::string> types;
    for (const auto& reader : readers)
    {
        types.push_back(reader.first);
    }

    shapeGroups result;
    for (const word& name : checkedDictionary::subDictNames(dict))
    {
        const dictionary& shapeDict = dict.subDict(name);
        const std::string type =
            checkedDictionary(shapeDict).choice("type", types);

        std::vector<int>& group = result.groups[name];
        for (NamedShape& shape : readers.at(type)(name, shapeDict, caseFolder))
        {
            group.push_back(static_cast<int>(result.shapes.size()));
            result.shapes.push_back(std::move(shape));
        }
    }
    return result;
}


// ************************************************************************* //
