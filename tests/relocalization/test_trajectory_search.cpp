#include "mrpt_ext/relocalization/trajectory_search.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/geometry/random.h"
#include "test_length.h"

namespace mrpt_ext::test_trajectory_search
{
namespace
{
constexpr double kStdBearing = degToRad(0.7), kStdRange = 0.1;
const PoseRegion kRegion{{-2, -2}, {14, 10}};

/// Fifteen landmarks of one category in a room of 12 m x 8 m, without symmetry.
LandmarkTable room()
{
  RandomStream random(21);
  std::vector<Landmark> landmarks(15);
  for (int k = 0; k < 15; ++k)
  {
    landmarks[static_cast<std::size_t>(k)].id = k;
    landmarks[static_cast<std::size_t>(k)].position = {random.uniform(0, 12), random.uniform(0, 8), 0};
  }
  return LandmarkTable(std::move(landmarks));
}

const LandmarkTable kRoom = room();
const GlobalPoseSearch kSearch(kRoom);

struct SimulatedTrajectory
{
  std::vector<TrajectoryStep> steps;
  Pose2 end;  ///< truth
};

/// A curve around the middle of the room, 0.25 m per step. A camera (field of view 66 deg, range 6 m) detects landmarks
/// with probability 0.8; every tenth scan has a false detection.
SimulatedTrajectory simulate(int count, bool with_range, RandomStream& random)
{
  SensorModel camera{.field_of_view = degToRad(66.0), .max_range = 6.0, .clutter_probability = 0.05};
  const Vector3d std(0.02, 0.02, degToRad(1.5));
  Pose2 robot{random.uniform(4, 8), random.uniform(3, 5), random.uniform(-kPi, kPi)};
  SimulatedTrajectory trajectory;
  for (int k = 0; k < count; ++k)
  {
    TrajectoryStep step;
    if (k > 0)
    {
      step.increment = {0.25, 0, 0.2};
      const Vector3d noise(std.x() * random.gaussian(), std.y() * random.gaussian(), std.z() * random.gaussian());
      robot = compose(robot, {0.25 + noise.x(), noise.y(), 0.2 + noise.z()});
      step.noise = std.cwiseAbs2().asDiagonal();
    }
    Scan scan{{}, camera, {}};
    const auto detect = [&](const Vector2d& v)
    {
      AnonymousDetection d{.std_bearing = kStdBearing, .std_range = kStdRange};
      d.bearing = wrap(std::atan2(v.y(), v.x()) + kStdBearing * random.gaussian());
      if (with_range) d.range = std::abs(v.norm() + kStdRange * random.gaussian());
      scan.detections.push_back(d);
    };
    for (const Landmark& landmark : kRoom.all())
    {
      const Vector2d v = transform(inverse(robot), landmark.position.head<2>());
      if (v.norm() < 6 && std::abs(std::atan2(v.y(), v.x())) < degToRad(33.0) && random.chance(0.8)) detect(v);
    }
    if (random.chance(0.1)) detect({random.uniform(1, 5), random.uniform(-0.5, 0.5)});
    if (!scan.detections.empty()) step.scans.push_back(std::move(scan));
    trajectory.steps.push_back(std::move(step));
  }
  trajectory.end = robot;
  return trajectory;
}

bool isAt(const Pose2& pose, const Pose2& truth)
{
  return (pose.position() - truth.position()).norm() < 0.5 && std::abs(wrap(pose.phi - truth.phi)) < degToRad(10.0);
}

struct Tally
{
  int confident = 0, right = 0;
  double squared_error = 0;
};

Tally tallyOf(int trials, int steps, bool with_range)
{
  RandomStream random(5);
  Tally tally;
  for (int t = 0; t < trials; ++t)
  {
    const SimulatedTrajectory trajectory = simulate(steps, with_range, random);
    const TrajectorySearchResult found = localizeOverTrajectory(trajectory.steps, kSearch, kRegion);
    if (found.hypotheses.empty() || found.hypotheses.front().weight < 0.95) continue;
    ++tally.confident;
    const GaussianPose& best = found.hypotheses.front().pose;
    if (!isAt(best.mean, trajectory.end)) continue;
    ++tally.right;
    const Vector3d e(best.mean.x - trajectory.end.x, best.mean.y - trajectory.end.y,
                     wrap(best.mean.phi - trajectory.end.phi));
    tally.squared_error += e.dot(best.covariance.inverse() * e);
  }
  return tally;
}
}  // namespace

TEST(LocalizeOverTrajectory, RangesAndBearingsFindThePose)
{
  const Tally tally = tallyOf(testing::runsOfTest(60), 25, true);
  if (testing::isShort()) return;  // too few trials for the bounds
  EXPECT_GE(tally.confident, 45);
  EXPECT_GE(tally.right, 0.95 * tally.confident);
  const double nees = tally.squared_error / tally.right;  // 3 expected
  EXPECT_GT(nees, 1.8);
  EXPECT_LT(nees, 4.5);
}

TEST(LocalizeOverTrajectory, BearingsFindThePose)
{
  const Tally tally = tallyOf(testing::runsOfTest(12), 25, false);
  if (testing::isShort()) return;  // too few trials for the bounds
  EXPECT_GE(tally.confident, 5);
  EXPECT_GE(tally.right, 0.9 * tally.confident);
}

TEST(LocalizeOverTrajectory, CurrentPosesCompeteByTheSameEvidence)
{
  const int trials = testing::runsOfTest(10);
  RandomStream random(9);
  int right_first = 0;
  for (int t = 0; t < trials; ++t)
  {
    const SimulatedTrajectory trajectory = simulate(25, false, random);
    const Matrix3d covariance = Vector3d(0.01, 0.01, 0.002).asDiagonal();
    const std::vector<GaussianPose> current{{{6, 4, wrap(trajectory.end.phi + 2)}, covariance},
                                            {trajectory.end, covariance}};
    const TrajectorySearchResult found = localizeOverTrajectory(trajectory.steps, kSearch, kRegion, current);
    ASSERT_FALSE(found.hypotheses.empty());
    const bool among = std::any_of(found.hypotheses.begin(), found.hypotheses.end(),
                                   [&](const PoseHypothesis& h) { return isAt(h.pose.mean, trajectory.end); });
    EXPECT_TRUE(among) << t;
    right_first += isAt(found.hypotheses.front().pose.mean, trajectory.end);
  }
  EXPECT_GE(right_first, trials - 1);
}

TEST(LocalizeOverTrajectory, WeightsAndElsewhereAddUpToOne)
{
  RandomStream random(7);
  const TrajectorySearchResult found = localizeOverTrajectory(simulate(8, true, random).steps, kSearch, kRegion);
  double sum = found.probability_elsewhere;
  for (const PoseHypothesis& h : found.hypotheses) sum += h.weight;
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST(LocalizeOverTrajectory, WithoutDetectionsTooFew)
{
  EXPECT_EQ(localizeOverTrajectory({}, kSearch, kRegion).status, SolveStatus::too_few);
  const GaussianPose current{{4, 4, 0}, Matrix3d::Identity()};
  EXPECT_EQ(localizeOverTrajectory({}, kSearch, kRegion, {&current, 1}).status, SolveStatus::too_few);
  const std::vector<TrajectoryStep> empty(5);
  EXPECT_EQ(localizeOverTrajectory(empty, kSearch, kRegion).status, SolveStatus::too_few);
  EXPECT_EQ(localizeOverTrajectory(empty, kSearch, kRegion).probability_elsewhere, 1);
}
}  // namespace mrpt_ext::test_trajectory_search
