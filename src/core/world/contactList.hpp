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
    /// What entries carry beyond Contact: springs of friction and of rolling resistance.
    ContactList(bool withSprings, bool withTurns) : withSprings_(withSprings), withTurns_(withTurns) {}

    std::vector<Contact<2>>& contacts() { return contacts_; }
    const std::vector<Contact<2>>& contacts() const { return contacts_; }

    /// Entry i's elastic tangential displacement of the first body against the second [m]; empty without friction.
    const std::vector<Vector2>& springs() const { return springs_; }

    /// Entry i's elastic relative rotation [rad]; empty without rolling resistance.
    const std::vector<double>& turns() const { return turns_; }

    /// Null without friction.
    Vector2* springOf(std::size_t entry) { return withSprings_ ? &springs_[entry] : nullptr; }

    double* turnOf(std::size_t entry) { return withTurns_ ? &turns_[entry] : nullptr; }

    /// Entries of the pair that begins here.
    std::size_t placesOf(std::size_t entry) const
    {
        return entry + 1 < contacts_.size() && contacts_[entry + 1].place == 1 ? 2 : 1;
    }

    /// No contact: nothing is carried but where to look next.
    void release(std::size_t entry);

    /// Begins a new list; `add` in the order above, then `carryOver`.
    void restart();
    void add(std::int32_t first, std::int32_t second, bool flat);

    /// Goes on from entries written earlier; springs that they lack are at rest.
    void resume(std::vector<Contact<2>> contacts, std::vector<Vector2> springs, std::vector<double> turns);

    /// Pairs that were in the old list keep what they carry.
    void carryOver();

private:
    void take(std::size_t entry, std::size_t old);
    std::size_t firstWithWall(const std::vector<Contact<2>>& contacts) const;

    bool withSprings_;
    bool withTurns_;
    std::vector<Contact<2>> contacts_;
    std::vector<Vector2> springs_;
    std::vector<double> turns_;
    std::vector<Contact<2>> oldContacts_;
    std::vector<Vector2> oldSprings_;
    std::vector<double> oldTurns_;
};

} // namespace chesil
