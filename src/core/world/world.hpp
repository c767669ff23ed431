#pragma once

#include "core/broadphase/neighbourSearch.hpp"
#include "core/contact/contactGeometry.hpp"
#include "core/contact/sideChange.hpp"
#include "core/dynamics/bodies.hpp"
#include "core/measure/energyLedger.hpp"
#include "core/world/contactList.hpp"
#include "core/world/flatContact.hpp"
#include "core/world/pairContact.hpp"
#include "core/world/wallStates.hpp"
#include "core/world/worldSettings.hpp"
#include "core/world/worldState.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace chesil
{

/// How a step ended.
enum class StepStatus
{
    done,
    /// A grain's position or velocity is no longer a finite number; `World::brokenGrain` tells which.
    notFinite,
    /// A contact is so deep that it is stiffer than the stable step allows for, and its law does not hold any more
    /// (HertzMindlinLaw::mostOverlap), or so deep that two grains are about to pass through each other
    /// (mostTravel.hpp); `World::brokenGrain` tells where.
    tooDeep,
    /// A grain has moved so far in this step that it may have leapt over another (mostTravel.hpp): the step is refused
    /// before its forces are known. `World::brokenGrain` tells which.
    tooFast,
    /// The cell is so strained that a pair could meet by two images (NeighbourSearch::find): refused in the same way.
    tooNarrow,
    /// The time step is no positive finite number: nothing was done.
    badTimeStep,
};

/// "the state of grain 3 is no finite number", for the statuses that are failures.
std::string describe(StepStatus status, std::size_t brokenGrain);

/// What the contact queries of grain pairs have cost since the start.
struct ContactStatistics
{
    std::size_t queries = 0;
    /// Of these, ended in a contact.
    std::size_t contacts = 0;
    /// Support points of A - B (QueryCost).
    std::size_t supportCalls = 0;
    /// Of the queries, decided by a sweep over all directions.
    std::size_t sweeps = 0;
};

/// Grains, walls and contacts, and the step that moves them. One owner, no global state; the same settings give
/// the same bits.
class World
{
public:
    /// The settings must have been checked by whoever read them (positive density, unit normals, known shapes).
    explicit World(WorldSettings settings);

    /// One step of velocity Verlet [s].
    StepStatus step(double timeStep);

    /// Contacts and forces of the state as it is, without moving anything or stretching friction's springs. Wanted once
    /// before the first step, and again whenever loads from outside have changed.
    void updateForces();

    /// Forces [N] and torques [N m] from outside (a fluid, say), held until set again; entry i for grain i.
    void setExternalLoads(const std::vector<Vector2>& forces, const std::vector<double>& torques);

    /// Puts the grains into a fluid of the given density [kg/m3]: weights become weight less buoyancy, and each
    /// grain's inertia is raised by `virtualMass` times that of the fluid it displaces. The coupling gives the
    /// virtual part of the force back; see doc/coupling.md.
    void immerse(double fluidDensity, double virtualMass);

    /// Largest stable step [s] over all grains that move; infinite if none does.
    double stableTimeStep() const;

    /// As they are now, in the order of the settings; what they feel and do.
    const std::vector<PlaneWall<2>>& walls() const { return walls_.walls(); }
    const std::vector<WallState>& wallStates() const { return walls_.states(); }

    /// Begun with the first step; null unless the settings ask for it.
    const EnergyLedger* energyLedger() const { return ledger_ ? &*ledger_ : nullptr; }

    /// As it is now; null without.
    const StrainedCell* cell() const { return cell_ ? &*cell_ : nullptr; }

    /// From now on, with a periodic cell [1/s]; all grains take on the new flow.
    void setVelocityGradient(const Eigen::Matrix2d& gradient);

    /// From the first body's centroid to that of the second one's image, to the contact point if that is a wall [m].
    Vector2 branchOf(const Contact<2>& contact) const;

    /// Since the start [s].
    double time() const { return time_; }

    /// Without the grains: they are bodies now.
    const WorldSettings& settings() const { return settings_; }
    const Bodies<2>& bodies() const { return bodies_; }

    /// Near pairs, those in contact with depth > 0, sorted; grains with grains first, then with walls. A pair of shapes
    /// with straight sides has two entries, for both ends of a flat contact.
    const std::vector<Contact<2>>& contacts() const { return list_.contacts(); }

    /// Entry i's elastic tangential displacement of the first body against the second [m], along the normal turned by
    /// +90 degrees; empty without friction.
    const std::vector<double>& springs() const { return list_.springs(); }

    /// Stored in all contacts [J].
    double contactEnergy() const;

    const Shape& shapeOf(std::size_t grain) const
    {
        return settings_.shapes[static_cast<std::size_t>(bodies_.shape[grain])].shape;
    }

    /// Area [m2] of grain i, and diameter of the disk of the same area [m].
    double areaOf(std::size_t grain) const { return masses_[static_cast<std::size_t>(bodies_.shape[grain])].area; }
    double polarMomentOf(std::size_t grain) const { return masses_[static_cast<std::size_t>(bodies_.shape[grain])].polarMoment; }
    double sizeOf(std::size_t grain) const;

    /// Weight of grain i, less its buoyancy once immersed [N].
    Vector2 weightOf(std::size_t grain) const;

    /// Largest overlap of a contact over the size of its smaller grain.
    double largestRelativeOverlap() const;

    std::size_t brokenGrain() const { return brokenGrain_; }

    /// How often since the start a pair query ended without the full answer: see PairStatus.
    std::size_t doubtfulQueries() const { return doubtfulQueries_; }

    /// All that is carried on; resume throws ValueError for the state of other grains or walls. A law with friction or
    /// rolling resistance that the state has none of begins with springs at rest.
    WorldState state() const;
    void resume(WorldState state);

    /// Zeros unless WorldSettings::contactStatistics asks for them.
    const ContactStatistics& contactStatistics() const { return contactStatistics_; }

private:
    template <bool periodic>
    bool moveGrains(double timeStep);
    void noteStrain();
    void updateForces(double timeStep, bool stale);
    void findNeighbours();
    void noteBoxes();
    void findContacts();
    std::vector<PairKey> withBothPlaces(const std::vector<PairKey>& pairs) const;
    double mostMovement() const;
    bool neighboursAreStale() const;
    template <bool periodic>
    bool hasLeft(std::size_t grain, double most) const;
    void wrapGrains();
    void applyWeights();
    void addBody(const GrainState& grain);
    StepStatus finishMoves(double timeStep);
    bool isStraightSided(std::size_t grain) const { return straightSided_[static_cast<std::size_t>(bodies_.shape[grain])]; }
    std::size_t materialOf(std::size_t grain) const { return materialOf_.empty() ? 0 : static_cast<std::size_t>(materialOf_[grain]); }
    double densityOf(std::size_t grain) const { return settings_.materials[materialOf(grain)].density; }
    double largestStiffness(double radius) const;
    template <bool periodic, class Law>
    void resolveAll(const LawTable<Law>& laws, double timeStep);
    template <class Law>
    const Law& lawOf(const LawTable<Law>& laws, const Contact<2>& contact) const;
    void resolveContacts(double timeStep);
    template <bool periodic, class Law>
    std::size_t resolveDisks(const LawTable<Law>& laws, double timeStep);
    template <bool periodic, class Law>
    void resolve(const LawTable<Law>& laws, std::size_t index, double timeStep);
    Pose<2> imageOfSecond(const Contact<2>& contact) const;
    Vector2 offsetOf(const Contact<2>& contact) const { return cell_->cell.offset(contact.shift); }
    bool touchesGrain(Contact<2>& contact, ContactGeometry<2>& found);
    PairStatus queryGrains(Contact<2>& contact, const Pose<2>& poseJ, ContactGeometry<2>& found);
    bool touchesWall(Contact<2>& contact, ContactGeometry<2>& found) const;
    bool areFlat(const Contact<2>& contact, const ContactGeometry<2>& found, std::array<FlatGeometry, 2>& places) const;
    template <bool periodic, class Law>
    void load(const Law& law, std::size_t index, const ContactGeometry<2>& geometry, double timeStep, const PlaceShare& share = {});
    void noteDepth(const Contact<2>& contact, double way);
    struct Meeting;
    template <bool periodic>
    Meeting meetingAt(const Contact<2>& contact) const;
    template <bool periodic, class Law>
    void loadBodies(const Law& law, std::size_t index, double previousDepth, double timeStep, const PlaceShare& share);
    template <bool periodic>
    void push(const Contact<2>& contact, const Meeting& meeting, const Vector2& force, double couple, double timeStep);
    template <bool periodic>
    void noteSideChange(Contact<2>& contact, const SideHeld<2>& before, double timeStep);
    double effectiveRadius(const Contact<2>& contact) const;
    double rollingRadius(const Contact<2>& contact) const;
    void noteStiffness(std::size_t i, std::size_t j, const ContactSprings& springs);
    template <class Law>
    void release(const Law& law, std::size_t index);
    template <class Law>
    ContactState<2> stateAtRest(std::size_t index) const;
    template <class Law>
    double energyOf(const Law& law, std::size_t index) const;
    /// Of the tangential spring and that of rolling resistance [J]: what is lost when the contact ends.
    double springEnergyOf(const ContactSprings& stiffness, double rollingFriction, std::size_t index) const;
    template <class Damping>
    void withLoss(double EnergyLedger::*loss, double timeStep, const Damping& damp);
    void addWorks(double timeStep);
    StepStatus brokenState();
    bool leaps(double timeStep);
    void anticipate(double timeStep);
    double brakingRate() const;
    bool cellIsNarrow() const;
    double innerRadiusOf(std::size_t grain) const { return innerRadii_[static_cast<std::size_t>(bodies_.shape[grain])]; }
    /// Looked for by the upright box about it, not by the circle: the box is narrower, but no longer holds once the grain
    /// has turned.
    bool isSlender(std::size_t grain) const { return bodies_.boundingRadius[grain] > 2 * innerRadiusOf(grain); }

    WorldSettings settings_;
    std::vector<MassProperties> masses_;
    std::vector<bool> straightSided_;
    bool onlyDisks_ = true;
    /// Of each shape [m].
    std::vector<double> innerRadii_;
    /// Of each shape: largest stiffness of its contacts that the stable step allows for [N/m].
    std::vector<double> stiffness_;
    Bodies<2> bodies_;
    /// Of each grain; empty if there is but one.
    std::vector<std::int32_t> materialOf_;
    double fluidDensity_ = 0;
    std::vector<Vector2> externalForces_;
    std::vector<double> externalTorques_;

    NeighbourSearch search_;
    double skin_ = 0;
    /// Between the centroids of two near grains [m], at most.
    double largestReach_ = 0;
    std::vector<Vector2> positionsAtSearch_;
    /// Of each grain's upright box about its centroid [m], and its angle then [rad]; empty unless there are slender grains.
    std::vector<Vector2> halfExtents_;
    std::vector<double> anglesAtSearch_;
    std::optional<StrainedCell> cell_;
    Vector2 firstAtSearch_ = Vector2::Zero();
    Vector2 secondAtSearch_ = Vector2::Zero();
    /// What is added to a position at the last search when the cell is strained.
    Eigen::Matrix2d strainSinceSearch_ = Eigen::Matrix2d::Zero();
    ContactList list_;
    WallStates walls_;
    double time_ = 0;
    /// Most that a dashpot's force changes its own velocity, over the time step [1/s].
    double brakingRate_ = 0;
    /// Whether in this step that change counts: contactForce.hpp.
    bool anticipates_ = false;
    /// Of each grain's velocity until the step's end, if forces stayed as they were [m/s]; only then.
    std::vector<Vector2> expectedGains_;
    std::optional<EnergyLedger> ledger_;
    /// No contact that is less deep can be about to pass through [m].
    double shallow_ = 0;
    bool tooDeep_ = false;
    /// A position was no finite number at the last search.
    bool lost_ = false;
    std::size_t brokenGrain_ = 0;
    std::size_t doubtfulQueries_ = 0;
    ContactStatistics contactStatistics_;
};

template <class Law>
const Law& World::lawOf(const LawTable<Law>& laws, const Contact<2>& contact) const
{
    if (laws.materials() == 1)
    {
        return laws.of(0, 0);
    }
    const std::size_t other = contact.withWall() ? static_cast<std::size_t>(walls()[contact.wall()].material)
                                                 : materialOf(static_cast<std::size_t>(contact.second));
    return laws.of(materialOf(static_cast<std::size_t>(contact.first)), other);
}

template <class Law>
ContactState<2> World::stateAtRest(std::size_t index) const
{
    ContactState<2> state{contacts()[index].depth, contacts()[index].normal, Vector2::Zero(), 0};
    if constexpr (Law::usesCurvature)
    {
        state.effectiveRadius = list_.radii()[index];
    }
    return state;
}

// Written so that a position that is not a number asks for a search, too.
template <bool periodic>
bool World::hasLeft(std::size_t grain, double most) const
{
    const Vector2& old = positionsAtSearch_[grain];
    Vector2 moved = bodies_.pose[grain].position - old;
    if constexpr (periodic)
    {
        moved -= strainSinceSearch_ * (old - cell_->cell.lower());
    }
    double left = most;
    if (!anglesAtSearch_.empty() && isSlender(grain))
    {
        left -= bodies_.boundingRadius[grain] * std::abs(bodies_.pose[grain].rotation.angle() - anglesAtSearch_[grain]);
    }
    return !(left > 0 && moved.squaredNorm() <= left * left);
}

} // namespace chesil
