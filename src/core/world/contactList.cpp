#include "core/world/contactList.hpp"

#include "core/base/roomToGrow.hpp"

namespace chesil
{

void ContactList::release(std::size_t entry)
{
    Contact<2>& contact = contacts_[entry];
    contact.depth = 0;
    contact.force = Vector2::Zero();
    if (withSprings_)
    {
        springs_[entry] = 0;
    }
    if (withTurns_)
    {
        turns_[entry] = 0;
    }
}

void ContactList::resume(
    std::vector<Contact<2>> contacts, std::vector<double> springs, std::vector<double> turns, std::vector<double> radii)
{
    radii_ = std::move(radii);
    contacts_ = std::move(contacts);
    springs_ = std::move(springs);
    turns_ = std::move(turns);
    resize(contacts_.size());
}

/// Entries that go on move to the front, then, from the last one on, to their new places: never before one that has
/// still to be moved, since both lists are sorted by key.
void ContactList::renew(const std::vector<PairKey>& coming)
{
    std::size_t kept = keepWhatComes(coming);
    resize(coming.size());
    for (std::size_t entry = coming.size(); entry-- > 0;)
    {
        if (kept > 0 && contacts_[kept - 1].key() == coming[entry])
        {
            move(--kept, entry);
        }
        else
        {
            contacts_[entry] = {};
            release(entry);
        }
        static_cast<PairKey&>(contacts_[entry]) = coming[entry];
    }
}

std::size_t ContactList::keepWhatComes(const std::vector<PairKey>& coming)
{
    std::size_t kept = 0;
    auto next = coming.begin();
    for (std::size_t old = 0; old < contacts_.size(); ++old)
    {
        while (next != coming.end() && *next < contacts_[old].key())
        {
            ++next;
        }
        if (next != coming.end() && *next == contacts_[old].key())
        {
            move(old, kept++);
        }
    }
    return kept;
}

void ContactList::move(std::size_t from, std::size_t to)
{
    contacts_[to] = contacts_[from];
    if (withSprings_)
    {
        springs_[to] = springs_[from];
    }
    if (withTurns_)
    {
        turns_[to] = turns_[from];
    }
    if (withRadii_)
    {
        radii_[to] = radii_[from];
    }
}

void ContactList::resize(std::size_t size)
{
    const auto resized = [](auto& array, std::size_t entries)
    {
        makeRoom(array, entries);
        array.resize(entries);
    };
    resized(contacts_, size);
    resized(springs_, withSprings_ ? size : 0);
    resized(turns_, withTurns_ ? size : 0);
    resized(radii_, withRadii_ ? size : 0);
}

std::size_t ContactList::bytes() const
{
    const auto of = [](const auto& array) { return array.capacity() * sizeof(array[0]); };
    return of(contacts_) + of(springs_) + of(turns_) + of(radii_);
}

} // namespace chesil
