#pragma once

#include "core/base/pose.hpp"
#include "core/contact/contact.hpp"

#include <Eigen/Core>

#include <cmath>
#include <vector>

/// Contacts of samples whose measures are known in closed form.
namespace chesil::test
{

/// Entry i of `branches` belongs to contact i.
struct ContactScene
{
    std::vector<Contact<2>> contacts;
    std::vector<Vector2> branches;
    std::size_t grains = 0;
    /// [m2]
    double area = 0;

    /// The branch of one of the scene's own contacts.
    auto branch() const
    {
        return [this](const Contact<2>& contact) { return branches[&contact - contacts.data()]; };
    }

    /// A contact whose branch runs along its normal; `forceOnSecond` is what the first does to the second.
    void add(int first, int second, const Vector2& branchVector, const Vector2& forceOnSecond)
    {
        Contact<2> contact{first, second};
        contact.depth = 1e-3;
        contact.normal = branchVector.normalized();
        contact.force = -forceOnSecond;
        contacts.push_back(contact);
        branches.push_back(branchVector);
    }
};

/// Disks of diameter d in a square lattice, periodic in both directions; all contacts across x carry
/// `acrossX`, those across y `acrossY`: stress rows acrossX/d and acrossY/d.
inline ContactScene squareLattice(int columns, int rows, double d, const Vector2& acrossX,
                                  const Vector2& acrossY)
{
    ContactScene scene;
    scene.grains = columns * rows;
    scene.area = columns * rows * d * d;
    for (int j = 0; j < rows; ++j)
    {
        for (int i = 0; i < columns; ++i)
        {
            const int grain = j * columns + i;
            scene.add(grain, j * columns + (i + 1) % columns, Vector2(d, 0), acrossX);
            scene.add(grain, (j + 1) % rows * columns + i, Vector2(0, d), acrossY);
        }
    }
    return scene;
}

/// The same lattice between four walls (0 left, 1 right, 2 bottom, 3 top), whose branches are radii.
inline ContactScene boxedLattice(int columns, int rows, double d, const Vector2& acrossX,
                                 const Vector2& acrossY)
{
    ContactScene scene;
    scene.grains = columns * rows;
    scene.area = columns * rows * d * d;
    const auto addWall = [&](int grain, int wall, const Vector2& branch, const Vector2& force)
    { scene.add(grain, Contact<2>::wallAsSecond(wall), branch, force); };
    for (int j = 0; j < rows; ++j)
    {
        addWall(j * columns, 0, Vector2(-d / 2, 0), -acrossX);
        addWall(j * columns + columns - 1, 1, Vector2(d / 2, 0), acrossX);
        for (int i = 0; i + 1 < columns; ++i)
        {
            scene.add(j * columns + i, j * columns + i + 1, Vector2(d, 0), acrossX);
        }
    }
    for (int i = 0; i < columns; ++i)
    {
        addWall(i, 2, Vector2(0, -d / 2), -acrossY);
        addWall((rows - 1) * columns + i, 3, Vector2(0, d / 2), acrossY);
        for (int j = 0; j + 1 < rows; ++j)
        {
            scene.add(j * columns + i, (j + 1) * columns + i, Vector2(0, d), acrossY);
        }
    }
    return scene;
}

/// Disks of diameter d in a hexagonal lattice, periodic; all contacts carry the normal force f: isotropic
/// stress sqrt(3) f/d, six neighbours each.
inline ContactScene hexagonalLattice(int columns, int rows, double d, double f)
{
    ContactScene scene;
    scene.grains = columns * rows;
    scene.area = columns * rows * std::sqrt(0.75) * d * d;
    const auto grain = [&](int i, int j) { return j % rows * columns + (i + columns) % columns; };
    for (int j = 0; j < rows; ++j)
    {
        for (int i = 0; i < columns; ++i)
        {
            for (int k = 0; k < 3; ++k)
            {
                const Vector2 normal(std::cos(k * M_PI / 3), std::sin(k * M_PI / 3));
                const int neighbour = k == 0 ? grain(i + 1, j) : grain(i + 1 - k, j + 1);
                scene.add(grain(i, j), neighbour, d * normal, f * normal);
            }
        }
    }
    return scene;
}

/// The scene turned by an angle [rad] about the origin.
inline ContactScene turned(ContactScene scene, double angle)
{
    const Rotation<2> rotation(angle);
    for (std::size_t i = 0; i < scene.contacts.size(); ++i)
    {
        scene.contacts[i].normal = rotation.apply(scene.contacts[i].normal);
        scene.contacts[i].force = rotation.apply(scene.contacts[i].force);
        scene.contacts[i].point = rotation.apply(scene.contacts[i].point);
        scene.branches[i] = rotation.apply(scene.branches[i]);
    }
    return scene;
}

inline Eigen::Matrix2d turned(const Eigen::Matrix2d& tensor, double angle)
{
    Eigen::Matrix2d rotation;
    rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return rotation * tensor * rotation.transpose();
}

/// Smallest turn from one axis to another [rad].
inline double axisDistance(double a, double b) { return std::abs(std::remainder(a - b, M_PI)); }

} // namespace chesil::test
