#pragma once

#include "core/contact/contact.hpp"

namespace chesil
{

/// Whether a measure takes the contacts of grains with walls, too. Walls order the grains beside them: in
/// small samples their contacts bias the fabric.
enum class WallContacts
{
    counted,
    leftOut
};

/// Whether the entry is a contact that the measure takes.
inline bool isMeasured(const Contact<2>& contact, WallContacts walls)
{
    return contact.depth > 0 && (walls == WallContacts::counted || !contact.withWall());
}

/// Force of the first body on the second along the normal [N], positive in compression.
inline double normalForce(const Contact<2>& contact) { return -contact.force.dot(contact.normal); }

/// Force of the first body on the second along the normal turned by +90 degrees [N]. The same if first and
/// second change places, since normal and force then both change sign.
inline double tangentialForce(const Contact<2>& contact)
{
    return -contact.force.dot(perpendicular(contact.normal));
}

} // namespace chesil
