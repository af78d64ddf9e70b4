#include "mrpt_ext/filter/kalman/facing_update.h"

#include <gtest/gtest.h>

#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"

namespace mrpt_ext::test_facing_update
{
namespace
{
const Pose2 kTruth{3, 4, 0.5};
const Pose2 kMount{0.1, 0.2, 0.3};
constexpr double kWallFaces = -2.0;

LandmarkTable map() { return LandmarkTable({{.id = 1, .position = {8, 6, 0}, .yaw = kWallFaces}}); }

/// What the sensor sees of the wall's direction.
double seenYaw() { return wrap(kWallFaces - kTruth.phi - kMount.phi); }

Frame frameWith(const std::optional<Facing>& facing)
{
  Reading reading{.sensor = "camera", .T_robot_sensor = kMount};
  reading.model.clutter_probability = 0.02;
  const Vector2d wall(8, 6);
  reading.detections = {{.id = 1,
                         .bearing = predictBearing(kTruth, wall, kMount),
                         .range = predictRange(kTruth, wall, kMount),
                         .std_bearing = 0.002,
                         .std_range = 0.05,
                         .facing = facing}};
  Frame frame;
  frame.readings = {reading};
  return frame;
}

KalmanState priorOf(double std_xy, double std_phi, const Pose2& at = kTruth)
{
  return startingState({at, Vector3d(square(std_xy), square(std_xy), square(std_phi)).asDiagonal()}, {});
}

double stdOfHeading(const KalmanUpdate& update) { return std::sqrt(update.state.covariance(2, 2)); }
}  // namespace

TEST(FacingUpdate, ASingleLandmarkTellsTheHeading)
{
  const KalmanState prior = priorOf(5, 0.5, {2.9, 4.2, 0.6});
  for (const auto update : {updateExtended, updateIterated})
  {
    const KalmanUpdate with = update(prior, frameWith(Facing::single(seenYaw(), 0.05)), map(), {}),
                       without = update(prior, frameWith({}), map(), {});
    EXPECT_NEAR(with.state.pose().phi, kTruth.phi, 0.01);
    EXPECT_NEAR(stdOfHeading(with), 0.05, 0.002);
    EXPECT_GT(stdOfHeading(without), 0.4);
    EXPECT_EQ(with.degrees_of_freedom, 3);
    EXPECT_EQ(without.degrees_of_freedom, 2);
    EXPECT_EQ(with.detections[0].attitude, 0U);
  }
}

TEST(FacingUpdate, TheStateTellsWhichAttitudeItIs)
{
  const Frame frame = frameWith(Facing::either({seenYaw() + 0.7, 0.05}, {seenYaw(), 0.05}, 0.4));
  const KalmanUpdate tracked = updateExtended(priorOf(0.1, 0.1), frame, map(), {});
  EXPECT_EQ(tracked.detections[0].attitude, 1U);
  EXPECT_LT(stdOfHeading(tracked), 0.05);
  EXPECT_NEAR(tracked.state.pose().phi, kTruth.phi, 0.01);
  const KalmanUpdate open = updateExtended(priorOf(5, 1), frame, map(), {});
  EXPECT_FALSE(open.detections[0].attitude) << "both are possible: neither is used";
  EXPECT_EQ(open.degrees_of_freedom, 2);
}

TEST(FacingUpdate, AnAttitudeThatContradictsTheStateIsClutter)
{
  const KalmanUpdate update =
      updateExtended(priorOf(0.1, 0.1), frameWith(Facing::single(seenYaw() + 1.5, 0.05)), map(), {});
  EXPECT_FALSE(update.detections[0].attitude);
  EXPECT_TRUE(update.detections[0].landmark) << "bearing and range are used all the same";
}

TEST(FacingUpdate, TheEvidenceOfAStateWithZeroCovarianceIsTheLikelihoodOfItsPose)
{
  for (const Facing& facing :
       {Facing::single(seenYaw() + 0.04, 0.05), Facing::either({seenYaw() + 0.1, 0.2}, {seenYaw() - 0.3, 0.1}, 0.4)})
  {
    const Frame frame = frameWith(facing);
    EXPECT_NEAR(updateExtended(priorOf(0, 0), frame, map(), {}).log_evidence,
                logLikelihood(frame.readings[0], map(), kTruth), 1e-6);
  }
}

TEST(FacingUpdate, AnOffsetOfTheSensorIsTakenOffAndLearned)
{
  const BiasModel biases{{.kind = BiasKind::bearing_offset, .mean = 0, .std = 0.2}};
  KalmanState prior = startingState({kTruth, Matrix3d::Identity() * 1e-6}, biases);
  const Frame frame = frameWith(Facing::single(seenYaw() + 0.1, 0.02));
  const auto compared = compareFacing(frame.readings[0].detections[0], frame.readings[0], map(), prior, biases);
  ASSERT_TRUE(compared && compared->attitude);
  prior.mean[3] = 0.1;
  const KalmanRow row =
      lineariseFacing(frame.readings[0].detections[0], 0, frame.readings[0], map(), prior.mean, biases);
  EXPECT_NEAR(row.residual, 0, 1e-12);
  EXPECT_EQ(row.jacobian[2], 1);
  EXPECT_EQ(row.jacobian[3], -1);
  EXPECT_NEAR(row.variance, square(0.02), 1e-12);
}

TEST(FacingUpdate, NothingWhereTheMapKnowsNoDirection)
{
  const LandmarkTable plain({{.id = 1, .position = {8, 6, 0}}});
  const Frame with = frameWith(Facing::single(seenYaw(), 0.05)), without = frameWith({});
  EXPECT_FALSE(compareFacing(with.readings[0].detections[0], with.readings[0], plain, priorOf(1, 1), {}));
  const KalmanUpdate a = updateExtended(priorOf(1, 1), with, plain, {}),
                     b = updateExtended(priorOf(1, 1), without, plain, {});
  EXPECT_EQ(a.log_evidence, b.log_evidence);
  EXPECT_EQ(a.state.covariance, b.state.covariance);
}
}  // namespace mrpt_ext::test_facing_update
