#include "mrpt_ext/vision/tags/tag_measurement.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"
#include "tag_picture.h"
#include "test_length.h"

namespace mrpt_ext::test_tag_measurement
{
namespace
{
using testing::PlacedTag;
using testing::wallCamera;

TagCorners shaken(TagCorners corners, double std_corner, RandomStream& random)
{
  for (Eigen::Vector2d& corner : corners) corner += std_corner * Eigen::Vector2d(random.gaussian(), random.gaussian());
  return corners;
}

/// Mean squared errors of range and bearing in units of the stated variances, over many shaken images of one tag.
Eigen::Vector2d neesOf(const PlacedTag& tag, const PinholeCamera& camera, double std_corner, RandomStream& random)
{
  const int trials = testing::runsOfTest(500);
  Eigen::Vector2d sum(0, 0);
  for (int trial = 0; trial < trials; ++trial)
  {
    const auto seen =
        measureTag(shaken(tag.corners(camera), std_corner, random), tag.edge, camera, {.std_corner = std_corner});
    EXPECT_TRUE(seen);
    if (!seen) return {0, 0};
    sum += Eigen::Vector2d(square((seen->range - tag.range) / seen->std_range),
                           square((seen->bearing - tag.bearing) / seen->std_bearing));
  }
  return sum / trials;
}

/// Tags that hang anyhow.
constexpr TagNoise anyhow(double std_corner) { return {.std_corner = std_corner, .std_upright = 1e3}; }
}  // namespace

TEST(TagMeasurement, GoldenCovariance)
{
  // By the derivative of the corners by the pose, taken in NumPy by small steps.
  const PlacedTag tag{.range = 2, .bearing = 0.2, .above = 0.3, .turned = 0.8};
  const PinholeCamera camera = wallCamera();
  const auto seen = measureTag(tag.corners(camera), tag.edge, camera, anyhow(0.01));
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->std_range, 0.01 * 0.0445570, 1e-8);
  EXPECT_NEAR(seen->std_bearing, 0.01 * 0.00110494, 1e-9);
  EXPECT_NEAR(seen->correlation, 0.057515, 1e-4);
}

TEST(TagMeasurement, TheCovarianceIsThatOfSmallStepsOfTheCorners)
{
  const PlacedTag tag{.range = 1.5, .bearing = -0.3, .above = 0.5, .turned = -0.9};
  const PinholeCamera camera = wallCamera();
  const TagCorners corners = tag.corners(camera);
  const auto seen = measureTag(corners, tag.edge, camera, anyhow(1e-3));
  ASSERT_TRUE(seen);
  constexpr double kStep = 1e-3;
  double range = 0, bearing = 0;
  for (int i = 0; i < 8; ++i)
  {
    TagCorners more = corners, less = corners;
    more[i / 2][i % 2] += kStep, less[i / 2][i % 2] -= kStep;
    const auto after = measureTag(more, tag.edge, camera, anyhow(1e-3)),
               before = measureTag(less, tag.edge, camera, anyhow(1e-3));
    ASSERT_TRUE(after && before);
    range += square((after->range - before->range) / (2 * kStep));
    bearing += square((after->bearing - before->bearing) / (2 * kStep));
  }
  EXPECT_NEAR(seen->std_range / (1e-3 * std::sqrt(range)), 1, 1e-3);
  EXPECT_NEAR(seen->std_bearing / (1e-3 * std::sqrt(bearing)), 1, 1e-3);
}

TEST(TagMeasurement, StatedDeviationsAgreeWithTheScatter)
{
  RandomStream random(7);
  PinholeCamera camera = wallCamera();
  camera.k1 = -0.2, camera.k2 = 0.05;
  Eigen::Vector2d sum(0, 0);
  int places = 0;
  for (const double std_corner : {0.1, 0.5})
    for (const double range : {1.0, 2.0, 3.0, 4.5})
      for (const double turned : {0.0, 0.3, 0.6, 0.9, 1.1})
      {
        const PlacedTag tag{.range = range, .bearing = 0.4 * turned - 0.2, .above = 0.4, .turned = turned};
        const Eigen::Vector2d nees = neesOf(tag, camera, std_corner, random);
        if (testing::isShort()) continue;  // too few trials for the bounds
        EXPECT_GT(nees.minCoeff(), 0.8) << std_corner << " px, " << range << " m, " << turned;
        EXPECT_LT(nees.maxCoeff(), 1.3) << std_corner << " px, " << range << " m, " << turned;
        sum += nees, ++places;
      }
  if (testing::isShort()) return;
  for (const double mean : {sum[0] / places, sum[1] / places})
  {
    EXPECT_GT(mean, 0.95);
    EXPECT_LT(mean, 1.05);
  }
}

TEST(TagMeasurement, ResidualsAreChiSquaredWithFourDegrees)
{
  RandomStream random(3);
  const PinholeCamera camera = wallCamera();
  const TagCorners corners = PlacedTag{.range = 1, .turned = 0.6}.corners(camera);
  double sum = 0;
  constexpr int kTrials = 500;
  for (int trial = 0; trial < kTrials; ++trial)
    sum += measureTag(shaken(corners, 0.3, random), 0.2, camera, {.std_corner = 0.3, .std_upright = 0.001})->residual;
  EXPECT_NEAR(sum / kTrials, 4, 0.4);
}

TEST(TagMeasurement, NoBearingToATagAboveTheCamera)
{
  PinholeCamera camera = wallCamera();
  camera.pitch = degToRad(-90);
  const double near = 20, far = 420;
  const TagCorners around{Eigen::Vector2d(camera.cx - near, camera.cy - near),
                          {camera.cx + near, camera.cy - near},
                          {camera.cx + near, camera.cy + near},
                          {camera.cx - near, camera.cy + near}};
  EXPECT_FALSE(measureTag(around, 0.2, camera, anyhow(0.5)));
  TagCorners beside = around;
  for (Eigen::Vector2d& corner : beside) corner.y() += far - camera.cy;
  EXPECT_TRUE(measureTag(beside, 0.2, camera, anyhow(0.5)));
}
}  // namespace mrpt_ext::test_tag_measurement
