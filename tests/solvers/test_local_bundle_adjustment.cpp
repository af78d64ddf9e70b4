#include "mrpt_ext/solvers/local_bundle_adjustment.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "trajectory_scene.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStdBearing = degToRad(0.1), kStdRange = 0.02;
const Vector3d kStepNoise(0.01, 0.01, degToRad(0.5));
const std::vector<Vector2d> kLandmarks{{4, 1}, {1, 5}, {-3, -2}, {6, -3}, {-2, 4}, {3, -5}, {-5, 1}, {2, 3}};

struct Seen
{
  DrivenTrajectory way;
  std::vector<ScanPose> places;
  std::vector<LandmarkObservation> sightings;
  std::vector<Vector2d> truth;  // robot frame of now
};

Seen seeAlong(std::size_t landmarks, bool ranges, RandomStream& random)
{
  Seen seen;
  seen.way = driveSteps({0.5, 0.3, 0.4}, {0.25, 0, 0.1}, 8, kStepNoise, random);
  for (std::size_t j = 0; j < landmarks; ++j) seen.truth.push_back(transform(inverse(seen.way.now()), kLandmarks[j]));
  for (std::size_t k = 0; k < seen.way.poses.size(); ++k)
  {
    seen.places.push_back({seen.way.poses[k], seen.way.covariances[k]});
    for (std::size_t j = 0; j < landmarks; ++j)
    {
      LandmarkObservation s{.place = k, .landmark = j, .std_bearing = kStdBearing, .std_range = kStdRange};
      s.bearing = predictBearing(seen.way.true_poses[k], kLandmarks[j]) + kStdBearing * random.gaussian();
      if (ranges) s.range = predictRange(seen.way.true_poses[k], kLandmarks[j]) + kStdRange * random.gaussian();
      seen.sightings.push_back(s);
    }
  }
  return seen;
}

double squaredErrors(const Seen& seen, const BundleAdjustment& adjusted)
{
  double sum = 0;
  for (std::size_t j = 0; j < seen.truth.size(); ++j)
  {
    const Vector2d e = adjusted.landmarks[j].mean - seen.truth[j];
    sum += e.dot(adjusted.landmarks[j].covariance.inverse() * e);
  }
  return sum / static_cast<double>(seen.truth.size());
}
}  // namespace

TEST(BundleAdjustment, OneLandmarkIsWhereItIsWithoutTheOthers)
{
  RandomStream random(1);
  const Seen seen = seeAlong(1, false, random);
  std::vector<WindowObservation> sightings;
  for (const LandmarkObservation& s : seen.sightings)
    sightings.push_back({seen.places[s.place].T_robot_sensor, seen.places[s.place].odometry_covariance, s.bearing,
                         s.range, s.std_bearing, s.std_range});
  const WindowLandmark alone = locateLandmark(sightings);
  const BundleAdjustment adjusted = adjustBundle(seen.places, seen.sightings, seen.truth);
  ASSERT_EQ(adjusted.status, SolveStatus::ok);
  const GaussianPoint &a = alone.places.front().in_robot, &b = adjusted.landmarks.front();
  EXPECT_LT((a.mean - b.mean).norm(), 0.1 * std::sqrt(a.covariance.trace())) << "to the order of the linearisation";
  EXPECT_LT((a.covariance - b.covariance).norm(), 0.05 * a.covariance.norm());
}

TEST(BundleAdjustment, ErrorsAreWhatTheCovarianceSays)
{
  RandomStream random(2);
  const int trials = 300;
  for (const bool ranges : {false, true})
  {
    double squared = 0, chi2 = 0;
    int degrees = 0;
    for (int trial = 0; trial < trials; ++trial)
    {
      const Seen seen = seeAlong(kLandmarks.size(), ranges, random);
      const BundleAdjustment adjusted = adjustBundle(seen.places, seen.sightings, seen.truth);
      ASSERT_EQ(adjusted.status, SolveStatus::ok);
      squared += squaredErrors(seen, adjusted) / trials;
      chi2 += adjusted.chi2 / trials;
      degrees = adjusted.degrees;
    }
    EXPECT_NEAR(squared, 2, 0.3) << ranges;
    EXPECT_NEAR(chi2 / degrees, 1, 0.05) << ranges;
  }
}

TEST(BundleAdjustment, TogetherTheLandmarksTellHowOdometryErred)
{
  RandomStream random(3);
  const Seen seen = seeAlong(kLandmarks.size(), true, random);
  const BundleAdjustment adjusted = adjustBundle(seen.places, seen.sightings, seen.truth);
  const ScanPose &before = seen.places.front(), &after = adjusted.places.front();
  EXPECT_LT(after.odometry_covariance(2, 2), 0.05 * before.odometry_covariance(2, 2));
  const Pose2 truth = between(seen.way.now(), seen.way.true_poses.front());
  EXPECT_LT(std::abs(wrap(after.T_robot_sensor.phi - truth.phi)), 4 * std::sqrt(after.odometry_covariance(2, 2)));
  EXPECT_LT((after.T_robot_sensor.position() - truth.position()).norm(), 0.05);
}

TEST(BundleAdjustment, AWrongSightingStandsOutAndARobustFitLeavesItAside)
{
  RandomStream random(4);
  Seen seen = seeAlong(kLandmarks.size(), false, random);
  *seen.sightings[20].bearing += degToRad(5);
  const BundleAdjustment adjusted = adjustBundle(seen.places, seen.sightings, seen.truth);
  ASSERT_EQ(adjusted.status, SolveStatus::ok);
  const auto worst = std::max_element(adjusted.misfits.begin(), adjusted.misfits.end()) - adjusted.misfits.begin();
  EXPECT_EQ(worst, 20);
  const BundleAdjustment robust = adjustBundle(seen.places, seen.sightings, seen.truth, true);
  ASSERT_EQ(robust.status, SolveStatus::ok);
  EXPECT_LT(squaredErrors(seen, robust), 4);
  EXPECT_GT(squaredErrors(seen, adjusted), 1.3 * squaredErrors(seen, robust));
}

TEST(BundleAdjustment, WhatCannotBeSolvedSaysWhy)
{
  RandomStream random(5);
  Seen seen = seeAlong(2, false, random);
  EXPECT_EQ(adjustBundle({}, {}, {}).status, SolveStatus::too_few);
  EXPECT_EQ(adjustBundle(seen.places, std::span(seen.sightings).first(3), seen.truth).status, SolveStatus::too_few);
  std::vector<LandmarkObservation> twice(4, seen.sightings[0]);
  EXPECT_EQ(adjustBundle(seen.places, twice, {seen.truth[0]}).status, SolveStatus::degenerate) << "no parallax";
  seen.sightings[0].place = 99;
  EXPECT_EQ(adjustBundle(seen.places, seen.sightings, seen.truth).status, SolveStatus::bad_input);
}
}  // namespace mrpt_ext
