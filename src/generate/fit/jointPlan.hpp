#pragma once

#include "generate/fit/hullMeasure.hpp"

#include <optional>

namespace chesil
{

constexpr int fewestSegments = 3;
constexpr int mostSegments = 64;

/// A joint of an outline to be fitted to a convex polygon.
struct PlannedJoint
{
    /// Angles [rad] of the outward normals at the end of the segment before and at the start of the segment
    /// after it: one and the same at a smooth joint.
    double before = 0;
    double after = 0;
    /// Of a corner: where the hull has it. A smooth joint's place is its normal's support point.
    Vector2 corner = Vector2::Zero();
    /// The segment that starts here is a straight side between two corners.
    bool straightAfter = false;

    bool isCorner() const { return after > before; }
};

/// Where the joints of an outline are to stand: their normals, rising counter-clockwise over one turn.
class JointPlan
{
public:
    /// Equally spaced normals (Lai & Huang, section 4, step 2); no corners.
    static JointPlan equal(int segments);

    /// Joints at the polygon's corners, of which there are none if `pixel` [units of the polygon] is 0, and
    /// between them such that the HullMeasure is spread evenly. Of more corners than the segments suffice
    /// for, the sharpest count. A polygon all of whose sides are straight gets no more segments than sides.
    static JointPlan adapted(const std::vector<Vector2>& polygon, int segments, double pixel);

    /// As few adapted joints as do, with all corners for which `most` segments suffice; to be split.
    static JointPlan coarsest(const std::vector<Vector2>& polygon, int most, double pixel);

    /// The corners of a polygon with so many sides, spread as adapted joints are.
    static JointPlan polygon(const std::vector<Vector2>& polygon, int sides);

    const std::vector<PlannedJoint>& joints() const { return joints_; }
    std::size_t corners() const;

    /// Mixes the normals with this share of equally spaced ones. Of a plan without corners only.
    void even(double share);

    /// Puts a joint into the middle of a segment that is not straight. Of adapted joints only.
    void split(std::size_t segment);

private:
    struct Place
    {
        std::size_t piece;
        double measure;
        bool isCorner;
    };

    static JointPlan withCorners(const std::vector<Vector2>& polygon, int most, double pixel, int smoothFor);
    void distribute(int segments);
    void findNormals();
    double angleAt(std::size_t piece, double measure) const;

    /// None if the joints are equally spaced.
    std::optional<HullMeasure> measure_;
    std::vector<HullCorner> corners_;
    std::vector<Place> places_;
    std::vector<PlannedJoint> joints_;
};

} // namespace chesil
