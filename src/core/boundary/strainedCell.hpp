#pragma once

#include "core/base/periodicCell.hpp"
#include "core/base/setupError.hpp"
#include "core/base/vector.hpp"

#include <Eigen/LU>

#include <cmath>
#include <utility>

namespace chesil
{

/// A periodic cell that is strained at a given rate: its lattice vectors h obey dh/dt = L h, and the image of a grain
/// that stands by d away moves by L d faster (Lees & Edwards 1972 for any velocity gradient L). World frame.
struct StrainedCell
{
    /// ValueError for a gradient that is not finite, or not zero in a strip.
    explicit StrainedCell(PeriodicCell periodic, const Eigen::Matrix2d& gradient = Eigen::Matrix2d::Zero())
    : cell(std::move(periodic)), velocityGradient(gradient)
    {
        const bool strip = cell.first().isZero(0) || cell.second().isZero(0);
        if (!gradient.allFinite() || (strip && isStrained()))
        {
            throw ValueError(
                strip ? "a strained strip" : "a velocity gradient that is not finite",
                strip ? "no velocity gradient, or two lattice vectors" : "finite numbers [1/s]");
        }
    }

    bool isStrained() const { return !velocityGradient.isZero(0); }

    PeriodicCell cell;
    /// Row i, column j: change of velocity component i along axis j [1/s].
    Eigen::Matrix2d velocityGradient;

    /// Of the strained plane at a place [m/s]; at rest in the cell's lower corner.
    Vector2 flow(const Vector2& position) const { return velocityGradient * (position - cell.lower()); }

    /// Vectors over `interval` [s], to second order in it; exact in simple shear.
    void strain(double interval)
    {
        const Eigen::Matrix2d growth = interval * velocityGradient;
        const Eigen::Matrix2d deformation = Eigen::Matrix2d::Identity() + growth + growth * growth / 2;
        cell = PeriodicCell(cell.lower(), deformation * cell.first(), deformation * cell.second());
    }

    /// What takes the vectors that it once had to those of now.
    Eigen::Matrix2d deformationFrom(const Vector2& first, const Vector2& second) const
    {
        Eigen::Matrix2d then;
        Eigen::Matrix2d now;
        then << first, second;
        now << cell.first(), cell.second();
        return now * then.inverse();
    }

    /// The same lattice by vectors that stand as upright as they can: each leans by no more than half of the other one.
    void straighten()
    {
        const Vector2 second = cell.second() - leaning(cell.second(), cell.first()) * cell.first();
        const Vector2 first = cell.first() - leaning(cell.first(), second) * second;
        if (first != cell.first() || second != cell.second())
        {
            cell = PeriodicCell(cell.lower(), first, second);
        }
    }

private:
    static double leaning(const Vector2& vector, const Vector2& over)
    {
        const double square = over.squaredNorm();
        return square > 0 ? std::round(vector.dot(over) / square) : 0;
    }
};

} // namespace chesil
