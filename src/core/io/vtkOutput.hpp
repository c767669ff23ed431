#pragma once

#include "core/world/world.hpp"

#include <string>
#include <utility>
#include <vector>

namespace chesil
{

/// Pictures of a run for ParaView: `<case>/grains/grains_<n>.vtp`, one closed polygon a grain along its true
/// curved outline, `<case>/grains/walls.vtp` (walls and a periodic cell's outline; those that move: as they are at the
/// last state), and the index `<case>/grains.pvd`; if asked for, `<case>/grains/contacts_<n>.vtp`, a line a contact from
/// centroid to centroid (of the image that is met) or to the point on a wall, with `normalForce` (compression positive)
/// and `tangentialForce` [N], `overlap` [m], and `first` and `second` grain (wall w: -1 - w). All are written aside and renamed, so that none is ever seen half
/// written. Throws SetupError if a file cannot be written.
class VtkOutput
{
public:
    /// Makes the folder, removes the grains_<n>.vtp and contacts_<n>.vtp of an earlier run, but for the first ones, of the states at `times`
    /// [s] that this run goes on from, and writes the walls.
    VtkOutput(std::string caseFolder, const World& world, const std::vector<double>& times = {}, bool withContacts = false);

    /// The state at `time` [s], and the index of all states written so far.
    void write(const World& world, double time);

    /// Of all states written so far [s].
    std::vector<double> times() const;

private:
    static std::string nameOf(std::size_t index, const char* what = "grains");
    void writeWalls(const World& world) const;
    void writeContacts(const World& world) const;
    void writeIndex() const;

    std::string caseFolder_;
    bool withContacts_;
    std::vector<std::pair<double, std::string>> written_;
};

} // namespace chesil
