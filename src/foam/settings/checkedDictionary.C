/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "checkedDictionary.H"
#include "readingGuards.H"

#include "List.H"
#include "Switch.H"
#include "Tuple2.H"
#include "Vector2D.H"
#include "wordList.H"

#include <algorithm>
#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const char* const dictionaryWanted = "a dictionary { ... }";

std::string valueText(const Foam::dictionary& dict, const Foam::word& name)
{
    const Foam::entry* found = dict.findEntry(name);
    if (!found || found->isDict())
    {
        return "a dictionary";
    }
    Foam::OStringStream text;
    const Foam::ITstream& tokens = found->stream();
    forAll(tokens, i)
    {
        text << (i ? " " : "") << tokens[i];
    }
    return text.str();
}

} // End namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::checkedDictionary::checkedDictionary
(
    const dictionary& dict,
    const std::vector<std::string>& known
)
:
    dict_(dict),
    known_(known)
{
    for (const entry& e : dict)
    {
        const std::string name(e.keyword());
        if (name != "FoamFile" && std::count(known.begin(), known.end(), name) == 0)
        {
            fail
            (
                word(name),
                "an unknown name",
                "one of: " + chesil::listOfNames(known)
            );
        }
    }
}


Foam::checkedDictionary::checkedDictionary(const dictionary& dict)
:
    dict_(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::string Foam::checkedDictionary::file() const
{
    return shownFile(dict_.topDict().name());
}


std::string Foam::checkedDictionary::shownFile(const std::string& full)
{
    const auto constantAt = full.rfind("/constant/");
    const auto systemAt = full.rfind("/system/");
    const auto at = constantAt != std::string::npos ? constantAt : systemAt;
    return at == std::string::npos ? full : full.substr(at + 1);
}


std::string Foam::checkedDictionary::fullName(const word& name) const
{
    // OpenFOAM names a sub-dictionary file:outer:inner (v1912: by dots)
    std::string path(dict_.name());
    const std::string top(dict_.topDict().name());
    path = path.size() > top.size() ? path.substr(top.size() + 1) + "." : "";
    std::replace(path.begin(), path.end(), ':', '.');
    std::replace(path.begin(), path.end(), '/', '.');
    return path + name;
}


void Foam::checkedDictionary::fail
(
    const word& name,
    const std::string& foundValue,
    const std::string& expected
) const
{
    throw chesil::SetupError(file(), fullName(name), foundValue, expected);
}


void Foam::checkedDictionary::require
(
    const word& name,
    const std::string& expected
) const
{
    if (!dict_.found(name))
    {
        fail
        (
            name,
            "nothing (the entry is missing)",
            known_.empty()
          ? expected
          : expected + "; known names here: " + chesil::listOfNames(known_)
        );
    }
}


template<class Type>
Type Foam::checkedDictionary::read
(
    const word& name,
    const std::string& expected
) const
{
    require(name, expected);
    throwingErrors guard;
    try
    {
        return dict_.get<Type>(name);
    }
    catch (const Foam::error&)
    {
        fail(name, valueText(dict_, name), expected);
    }
}


Foam::scalar Foam::checkedDictionary::number
(
    const word& name,
    const std::string& expected
) const
{
    const scalar value = read<scalar>(name, expected);
    if (!std::isfinite(value))
    {
        fail(name, valueText(dict_, name), expected);
    }
    return value;
}


Foam::scalar Foam::checkedDictionary::number
(
    const word& name,
    scalar defaultValue
) const
{
    return found(name) ? number(name, "a finite number") : defaultValue;
}


Foam::scalar Foam::checkedDictionary::numberIn
(
    const word& name,
    scalar lower,
    scalar upper,
    const std::string& expected
) const
{
    const scalar value = number(name, expected);
    if (value < lower || value > upper)
    {
        fail(name, chesil::numberText(value), expected);
    }
    return value;
}


Foam::scalar Foam::checkedDictionary::positive(const word& name) const
{
    return numberIn(name, SMALL*VSMALL, VGREAT, "a number > 0");
}


Foam::scalar Foam::checkedDictionary::notNegative
(
    const word& name,
    scalar defaultValue
) const
{
    return
        found(name) ? numberIn(name, 0, VGREAT, "a number >= 0") : defaultValue;
}


Foam::label Foam::checkedDictionary::count(const word& name, label lower) const
{
    const std::string expected = "a whole number >= " + std::to_string(lower);
    const label value = read<label>(name, expected);
    if (value < lower)
    {
        fail(name, std::to_string(value), expected);
    }
    return value;
}


Foam::label Foam::checkedDictionary::count
(
    const word& name,
    label lower,
    label defaultValue
) const
{
    return found(name) ? count(name, lower) : defaultValue;
}


std::string Foam::checkedDictionary::text
(
    const word& name,
    const std::string& expected
) const
{
    require(name, expected);
    const entry& found = *dict_.findEntry(name);
    if (found.isStream() && found.stream().size() == 1)
    {
        const token& only = found.stream()[0];
        if (only.isWord())
        {
            return only.wordToken();
        }
        if (only.isString())
        {
            return only.stringToken();
        }
    }
    fail(name, valueText(dict_, name), expected);
}


std::string Foam::checkedDictionary::choice
(
    const word& name,
    const std::vector<std::string>& choices
) const
{
    const std::string expected = "one of: " + chesil::listOfNames(choices);
    const std::string value = text(name, expected);
    if (std::count(choices.begin(), choices.end(), value) == 0)
    {
        fail(name, value, expected);
    }
    return value;
}


bool Foam::checkedDictionary::flag(const word& name, bool defaultValue) const
{
    return found(name) ? bool(read<Switch>(name, "yes or no")) : defaultValue;
}


chesil::Vector2 Foam::checkedDictionary::planeVector(const word& name) const
{
    const std::string expected =
        "a finite vector in the x-y plane, (x y 0): grains are plane";
    const vector value = read<vector>(name, expected);
    if (!std::isfinite(value.x()) || !std::isfinite(value.y()) || value.z() != 0)
    {
        fail(name, valueText(dict_, name), expected);
    }
    return {value.x(), value.y()};
}


std::vector<chesil::Vector2> Foam::checkedDictionary::planePoints
(
    const word& name
) const
{
    const List<Vector2D<scalar>> values =
        read<List<Vector2D<scalar>>>(name, "a list of points ((x y) ...)");
    std::vector<chesil::Vector2> points;
    for (const Vector2D<scalar>& value : values)
    {
        points.emplace_back(value.x(), value.y());
    }
    return points;
}


std::vector<std::string> Foam::checkedDictionary::words(const word& name) const
{
    const wordList values = read<wordList>(name, "a list of names (a b ...)");
    return std::vector<std::string>(values.begin(), values.end());
}


std::vector<double> Foam::checkedDictionary::numbers(const word& name) const
{
    const std::string expected = "a list of finite numbers (a b ...)";
    const List<scalar> values = read<List<scalar>>(name, expected);
    for (const scalar value : values)
    {
        if (!std::isfinite(value))
        {
            fail(name, valueText(dict_, name), expected);
        }
    }
    return std::vector<double>(values.begin(), values.end());
}


std::vector<std::pair<std::string, double>>
Foam::checkedDictionary::namedNumbers(const word& name) const
{
    const std::string expected =
        "a list of names with finite numbers ((a 1) (b 2) ...)";
    std::vector<std::pair<std::string, double>> result;
    for (const auto& one : read<List<Tuple2<word, scalar>>>(name, expected))
    {
        if (!std::isfinite(one.second()))
        {
            fail(name, valueText(dict_, name), expected);
        }
        result.emplace_back(one.first(), one.second());
    }
    return result;
}


const Foam::dictionary& Foam::checkedDictionary::subDict(const word& name) const
{
    require(name, dictionaryWanted);
    if (!dict_.isDict(name))
    {
        fail(name, valueText(dict_, name), dictionaryWanted);
    }
    return dict_.subDict(name);
}


std::vector<Foam::word> Foam::checkedDictionary::subDictNames
(
    const dictionary& dict
)
{
    std::vector<word> names;
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            checkedDictionary(dict).fail
            (
                e.keyword(),
                valueText(dict, e.keyword()),
                dictionaryWanted
            );
        }
        names.push_back(e.keyword());
    }
    return names;
}


// ************************************************************************* //
