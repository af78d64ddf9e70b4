#include "mrpt_ext/correspondence/bearings/inlier_refinement.h"

#include <gtest/gtest.h>

#include <limits>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext::test_inlier_refinement
{
TEST(InlierRefinement, APoseOnALandmarkStaysFinite)
{
  // In single precision a landmark of a large map is exactly where the sensor is.
  const std::vector<Vector2d> landmarks{{18979.4823, 1186.5625}, {17526.3, 762.1}, {417.8, 11410.5}, {8945.9, 1684.5}};
  const LandmarkIndex index(landmarks);
  const PotentiallyVisibleSets sets(index, std::numeric_limits<double>::infinity(), 0);
  const GaussianPose at_landmark{{landmarks[0].x(), landmarks[0].y(), 2.07}, Vector3d(1, 1, 1e-4).asDiagonal()};
  std::vector<ScanBearing> bearings(4);  // the first, straight ahead, is taken for the landmark under the sensor
  for (std::size_t k = 0; k < bearings.size(); ++k)
  {
    if (k > 0) bearings[k].angle = predictBearing(at_landmark.mean, landmarks[k]);
    bearings[k].direction = {std::cos(bearings[k].angle), std::sin(bearings[k].angle)};
    bearings[k].std = degToRad(1.0);
  }
  const DirectionTable table(bearings, 4);
  const BoundingScan scan{.table = &table, .visible_sets = &sets};
  GatedLandmarks scratch;
  const RefinedPose refined = refineOnInliers(at_landmark, {&scan, 1}, 4, 1, scratch);
  EXPECT_TRUE(isFinite(refined.sensor.mean));
}
}  // namespace mrpt_ext::test_inlier_refinement
