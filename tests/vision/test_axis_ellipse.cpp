#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/axis_ellipse.h"

namespace mrpt_ext::test_axis_ellipse
{
namespace
{
const AxisEllipse kEllipse{{310, 245}, 212, 190};

std::vector<cv::Point2d> pointsOf(const AxisEllipse& ellipse, int count, double turn = kTwoPi)
{
  std::vector<cv::Point2d> points;
  for (int i = 0; i < count; ++i)
    points.push_back(ellipse.at({std::cos(turn * i / count + 0.3), std::sin(turn * i / count + 0.3)}));
  return points;
}

void expectSame(const AxisEllipse& found, const AxisEllipse& expected, double tolerance)
{
  EXPECT_NEAR(found.centre.x, expected.centre.x, tolerance);
  EXPECT_NEAR(found.centre.y, expected.centre.y, tolerance);
  EXPECT_NEAR(found.semi_u, expected.semi_u, tolerance);
  EXPECT_NEAR(found.semi_v, expected.semi_v, tolerance);
}
}  // namespace

TEST(AxisEllipse, PassesThroughFourPoints)
{
  const auto found = ellipseThrough(pointsOf(kEllipse, 4));
  ASSERT_TRUE(found);
  expectSame(*found, kEllipse, 1e-6);
}

TEST(AxisEllipse, IsNothingForPointsOnALineOrTooFew)
{
  EXPECT_FALSE(ellipseThrough({{0, 0}, {1, 2}, {2, 4}, {3, 6}}));
  EXPECT_FALSE(ellipseThrough({{5, 5}, {5, 5}, {5, 5}, {5, 5}}));
  EXPECT_FALSE(ellipseThrough(pointsOf(kEllipse, 3)));
}

TEST(AxisEllipse, DistanceIsThatAlongTheNormal)
{
  EXPECT_NEAR(kEllipse.distance(kEllipse.at({1, 0})), 0, 1e-9);
  EXPECT_NEAR(kEllipse.distance({310 + 212 + 2, 245}), 2, 0.02);
  EXPECT_NEAR(kEllipse.distance({310, 245 - 190 + 3}), -3, 0.05);
  EXPECT_LT(kEllipse.distance(kEllipse.centre), -100);
}

TEST(AxisEllipse, RefinementFollowsAPartOfTheRim)
{
  const AxisEllipse start{{306, 249}, 205, 196};
  const auto fit = refineEllipse(start, pointsOf(kEllipse, 200, 0.6 * kTwoPi));
  ASSERT_TRUE(fit);
  expectSame(fit->ellipse, kEllipse, 1e-3);
  EXPECT_LT(fit->rms, 1e-4);
}

TEST(AxisEllipse, RefinementHasACovariance)
{
  auto points = pointsOf(kEllipse, 400);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].x += (static_cast<double>(i * 7919 % 13) - 6) / 20;
  const auto fit = refineEllipse(kEllipse, points);
  ASSERT_TRUE(fit);
  const double std_centre = std::sqrt(fit->covariance(0, 0));
  EXPECT_GT(std_centre, 1e-3);
  EXPECT_LT(std::abs(fit->ellipse.centre.x - kEllipse.centre.x), 4 * std_centre);
  EXPECT_FALSE(refineEllipse(kEllipse, {{1, 1}, {2, 2}, {3, 3}}));
}
}  // namespace mrpt_ext::test_axis_ellipse
