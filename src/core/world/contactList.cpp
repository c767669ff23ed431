#include "core/world/contactList.hpp"

#include <algorithm>

namespace chesil
{

void ContactList::release(std::size_t entry)
{
    Contact<2>& contact = contacts_[entry];
    contact.depth = 0;
    contact.force = Vector2::Zero();
    if (withSprings_)
    {
        springs_[entry] = Vector2::Zero();
    }
    if (withTurns_)
    {
        turns_[entry] = 0;
    }
}

void ContactList::restart()
{
    std::swap(contacts_, oldContacts_);
    std::swap(springs_, oldSprings_);
    std::swap(turns_, oldTurns_);
    contacts_.clear();
}

void ContactList::add(std::int32_t first, std::int32_t second, bool flat)
{
    contacts_.push_back({first, second});
    if (flat)
    {
        contacts_.push_back({first, second, 1});
    }
}

void ContactList::resume(std::vector<Contact<2>> contacts, std::vector<Vector2> springs, std::vector<double> turns)
{
    contacts_ = std::move(contacts);
    springs_ = std::move(springs);
    turns_ = std::move(turns);
    springs_.resize(withSprings_ ? contacts_.size() : 0, Vector2::Zero());
    turns_.resize(withTurns_ ? contacts_.size() : 0, 0.0);
}

void ContactList::carryOver()
{
    springs_.assign(withSprings_ ? contacts_.size() : 0, Vector2::Zero());
    turns_.assign(withTurns_ ? contacts_.size() : 0, 0.0);
    const auto carry = [this](std::size_t entry, std::size_t end, std::size_t old, std::size_t oldEnd)
    {
        while (entry != end && old != oldEnd)
        {
            const auto key = contacts_[entry].key();
            const auto oldKey = oldContacts_[old].key();
            if (key == oldKey)
            {
                take(entry++, old++);
            }
            else
            {
                ++(key < oldKey ? entry : old);
            }
        }
    };
    // Both lists are sorted by key within grains and within walls.
    const std::size_t wall = firstWithWall(contacts_);
    const std::size_t oldWall = firstWithWall(oldContacts_);
    carry(0, wall, 0, oldWall);
    carry(wall, contacts_.size(), oldWall, oldContacts_.size());
}

void ContactList::take(std::size_t entry, std::size_t old)
{
    contacts_[entry] = oldContacts_[old];
    if (withSprings_)
    {
        springs_[entry] = oldSprings_[old];
    }
    if (withTurns_)
    {
        turns_[entry] = oldTurns_[old];
    }
}

std::size_t ContactList::firstWithWall(const std::vector<Contact<2>>& contacts) const
{
    const auto isWall = [](const Contact<2>& contact) { return contact.withWall(); };
    return static_cast<std::size_t>(std::partition_point(contacts.begin(), contacts.end(), [&](const auto& c) { return !isWall(c); })
                                    - contacts.begin());
}

} // namespace chesil
