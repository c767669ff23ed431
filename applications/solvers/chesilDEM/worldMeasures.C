/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "worldMeasures.H"
#include "OSspecific.H"

#include "core/measure/coordination.hpp"
#include "core/measure/enclosedArea.hpp"
#include "core/measure/energy.hpp"
#include "core/measure/fabric.hpp"
#include "core/measure/packing.hpp"
#include "core/measure/stress.hpp"

#include <cmath>
#include <map>
#include <optional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using chesil::World;
using Row = std::vector<double>;

struct Measure
{
    std::vector<std::string> (*columns)(const World&);
    Row (*row)(const World&);
};

//- As "nan" in the file: there is nothing to measure
double orNone(const std::optional<double>& value)
{
    return value ? *value : std::nan("");
}

std::optional<double> areaOf(const World& world)
{
    if (const chesil::StrainedCell* strained = world.cell())
    {
        const chesil::PeriodicCell& cell = strained->cell;
        const double area = std::abs(chesil::cross(cell.first(), cell.second()));
        return area > 0 ? std::optional<double>(area) : std::nullopt;
    }
    std::vector<std::pair<chesil::Vector2, chesil::Vector2>> halfPlanes;
    for (const chesil::PlaneWall<2>& wall : world.walls())
    {
        halfPlanes.emplace_back(wall.point, wall.normal);
    }
    return chesil::enclosedArea(halfPlanes);
}

std::vector<std::string> energyColumns(const World&)
{
    return
    {
        "kinetic [J]", "contacts [J]", "start [J]", "gravity [J]", "walls [J]",
        "contactLoss [J]", "localDampingLoss [J]", "viscousDampingLoss [J]",
        "residual [J]"
    };
}

Row energyRow(const World& world)
{
    const double kinetic = chesil::kineticEnergy(world.bodies());
    const double stored = world.contactEnergy();
    if (!world.energyLedger())
    {
        return {kinetic, stored, kinetic + stored, 0, 0, 0, 0, 0, 0};
    }
    const chesil::EnergyLedger& ledger = *world.energyLedger();
    return
    {
        kinetic, stored, ledger.start, ledger.gravity, ledger.walls,
        ledger.contacts, ledger.localDamping, ledger.viscousDamping,
        ledger.residual(kinetic, stored)
    };
}

std::vector<std::string> coordinationColumns(const World&)
{
    return
    {
        "mean [neighbours]", "withoutRattlers [neighbours]", "rattlers [grains]",
        "rattlerShare [-]"
    };
}

Row coordinationRow(const World& world)
{
    // A grain is held by two neighbours with friction, by three without
    const std::size_t least = world.springs().empty() ? 3 : 2;
    const chesil::Coordination found = chesil::coordination
    (
        world.contacts(),
        world.bodies().size(),
        least,
        chesil::WallContacts::counted
    );
    return
    {
        orNone(found.mean), orNone(found.meanWithoutRattlers),
        double(found.rattlers), orNone(found.rattlerShare)
    };
}

std::vector<std::string> stressColumns(const World&)
{
    return
    {
        "xx [Pa]", "xy [Pa]", "yx [Pa]", "yy [Pa]", "mean [Pa]",
        "deviatoric [Pa]", "direction [rad]", "mobilisedFriction [rad]"
    };
}

Row stressRow(const World& world)
{
    const std::optional<double> area = areaOf(world);
    if (!area)
    {
        return Row(8, std::nan(""));
    }
    const Eigen::Matrix2d stress = chesil::meanStress
    (
        world.contacts(),
        [&](const chesil::Contact<2>& contact)
        {
            return world.branchOf(contact);
        },
        *area
    );
    const chesil::StressMeasures found = chesil::stressMeasures(stress);
    return
    {
        stress(0, 0), stress(0, 1), stress(1, 0), stress(1, 1), found.mean,
        found.deviatoric, orNone(found.direction),
        orNone(found.mobilisedFriction)
    };
}

std::vector<std::string> fabricColumns(const World&)
{
    return
    {
        "normals [-]", "direction [rad]", "meanNormalForce [N]",
        "normalForces [-]", "tangentialForces [-]", "stressRatio [-]"
    };
}

Row fabricRow(const World& world)
{
    const chesil::DirectionalAverages found = chesil::directionalAverages
        (world.contacts(), chesil::WallContacts::leftOut);
    return
    {
        found.normals.amplitude(), orNone(found.normals.direction()),
        found.normalForce, found.normalForces.amplitude(),
        found.tangentialForces.amplitude(), orNone(found.stressRatio())
    };
}

std::vector<std::string> packingColumns(const World&)
{
    return {"area [m2]", "solidFraction [-]", "voidRatio [-]"};
}

Row packingRow(const World& world)
{
    const std::optional<double> area = areaOf(world);
    if (!area)
    {
        return Row(3, std::nan(""));
    }
    std::vector<double> areas;
    for (std::size_t i = 0; i < world.bodies().size(); ++i)
    {
        areas.push_back(world.areaOf(i));
    }
    const chesil::Packing found = chesil::packing(areas, *area);
    return {*area, found.solidFraction, orNone(found.voidRatio)};
}

std::vector<std::string> wallColumns(const World& world)
{
    std::vector<std::string> names;
    for (const chesil::PlaneWall<2>& wall : world.walls())
    {
        for (const char* quantity : {"x [m]", "y [m]", "Fx [N]", "Fy [N]"})
        {
            names.push_back(wall.name + "." + quantity);
        }
    }
    return names;
}

Row wallRow(const World& world)
{
    Row row;
    for (std::size_t w = 0; w < world.walls().size(); ++w)
    {
        const chesil::Vector2& point = world.walls()[w].point;
        const chesil::Vector2& force = world.wallStates()[w].force;
        row.insert(row.end(), {point.x(), point.y(), force.x(), force.y()});
    }
    return row;
}

//- The names stand in worldSettingsReader.C, too, which refuses others
const std::map<std::string, Measure> measures
{
    {"energy", {energyColumns, energyRow}},
    {"coordination", {coordinationColumns, coordinationRow}},
    {"stress", {stressColumns, stressRow}},
    {"fabric", {fabricColumns, fabricRow}},
    {"packing", {packingColumns, packingRow}},
    {"walls", {wallColumns, wallRow}}
};

} // End namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::worldMeasures::worldMeasures
(
    const Time& runTime,
    const std::vector<std::string>& names,
    const chesil::World& world
)
:
    names_(names),
    files_(label(names.size()))
{
    const fileName folder
        (runTime.globalPath()/"postProcessing"/"chesilDEM"/runTime.timeName());
    mkDir(folder);
    forAll(files_, i)
    {
        const std::string& name = names_[std::size_t(i)];
        files_.set(i, new OFstream(folder/(name + ".dat")));
        files_[i].precision(12);
        files_[i] << "# Time [s]";
        for (const std::string& column : measures.at(name).columns(world))
        {
            files_[i] << '\t' << column.c_str();
        }
        files_[i] << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::worldMeasures::write(scalar time, const chesil::World& world)
{
    forAll(files_, i)
    {
        files_[i] << time;
        for (const double value : measures.at(names_[std::size_t(i)]).row(world))
        {
            files_[i] << '\t' << value;
        }
        files_[i] << endl;
    }
}


// ************************************************************************* //
