#include "mrpt_ext/experiment/tracking_bound.h"

#include <gtest/gtest.h>

#include "mrpt_ext/evaluation/information_bound.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext::test_tracking_bound
{
namespace
{
const Pose2 kPlace{2, 1, 0.4};
constexpr int kFrames = 20;

struct BoundInput
{
  RunContext context;
  ParticleFilterOptions filter;
  OdometryPath odometry;
  std::vector<Frame> frames;
};

TrackingBound boundOf(const BoundInput& input)
{
  const auto feed = [&input, next = std::size_t{0}]() mutable
  { return next < input.frames.size() ? std::optional(input.frames[next++]) : std::nullopt; };
  return trackingBound(input.context, input.filter, input.odometry, feed);
}

/// A robot at rest, with exact odometry, that sees three landmarks once per second.
BoundInput standingRobot()
{
  BoundInput input;
  input.context.map = LandmarkTable(
      {{.id = 1, .position = {0, 0, 0}}, {.id = 2, .position = {5, 1, 0}}, {.id = 3, .position = {1, 6, 0}}});
  input.context.start_time = 10;
  input.context.duration_s = kFrames - 1;
  MotionModel& motion = input.filter.motion;
  motion.std_xy_per_s = motion.std_phi_per_s = 0;
  input.filter.region = {{0, 0}, {6, 6}};
  for (int k = 0; k < kFrames; ++k)
  {
    Frame frame;
    frame.time = 10 + k;
    frame.motion.duration = k > 0 ? 1 : 0;
    Reading reading;
    for (const Landmark& landmark : input.context.map.all())
      reading.detections.push_back(
          {.id = landmark.id, .bearing = predictBearing(kPlace, landmark.position.head<2>()), .std_bearing = 0.02});
    frame.readings = {reading};
    input.frames.push_back(frame);
    input.context.truth.push_back({frame.time, kPlace, true});
    input.context.truth.push_back({frame.time + 0.4, kPlace, true});
    input.context.truth.push_back({frame.time + 0.8, kPlace, true});
  }
  return input;
}

/// The information of one frame.
Matrix3d informationOfAFrame(const BoundInput& input)
{
  Matrix3d information = Matrix3d::Zero();
  for (const Landmark& landmark : input.context.map.all())
    addInformation(information, bearingJacobian(kPlace, landmark.position.head<2>()), 0.02);
  return information;
}
}  // namespace

TEST(TrackingBound, InformationAddsUpWhileTheRobotStands)
{
  const BoundInput input = standingRobot();
  const TrackingBound bound = boundOf(input);
  EXPECT_EQ(bound.why_none, "");
  ASSERT_EQ(bound.stamps.size(), static_cast<std::size_t>(kFrames));
  // The box of possible positions, 6 x 6 m, adds next to nothing to three bearings.
  const InformationBound all = *informationBound(kFrames * informationOfAFrame(input));
  EXPECT_NEAR(bound.stamps.back().position_variance, square(all.position_rms), 1e-3 * square(all.position_rms));
  EXPECT_NEAR(bound.stamps.back().heading_variance, all.covariance(2, 2), 1e-3 * all.covariance(2, 2));

  const LimitScore late = limitFrom(bound, bound.stamps.back().time);
  EXPECT_NEAR(*late.position_rmse_m, all.position_rms, 1e-3 * all.position_rms);
  EXPECT_GT(*limitFrom(bound, 10).position_rmse_m, *late.position_rmse_m) << "sharp later, not at once";
  EXPECT_FALSE(limitFrom(bound, 1000).position_rmse_m);
}

TEST(TrackingBound, OutliersHaveNoInformation)
{
  BoundInput input = standingRobot();
  const double honest = boundOf(input).stamps.back().position_variance;
  for (Frame& frame : input.frames)
  {
    Detection outlier = frame.readings[0].detections[0];
    outlier.bearing = wrap(*outlier.bearing + 1);
    frame.readings[0].detections.push_back(outlier);
  }
  EXPECT_EQ(boundOf(input).stamps.back().position_variance, honest);
}

TEST(TrackingBound, ThereIsNoneWhereASensorErrsMoreThanItsNoise)
{
  BoundInput input = standingRobot();
  for (Frame& frame : input.frames)
    for (Detection& detection : frame.readings[0].detections) detection.bearing = wrap(*detection.bearing + 0.2);
  EXPECT_EQ(boundOf(input).why_none, "most detections do not fit the true poses");
  EXPECT_TRUE(boundOf(input).stamps.empty());
}

TEST(TrackingBound, AKnownStartAndOdometryCount)
{
  BoundInput input = standingRobot();
  const double unknown = boundOf(input).stamps.front().position_variance;
  input.filter.initial_mode = InitialMode::gaussian;
  input.filter.initial_pose.covariance = Matrix3d::Identity() * 1e-4;
  EXPECT_LT(boundOf(input).stamps.front().position_variance, 0.5 * unknown);

  const double still = boundOf(input).stamps.back().position_variance;
  input.filter.motion.std_xy_per_s = 0.1;
  EXPECT_GT(boundOf(input).stamps.back().position_variance, 2 * still) << "odometry forgets";
}

TEST(TrackingBound, StatesWhyThereIsNone)
{
  BoundInput anonymous = standingRobot();
  anonymous.frames[3].readings[0].detections[0].id = kNoId;
  EXPECT_EQ(boundOf(anonymous).why_none, "") << "nobody expects one";

  BoundInput blind = standingRobot();
  blind.context.truth.clear();
  EXPECT_NE(boundOf(blind).why_none.find("no truth"), std::string::npos);

  BoundInput sparse = standingRobot();
  sparse.context.truth_is_sparse = true;
  EXPECT_NE(boundOf(sparse).why_none.find("sparse"), std::string::npos);

  BoundInput gap = standingRobot();
  gap.context.truth.erase(gap.context.truth.begin() + 15, gap.context.truth.begin() + 21);
  EXPECT_FALSE(boundOf(gap).why_none.empty());
  EXPECT_TRUE(boundOf(gap).stamps.empty());
}

TEST(TrackingBound, DirectionsOfLandmarksCount)
{
  BoundInput input = standingRobot();
  const double without = boundOf(input).stamps.front().heading_variance;
  std::vector<Landmark> landmarks = input.context.map.all();
  landmarks[1].yaw = 3;
  input.context.map = LandmarkTable(landmarks);
  for (Frame& frame : input.frames)
    frame.readings[0].detections[1].facing =
        Facing::either({3 - kPlace.phi + 0.9, 0.01}, {3 - kPlace.phi + 0.001, 0.01}, 0.4);
  const double with = boundOf(input).stamps.front().heading_variance;
  EXPECT_LT(with, square(0.01));
  EXPECT_LT(with, 0.7 * without);
  for (Frame& frame : input.frames) frame.readings[0].detections[1].facing = Facing::single(3 - kPlace.phi + 1, 0.01);
  EXPECT_EQ(boundOf(input).stamps.front().heading_variance, without) << "an outlier";
}
}  // namespace mrpt_ext::test_tracking_bound
