#include "generate/fit/jointFrame.hpp"

#include "core/shapes/polyBezier.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

JointFrame smoothFrame(const std::vector<double>& angles)
{
    std::vector<PlannedJoint> joints;
    for (const double angle : angles)
    {
        joints.push_back({angle, angle, Vector2::Zero(), false});
    }
    return JointFrame(joints);
}

/// An outline around a circle of radius 1, joints at the middle of their edges.
Eigen::VectorXd circumscribed(const JointFrame& frame)
{
    std::vector<Vector2> joints;
    for (int i = 0; i < frame.joints(); ++i)
    {
        joints.push_back(frame.normal(i));
    }
    return frame.withHandles(frame.atPoints(joints));
}

} // namespace

TEST(JointFrame, edgesOfARegularPolygon)
{
    for (const int count : {3, 4, 10})
    {
        std::vector<double> angles;
        for (int i = 0; i < count; ++i)
        {
            angles.push_back(2 * M_PI * i / count);
        }
        const JointFrame frame = smoothFrame(angles);
        const Eigen::VectorXd z = circumscribed(frame);
        for (int i = 0; i < count; ++i)
        {
            for (const double length : frame.edgeLengths(z, i))
            {
                EXPECT_NEAR(length, std::tan(M_PI / count), 1e-14);
            }
        }
    }
}

TEST(JointFrame, positiveGapsMakeAConvexSmoothOutline)
{
    test::RandomSource random(21);
    int positive = 0;
    for (int trial = 0; trial < 2000; ++trial)
    {
        const JointFrame frame = smoothFrame(test::randomNormalAngles(random.integer(3, 12), random));
        Eigen::VectorXd z = circumscribed(frame);
        for (Eigen::Index k = 0; k < z.size(); ++k)
        {
            z[k] += random.uniform(-0.05, 0.05);
        }
        const double least = (frame.gapMatrix() * z).minCoeff();
        std::vector<CubicBezier> outline;
        for (int i = 0; i < frame.joints(); ++i)
        {
            outline.push_back(frame.segment(z, i));
        }
        if (least > 1e-3)
        {
            ++positive;
            EXPECT_LT(PolyBezier(outline).largestJointAngle(), 1e-12);
        }
        else if (least < -1e-3)
        {
            EXPECT_ANY_THROW(PolyBezier{outline});
        }
    }
    EXPECT_GT(positive, 200);
    EXPECT_LT(positive, 1800);
}

TEST(JointFrame, gradientIsThatOfThePoint)
{
    test::RandomSource random(22);
    const JointFrame frame = smoothFrame(test::randomNormalAngles(7, random));
    Eigen::VectorXd z = circumscribed(frame);
    constexpr double change = 1e-3;
    for (int i = 0; i < frame.joints(); ++i)
    {
        const double t = random.uniform(0, 1);
        const Vector2 direction = random.direction();
        const auto gradient = frame.pointGradient(i, t, direction);
        for (int entry = 0; entry < 2 * JointFrame::perJoint; ++entry)
        {
            const int joint = entry < JointFrame::perJoint ? i : frame.next(i);
            Eigen::VectorXd moved = z;
            moved[JointFrame::perJoint * joint + entry % JointFrame::perJoint] += change;
            const double difference =
                direction.dot(frame.segment(moved, i).at(t) - frame.segment(z, i).at(t)) / change;
            EXPECT_NEAR(gradient[static_cast<std::size_t>(entry)], difference, 1e-11);
        }
    }
}
