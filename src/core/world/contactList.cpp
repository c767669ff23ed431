#include "core/world/contactList.hpp"

namespace chesil
{

namespace
{

/// With a little room for growth: doubling would show in the memory of big scenes.
template <class Array>
void fit(Array& array, std::size_t entries)
{
    if (entries > array.capacity())
    {
        array.reserve(entries + entries / 16);
    }
}

} // namespace

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

void ContactList::restart(std::size_t expected)
{
    coming_.clear();
    fit(coming_, expected);
}

void ContactList::add(std::int32_t first, std::int32_t second, bool flat, NearShift shift)
{
    coming_.push_back({first, second, 0, shift});
    if (flat)
    {
        coming_.push_back({first, second, 1, shift});
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
void ContactList::carryOver()
{
    std::size_t kept = keepWhatComes();
    resize(coming_.size());
    for (std::size_t entry = coming_.size(); entry-- > 0;)
    {
        if (kept > 0 && contacts_[kept - 1].key() == coming_[entry])
        {
            move(--kept, entry);
        }
        else
        {
            contacts_[entry] = {};
            release(entry);
        }
        static_cast<ContactKey&>(contacts_[entry]) = coming_[entry];
    }
}

std::size_t ContactList::keepWhatComes()
{
    std::size_t kept = 0;
    auto next = coming_.begin();
    for (std::size_t old = 0; old < contacts_.size(); ++old)
    {
        while (next != coming_.end() && *next < contacts_[old].key())
        {
            ++next;
        }
        if (next != coming_.end() && *next == contacts_[old].key())
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
        fit(array, entries);
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
    return of(contacts_) + of(springs_) + of(turns_) + of(radii_) + of(coming_);
}

} // namespace chesil
