#include "core/world/namedMeasures.hpp"

#include "core/base/setupError.hpp"
#include "core/measure/alignment.hpp"
#include "core/measure/coordination.hpp"
#include "core/measure/enclosedArea.hpp"
#include "core/measure/energy.hpp"
#include "core/measure/fabric.hpp"
#include "core/measure/packing.hpp"
#include "core/measure/polarHistogram.hpp"
#include "core/measure/stress.hpp"
#include "core/measure/unbalanced.hpp"
#include "core/shapes/longAxis.hpp"
#include "core/world/resultantForces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace chesil
{

namespace
{

using Names = std::vector<std::string>;
using Row = std::vector<double>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Of 5 degrees, over a half turn.
constexpr std::size_t roseBins = 36;

/// The last share of coordination is that of so many and more.
constexpr std::size_t mostNeighbours = 9;

/// That of the periodic cell, else of what the walls enclose.
std::optional<double> areaOf(const World& world)
{
    if (world.cell())
    {
        const PeriodicCell& cell = world.cell()->cell;
        const double area = std::abs(cross(cell.first(), cell.second()));
        return area > 0 ? std::optional<double>(area) : std::nullopt;
    }
    std::vector<std::pair<Vector2, Vector2>> halfPlanes;
    for (const PlaneWall<2>& wall : world.walls())
    {
        if (!wall.plate)
        {
            halfPlanes.emplace_back(wall.point, wall.normal);
        }
    }
    return enclosedArea(halfPlanes);
}

Names energyColumns(const World&)
{
    return {"kinetic [J]", "contacts [J]", "start [J]", "gravity [J]", "walls [J]", "contactLoss [J]", "localDampingLoss [J]",
            "viscousDampingLoss [J]", "residual [J]"};
}

Row energyRow(const World& world)
{
    const double kinetic = kineticEnergy(world.bodies());
    const double stored = world.contactEnergy();
    if (!world.energyLedger())
    {
        return {kinetic, stored, kinetic + stored, 0, 0, 0, 0, 0, 0};
    }
    const EnergyLedger& ledger = *world.energyLedger();
    return {kinetic, stored, ledger.start, ledger.gravity, ledger.walls, ledger.contacts, ledger.localDamping,
            ledger.viscousDamping, ledger.residual(kinetic, stored)};
}

Names coordinationColumns(const World&)
{
    Names names{"mean [neighbours]", "withoutRattlers [neighbours]", "rattlers [grains]", "rattlerShare [-]"};
    for (std::size_t neighbours = 0; neighbours <= mostNeighbours; ++neighbours)
    {
        names.push_back("share" + std::to_string(neighbours) + " [-]");
    }
    return names;
}

Row coordinationRow(const World& world)
{
    // A grain is held by two neighbours with friction, by three without.
    const std::size_t least = world.springs().empty() ? 3 : 2;
    const Coordination found = coordination(world.contacts(), world.bodies().size(), least, WallContacts::counted);
    Row row{found.mean.value_or(none), found.meanWithoutRattlers.value_or(none), static_cast<double>(found.rattlers),
            found.rattlerShare.value_or(none)};
    const std::size_t first = row.size();
    row.resize(first + mostNeighbours + 1, 0);
    for (std::size_t neighbours = 0; neighbours < found.histogram.size(); ++neighbours)
    {
        row[first + std::min(neighbours, mostNeighbours)] +=
            static_cast<double>(found.histogram[neighbours]) / static_cast<double>(world.bodies().size());
    }
    return row;
}

Names stressColumns(const World&)
{
    return {"xx [Pa]", "xy [Pa]", "yx [Pa]", "yy [Pa]", "mean [Pa]", "deviatoric [Pa]", "direction [rad]",
            "mobilisedFriction [rad]"};
}

Row stressRow(const World& world)
{
    const std::optional<double> area = areaOf(world);
    if (!area)
    {
        return Row(8, none);
    }
    const auto branch = [&](const Contact<2>& contact) { return world.branchOf(contact); };
    const Eigen::Matrix2d stress = meanStress(world.contacts(), branch, *area);
    const StressMeasures found = stressMeasures(stress);
    return {stress(0, 0), stress(0, 1), stress(1, 0), stress(1, 1), found.mean, found.deviatoric,
            found.direction.value_or(none), found.mobilisedFriction.value_or(none)};
}

Names fabricColumns(const World&)
{
    return {"normals [-]", "direction [rad]", "meanNormalForce [N]", "normalForces [-]", "normalForcesDirection [rad]",
            "tangentialForces [-]", "tangentialForcesDirection [rad]", "stressRatio [-]"};
}

Row fabricRow(const World& world)
{
    const DirectionalAverages found = directionalAverages(world.contacts(), WallContacts::leftOut);
    return {found.normals.amplitude(), found.normals.direction().value_or(none), found.normalForce,
            found.normalForces.amplitude(), found.normalForces.direction().value_or(none),
            found.tangentialForces.amplitude(), found.tangentialForces.direction().value_or(none),
            found.stressRatio().value_or(none)};
}

/// "density5 [1/rad]" for the bin about 5 degrees.
void addRose(Names& names, const std::string& quantity, const std::string& unit)
{
    for (std::size_t bin = 0; bin < roseBins; ++bin)
    {
        names.push_back(quantity + std::to_string(180 * bin / roseBins) + unit);
    }
}

Names roseColumns(const World&)
{
    Names names;
    using Heading = std::pair<std::string, std::string>;
    for (const auto& [quantity, unit] :
         {Heading("density", " [1/rad]"), Heading("normalForce", " [N]"), Heading("tangentialForce", " [N]")})
    {
        addRose(names, quantity, unit);
    }
    return names;
}

Row roseRow(const World& world)
{
    const std::vector<PolarBin> bins = polarHistogram(world.contacts(), roseBins, WallContacts::leftOut);
    Row row;
    for (const PolarBin& bin : bins)
    {
        row.push_back(bin.density);
    }
    for (const auto& force : {&PolarBin::normalForce, &PolarBin::tangentialForce})
    {
        for (const PolarBin& bin : bins)
        {
            row.push_back((bin.*force).value_or(none));
        }
    }
    return row;
}

Names packingColumns(const World&)
{
    return {"area [m2]", "solidFraction [-]", "voidRatio [-]"};
}

Row packingRow(const World& world)
{
    const std::optional<double> area = areaOf(world);
    if (!area)
    {
        return Row(3, none);
    }
    std::vector<double> areas;
    for (std::size_t i = 0; i < world.bodies().size(); ++i)
    {
        areas.push_back(world.areaOf(i));
    }
    const Packing found = packing(areas, *area);
    return {*area, found.solidFraction, found.voidRatio.value_or(none)};
}

Names alignmentColumns(const World&)
{
    Names names{"order [-]", "director [rad]", "grains [grains]"};
    addRose(names, "density", " [1/rad]");
    return names;
}

Row alignmentRow(const World& world)
{
    std::vector<std::optional<double>> axisOfShape;
    for (const NamedShape& named : world.settings().shapes)
    {
        axisOfShape.push_back(longAxis(named.shape));
    }
    const Bodies<2>& bodies = world.bodies();
    std::vector<double> angles;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        if (const std::optional<double>& axis = axisOfShape[static_cast<std::size_t>(bodies.shape[i])])
        {
            angles.push_back(*axis + bodies.pose[i].rotation.angle());
        }
    }
    const std::optional<SecondHarmonic> found = alignment(angles);
    const auto number = static_cast<double>(angles.size());
    Row row = found ? Row{found->amplitude(), found->direction().value_or(none), number} : Row{none, none, number};
    for (const std::size_t grains : roseHistogram(angles, roseBins))
    {
        // An axis has two ends: over the full turn the integral is 1, as of contact normals.
        row.push_back(number > 0 ? static_cast<double>(grains) / number * roseBins / (2 * M_PI) : 0);
    }
    return row;
}

Names unbalancedColumns(const World&)
{
    return {"largest [-]", "mean [-]"};
}

Row unbalancedRow(const World& world)
{
    const auto found = unbalancedForce(resultantForces(world), world.bodies().inverseMass, world.contacts());
    return found ? Row{found->largest, found->mean} : Row{none, none};
}

Names wallColumns(const World& world)
{
    Names names;
    for (const PlaneWall<2>& wall : world.walls())
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
        const Vector2& point = world.walls()[w].point;
        const Vector2& force = world.wallStates()[w].force;
        row.insert(row.end(), {point.x(), point.y(), force.x(), force.y()});
    }
    return row;
}

} // namespace

const std::vector<NamedMeasure>& namedMeasures()
{
    static const std::vector<NamedMeasure> measures{
        {"energy", energyColumns, energyRow},
        {"coordination", coordinationColumns, coordinationRow},
        {"stress", stressColumns, stressRow},
        {"fabric", fabricColumns, fabricRow},
        {"roses", roseColumns, roseRow},
        {"packing", packingColumns, packingRow},
        {"alignment", alignmentColumns, alignmentRow},
        {"unbalanced", unbalancedColumns, unbalancedRow},
        {"walls", wallColumns, wallRow},
    };
    return measures;
}

std::vector<std::string> measureNames()
{
    std::vector<std::string> names;
    for (const NamedMeasure& measure : namedMeasures())
    {
        names.emplace_back(measure.name);
    }
    return names;
}

const NamedMeasure& measureNamed(const std::string& name)
{
    const std::vector<NamedMeasure>& all = namedMeasures();
    const auto found = std::find_if(all.begin(), all.end(), [&](const NamedMeasure& measure) { return measure.name == name; });
    if (found == all.end())
    {
        throw ValueError("measure " + name, "one of: " + listOfNames(measureNames()));
    }
    return *found;
}

} // namespace chesil
