#pragma once

#include "core/contact/contact.hpp"

#include <cstdint>
#include <vector>

namespace chesil
{

/// Near pairs and what they carry from step to step: pairs of grains sorted by both, then those with walls sorted by
/// grain. A pair with straight sides on both has two entries, for both ends of a flat contact.
class ContactList
{
public:
    /// What entries carry beyond Contact: springs of friction and of rolling resistance, radii at the touch.
    ContactList(bool withSprings, bool withTurns, bool withRadii)
    : withSprings_(withSprings), withTurns_(withTurns), withRadii_(withRadii)
    {
    }

    std::vector<Contact<2>>& contacts() { return contacts_; }
    const std::vector<Contact<2>>& contacts() const { return contacts_; }

    /// Entry i's elastic tangential displacement of the first body against the second [m], along the normal turned by
    /// +90 degrees; empty without friction.
    const std::vector<double>& springs() const { return springs_; }

    /// Entry i's elastic relative rotation [rad]; empty without rolling resistance.
    const std::vector<double>& turns() const { return turns_; }

    /// Entry i's effective radius of curvature when it began to touch [m]; empty if the law does not use it.
    const std::vector<double>& radii() const { return radii_; }
    double& radiusOf(std::size_t entry) { return radii_[entry]; }

    /// Null without friction.
    double* springOf(std::size_t entry) { return withSprings_ ? &springs_[entry] : nullptr; }

    double* turnOf(std::size_t entry) { return withTurns_ ? &turns_[entry] : nullptr; }

    /// Entries of the pair that begins here.
    std::size_t placesOf(std::size_t entry) const
    {
        return entry + 1 < contacts_.size() && contacts_[entry + 1].place == 1 ? 2 : 1;
    }

    /// No contact: nothing is carried but where to look next.
    void release(std::size_t entry);

    /// A new list, sorted; pairs that were in the old one keep what they carry. Done in place.
    void renew(const std::vector<PairKey>& coming);

    /// Goes on from entries written earlier; springs that they lack are at rest.
    void resume(
        std::vector<Contact<2>> contacts, std::vector<double> springs, std::vector<double> turns, std::vector<double> radii);

    /// Memory held [bytes].
    std::size_t bytes() const;

private:
    std::size_t keepWhatComes(const std::vector<PairKey>& coming);
    void move(std::size_t from, std::size_t to);
    void resize(std::size_t size);

    bool withSprings_;
    bool withTurns_;
    bool withRadii_;
    std::vector<Contact<2>> contacts_;
    std::vector<double> springs_;
    std::vector<double> turns_;
    std::vector<double> radii_;
};

} // namespace chesil
