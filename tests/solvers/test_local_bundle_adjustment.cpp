#include "mrpt_ext/solvers/local_bundle_adjustment.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "trajectory_scene.h"

namespace mrpt_ext::test_local_bundle_adjustment
{
namespace
{
constexpr double kStdBearing = degToRad(0.1), kStdRange = 0.02;
const Vector3d kStepNoise(0.01, 0.01, degToRad(0.5));
const std::vector<Vector2d> kLandmarks{{4, 1}, {1, 5}, {-3, -2}, {6, -3}, {-2, 4}, {3, -5}, {-5, 1}, {2, 3}};

struct Observed
{
  DrivenTrajectory drive;
  std::vector<ScanPose> poses;
  std::vector<LandmarkObservation> observations;
  std::vector<Vector2d> truth;  // present robot frame
};

Observed observedAlong(std::size_t landmarks, bool ranges, RandomStream& random)
{
  Observed observed;
  observed.drive = driveSteps({0.5, 0.3, 0.4}, {0.25, 0, 0.1}, 8, kStepNoise, random);
  for (std::size_t j = 0; j < landmarks; ++j)
    observed.truth.push_back(transform(inverse(observed.drive.now()), kLandmarks[j]));
  for (std::size_t k = 0; k < observed.drive.poses.size(); ++k)
  {
    observed.poses.push_back({observed.drive.poses[k], observed.drive.covariances[k]});
    for (std::size_t j = 0; j < landmarks; ++j)
    {
      LandmarkObservation s{.scan = k, .landmark = j, .std_bearing = kStdBearing, .std_range = kStdRange};
      s.bearing = predictBearing(observed.drive.true_poses[k], kLandmarks[j]) + kStdBearing * random.gaussian();
      if (ranges) s.range = predictRange(observed.drive.true_poses[k], kLandmarks[j]) + kStdRange * random.gaussian();
      observed.observations.push_back(s);
    }
  }
  return observed;
}

double squaredErrors(const Observed& observed, const BundleAdjustment& adjusted)
{
  double sum = 0;
  for (std::size_t j = 0; j < observed.truth.size(); ++j)
  {
    const Vector2d e = adjusted.landmarks[j].mean - observed.truth[j];
    sum += e.dot(adjusted.landmarks[j].covariance.inverse() * e);
  }
  return sum / static_cast<double>(observed.truth.size());
}
}  // namespace

TEST(BundleAdjustment, OneLandmarkAloneIsLocatedAsByLocateLandmark)
{
  RandomStream random(1);
  const Observed observed = observedAlong(1, false, random);
  std::vector<WindowObservation> observations;
  for (const LandmarkObservation& s : observed.observations)
    observations.push_back({observed.poses[s.scan].T_robot_sensor, observed.poses[s.scan].odometry_covariance,
                            s.bearing, s.range, s.std_bearing, s.std_range});
  const WindowLandmark alone = locateLandmark(observations);
  const BundleAdjustment adjusted = adjustBundle(observed.poses, observed.observations, observed.truth);
  ASSERT_EQ(adjusted.status, SolveStatus::ok);
  const GaussianPoint &a = alone.candidates.front().in_robot, &b = adjusted.landmarks.front();
  EXPECT_LT((a.mean - b.mean).norm(), 0.1 * std::sqrt(a.covariance.trace())) << "to the order of the linearisation";
  EXPECT_LT((a.covariance - b.covariance).norm(), 0.05 * a.covariance.norm());
}

TEST(BundleAdjustment, ErrorsAreConsistentWithTheCovariance)
{
  RandomStream random(2);
  const int trials = 300;
  for (const bool ranges : {false, true})
  {
    double squared = 0, chi2 = 0;
    int degrees = 0;
    for (int trial = 0; trial < trials; ++trial)
    {
      const Observed observed = observedAlong(kLandmarks.size(), ranges, random);
      const BundleAdjustment adjusted = adjustBundle(observed.poses, observed.observations, observed.truth);
      ASSERT_EQ(adjusted.status, SolveStatus::ok);
      squared += squaredErrors(observed, adjusted) / trials;
      chi2 += adjusted.chi2 / trials;
      degrees = adjusted.degrees;
    }
    EXPECT_NEAR(squared, 2, 0.3) << ranges;
    EXPECT_NEAR(chi2 / degrees, 1, 0.05) << ranges;
  }
}

TEST(BundleAdjustment, ManyLandmarksTogetherCorrectTheOdometry)
{
  RandomStream random(3);
  const Observed observed = observedAlong(kLandmarks.size(), true, random);
  const BundleAdjustment adjusted = adjustBundle(observed.poses, observed.observations, observed.truth);
  const ScanPose &before = observed.poses.front(), &after = adjusted.poses.front();
  EXPECT_LT(after.odometry_covariance(2, 2), 0.05 * before.odometry_covariance(2, 2));
  const Pose2 truth = between(observed.drive.now(), observed.drive.true_poses.front());
  EXPECT_LT(std::abs(wrap(after.T_robot_sensor.phi - truth.phi)), 4 * std::sqrt(after.odometry_covariance(2, 2)));
  EXPECT_LT((after.T_robot_sensor.position() - truth.position()).norm(), 0.05);
}

TEST(BundleAdjustment, AnOutlierHasTheLargestMisfitAndARobustFitIgnoresIt)
{
  RandomStream random(4);
  Observed observed = observedAlong(kLandmarks.size(), false, random);
  *observed.observations[20].bearing += degToRad(5);
  const BundleAdjustment adjusted = adjustBundle(observed.poses, observed.observations, observed.truth);
  ASSERT_EQ(adjusted.status, SolveStatus::ok);
  const auto worst = std::max_element(adjusted.misfits.begin(), adjusted.misfits.end()) - adjusted.misfits.begin();
  EXPECT_EQ(worst, 20);
  const BundleAdjustment robust = adjustBundle(observed.poses, observed.observations, observed.truth, true);
  ASSERT_EQ(robust.status, SolveStatus::ok);
  EXPECT_LT(squaredErrors(observed, robust), 4);
  EXPECT_GT(squaredErrors(observed, adjusted), 1.3 * squaredErrors(observed, robust));
}

TEST(BundleAdjustment, ReportsWhyThereIsNoSolution)
{
  RandomStream random(5);
  Observed observed = observedAlong(2, false, random);
  EXPECT_EQ(adjustBundle({}, {}, {}).status, SolveStatus::too_few);
  EXPECT_EQ(adjustBundle(observed.poses, std::span(observed.observations).first(3), observed.truth).status,
            SolveStatus::too_few);
  std::vector<LandmarkObservation> twice(4, observed.observations[0]);
  EXPECT_EQ(adjustBundle(observed.poses, twice, {observed.truth[0]}).status, SolveStatus::degenerate) << "no parallax";
  observed.observations[0].scan = 99;
  EXPECT_EQ(adjustBundle(observed.poses, observed.observations, observed.truth).status, SolveStatus::bad_input);
}
}  // namespace mrpt_ext::test_local_bundle_adjustment
