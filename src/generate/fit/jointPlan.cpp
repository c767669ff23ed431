#include "generate/fit/jointPlan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace chesil
{

namespace
{

/// A segment turns by no more than this, since its tangent lines must cross at a distance that is no multiple
/// of the grain's size.
constexpr double mostTurn = 2.4;

/// What a corner's extrapolated normals leave between them and the next joint's at least.
constexpr double leastTurn = 2e-3;

int leastCount(const HullMeasure::Piece& piece)
{
    return piece.straight ? 1 : std::max(1, static_cast<int>(std::ceil(piece.turn() / mostTurn)));
}

int leastCount(const HullMeasure& measure)
{
    int count = 0;
    for (const HullMeasure::Piece& piece : measure.pieces())
    {
        count += leastCount(piece);
    }
    return count;
}

/// Segments of each piece, each new one to the piece where one stands for the most.
std::vector<int> shares(const std::vector<HullMeasure::Piece>& pieces, int segments)
{
    std::vector<int> counts;
    int total = 0;
    for (const HullMeasure::Piece& piece : pieces)
    {
        counts.push_back(leastCount(piece));
        total += counts.back();
    }
    for (; total < segments; ++total)
    {
        std::size_t best = pieces.size();
        double most = 0;
        for (std::size_t k = 0; k < pieces.size(); ++k)
        {
            const double each = pieces[k].straight ? 0 : pieces[k].measure() / counts[k];
            if (each > most)
            {
                best = k;
                most = each;
            }
        }
        if (best == pieces.size())
        {
            break;
        }
        ++counts[best];
    }
    return counts;
}

} // namespace

JointPlan JointPlan::equal(int segments)
{
    JointPlan plan;
    for (int i = 0; i < segments; ++i)
    {
        const double angle = 2 * M_PI * i / segments;
        plan.joints_.push_back({angle, angle, Vector2::Zero(), false});
    }
    return plan;
}

JointPlan JointPlan::withCorners(const std::vector<Vector2>& polygon, int most, double pixel, int smoothFor)
{
    JointPlan plan;
    plan.corners_ = hullCorners(polygon, pixel);
    while (true)
    {
        plan.measure_.emplace(polygon, plan.corners_, smoothFor);
        plan.measure_->findStraightPieces(polygon, plan.corners_, pixel);
        if (plan.corners_.empty() || leastCount(*plan.measure_) <= most)
        {
            return plan;
        }
        plan.corners_.erase(std::min_element(plan.corners_.begin(), plan.corners_.end(),
                                             [](const HullCorner& a, const HullCorner& b)
                                             { return a.turn < b.turn; }));
    }
}

JointPlan JointPlan::adapted(const std::vector<Vector2>& polygon, int segments, double pixel)
{
    JointPlan plan = withCorners(polygon, segments, pixel, segments);
    plan.distribute(segments);
    return plan;
}

JointPlan JointPlan::coarsest(const std::vector<Vector2>& polygon, int most, double pixel)
{
    // Of the number that most grains need
    constexpr int smoothFor = 8;
    JointPlan plan = withCorners(polygon, most, pixel, smoothFor);
    plan.distribute(fewestSegments);
    return plan;
}

JointPlan JointPlan::polygon(const std::vector<Vector2>& polygon, int sides)
{
    // Any range of normals: straight sides do not use it
    constexpr double range = 0.1;
    JointPlan plan = adapted(polygon, sides, 0);
    for (PlannedJoint& joint : plan.joints_)
    {
        const Vector2 normal(std::cos(joint.after), std::sin(joint.after));
        joint.corner = *std::max_element(polygon.begin(), polygon.end(),
                                         [&](const Vector2& a, const Vector2& b)
                                         { return normal.dot(a) < normal.dot(b); });
        joint.before -= range;
        joint.after += range;
        joint.straightAfter = true;
    }
    // Of neighbours at one vertex, one
    std::vector<PlannedJoint>& joints = plan.joints_;
    joints.erase(std::unique(joints.begin(), joints.end(),
                             [](const PlannedJoint& a, const PlannedJoint& b)
                             { return a.corner == b.corner; }),
                 joints.end());
    if (joints.back().corner == joints.front().corner)
    {
        joints.pop_back();
    }
    return plan;
}

std::size_t JointPlan::corners() const { return corners_.size(); }

void JointPlan::even(double share)
{
    const double start = joints_.front().after;
    for (std::size_t i = 0; i < joints_.size(); ++i)
    {
        const double equal = start + 2 * M_PI * static_cast<double>(i) / static_cast<double>(joints_.size());
        joints_[i].before += share * (equal - joints_[i].before);
        joints_[i].after = joints_[i].before;
    }
}

void JointPlan::split(std::size_t segment)
{
    const Place& start = places_[segment];
    const std::size_t next = segment + 1;
    const double end =
        next < places_.size() && places_[next].piece == start.piece
            ? places_[next].measure
            : measure_->pieces()[start.piece].measure() + (corners_.empty() ? places_[0].measure : 0);
    const Place middle{start.piece, (start.measure + end) / 2, false};
    places_.insert(places_.begin() + static_cast<std::ptrdiff_t>(next), middle);
    findNormals();
}

void JointPlan::distribute(int segments)
{
    const std::vector<int> counts = shares(measure_->pieces(), segments);
    for (std::size_t k = 0; k < counts.size(); ++k)
    {
        const double measure = measure_->pieces()[k].measure();
        for (int i = 0; i < counts[k]; ++i)
        {
            places_.push_back({k, measure * i / counts[k], i == 0 && !corners_.empty()});
        }
    }
    findNormals();
}

double JointPlan::angleAt(std::size_t piece, double measure) const
{
    const HullMeasure::Piece& whole = measure_->pieces()[piece];
    const double round = corners_.empty() && measure > whole.measure() ? 1 : 0;
    return whole.angleAt(measure - round * whole.measure()) + 2 * M_PI * round;
}

/// Where a segment would turn by too much, all angles of its piece are mixed with equally spaced ones.
void JointPlan::findNormals()
{
    joints_.clear();
    const std::vector<HullMeasure::Piece>& pieces = measure_->pieces();
    for (std::size_t i = 0; i < places_.size();)
    {
        const std::size_t k = places_[i].piece;
        const HullMeasure::Piece& piece = pieces[k];
        std::vector<double> angles;
        for (; i + angles.size() < places_.size() && places_[i + angles.size()].piece == k;)
        {
            angles.push_back(angleAt(k, places_[i + angles.size()].measure));
        }
        const bool closed = corners_.empty();
        if (!closed)
        {
            angles.front() = piece.startAngle;
        }
        angles.push_back(closed ? angles.front() + 2 * M_PI : piece.endAngle);
        if (!closed && angles.size() > 2)
        {
            angles.front() = std::min(angles.front(), angles[1] - leastTurn);
            angles.back() = std::max(angles.back(), angles[angles.size() - 2] + leastTurn);
        }
        const double count = static_cast<double>(angles.size() - 1);
        double share = 0;
        for (std::size_t j = 0; j + 1 < angles.size(); ++j)
        {
            const double even = (angles.back() - angles.front()) / count;
            const double turn = angles[j + 1] - angles[j];
            if (turn > mostTurn && turn > even)
            {
                share = std::max(share, std::min(1.0, (turn - mostTurn) / (turn - even)));
            }
        }
        for (std::size_t j = 0; j + 1 < angles.size(); ++j)
        {
            const double even =
                angles.front() + (angles.back() - angles.front()) * static_cast<double>(j) / count;
            const double angle = (1 - share) * angles[j] + share * even;
            joints_.push_back({angle, angle, Vector2::Zero(), piece.straight});
        }
        if (!closed)
        {
            PlannedJoint& corner = joints_[i];
            const HullMeasure::Piece& before = pieces[(k + pieces.size() - 1) % pieces.size()];
            corner.before = before.endAngle - (k == 0 ? 2 * M_PI : 0);
            corner.corner = corners_[k].position;
        }
        i += static_cast<std::size_t>(count);
    }
}

} // namespace chesil
