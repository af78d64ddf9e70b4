#include <gtest/gtest.h>

#include <Eigen/LU>
#include <functional>

#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_kalman_observability
{
namespace
{
using Update = std::function<KalmanUpdate(const KalmanState&, const Frame&, const LandmarkTable&, const BiasModel&)>;

const LandmarkTable kMap({{.id = 1, .position = {4, 0, 0}}});

Frame frameAt(const Pose2& robot, double range_error, RandomStream& random)
{
  Reading reading;
  Detection d{.id = 1};
  d.std_bearing = degToRad(1);
  d.std_range = 0.1;
  d.bearing = wrap(predictBearing(robot, {4, 0}) + d.std_bearing * random.gaussian());
  d.range = predictRange(robot, {4, 0}) + d.std_range * random.gaussian() + range_error;
  reading.detections = {d};
  Frame frame;
  frame.readings = {reading};
  return frame;
}

/// Standard deviation of the angle about the landmark, if range and bearing were known [rad]. Readings of the landmark
/// tell nothing about it.
double angleStd(const KalmanState& state)
{
  const Vector2d from_landmark = state.pose().position() - Vector2d(4, 0);
  const Vector3d about(-from_landmark.y(), from_landmark.x(), 1);
  return 1 / std::sqrt(about.dot(Matrix3d(state.covariance.topLeftCorner<3, 3>()).inverse() * about));
}

/// Well known relative to the landmark, and not where the robot is around it.
KalmanState knownButForTheAngle()
{
  const Vector3d about(0, -4, 1);
  Matrix3d covariance = Vector3d(0.03 * 0.03, 0.03 * 0.03, square(degToRad(0.7))).asDiagonal();
  covariance += square(degToRad(5.0)) * about * about.transpose();  // to be told by a compass, not by the landmark
  return startingState({{0, 0, 0}, covariance}, {});
}
}  // namespace

TEST(KalmanObservability, OneLandmarkTellsNothingOfTheAngleAboutIt)
{
  for (const Update& update : {Update(updateExtended), Update(updateIterated)})
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
      // A compass moves the state about the landmark. It sees that landmark alone then, 10 cm from where it should be.
      RandomStream random(seed, 0);
      Frame turned;
      turned.compass = CompassRecord{.heading = degToRad(10.0), .std_heading = degToRad(5.0)};
      KalmanState state = update(knownButForTheAngle(), turned, kMap, {}).state;
      EXPECT_GT(state.mean[2], degToRad(4));
      const double told = angleStd(state);
      for (int k = 0; k < 100; ++k) state = update(state, frameAt({0, 0, 0}, 0.1, random), kMap, {}).state;
      EXPECT_NEAR(angleStd(state), told, 1e-6 * told) << seed;
      const Vector2d from_landmark = state.pose().position() - Vector2d(4, 0);
      EXPECT_NEAR(wrap(std::atan2(from_landmark.y(), from_landmark.x()) - kPi), degToRad(5), degToRad(0.7)) << seed;
    }
}
}  // namespace mrpt_ext::test_kalman_observability
