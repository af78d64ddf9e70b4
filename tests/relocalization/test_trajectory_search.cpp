#include "mrpt_ext/relocalization/trajectory_search.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStdBearing = degToRad(0.7), kStdRange = 0.1;
const PoseRegion kRegion{{-2, -2}, {14, 10}};

/// Fifteen alike landmarks in a room of 12 m x 8 m, without symmetry.
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

struct Travel
{
  std::vector<TrajectoryStep> steps;
  Pose2 end;  ///< truth
};

/// Round the middle of the room, 0.25 m a step; a camera that looks 66 deg wide and 6 m far sees four of five
/// landmarks, and now and then one that is not there.
Travel travel(int count, bool with_range, RandomStream& random)
{
  SensorModel camera{.field_of_view = degToRad(66.0), .max_range = 6.0, .clutter_probability = 0.05};
  const Vector3d std(0.02, 0.02, degToRad(1.5));
  Pose2 robot{random.uniform(4, 8), random.uniform(3, 5), random.uniform(-kPi, kPi)};
  Travel travel;
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
    Scan place{{}, camera, {}};
    const auto see = [&](const Vector2d& v)
    {
      AnonymousDetection d{.std_bearing = kStdBearing, .std_range = kStdRange};
      d.bearing = wrap(std::atan2(v.y(), v.x()) + kStdBearing * random.gaussian());
      if (with_range) d.range = std::abs(v.norm() + kStdRange * random.gaussian());
      place.detections.push_back(d);
    };
    for (const Landmark& landmark : kRoom.all())
    {
      const Vector2d v = transform(inverse(robot), landmark.position.head<2>());
      if (v.norm() < 6 && std::abs(std::atan2(v.y(), v.x())) < degToRad(33.0) && random.chance(0.8)) see(v);
    }
    if (random.chance(0.1)) see({random.uniform(1, 5), random.uniform(-0.5, 0.5)});
    if (!place.detections.empty()) step.seen.push_back(std::move(place));
    travel.steps.push_back(std::move(step));
  }
  travel.end = robot;
  return travel;
}

bool isAt(const Pose2& pose, const Pose2& truth)
{
  return (pose.position() - truth.position()).norm() < 0.5 && std::abs(wrap(pose.phi - truth.phi)) < degToRad(10.0);
}

struct Tally
{
  int sure = 0, right = 0;
  double squared_error = 0;
};

Tally tallyOf(int trials, int steps, bool with_range)
{
  RandomStream random(5);
  Tally tally;
  for (int t = 0; t < trials; ++t)
  {
    const Travel way = travel(steps, with_range, random);
    const TrajectorySearchResult found = localizeOverTrajectory(way.steps, kSearch, kRegion);
    if (found.hypotheses.empty() || found.hypotheses.front().weight < 0.95) continue;
    ++tally.sure;
    const GaussianPose& best = found.hypotheses.front().pose;
    if (!isAt(best.mean, way.end)) continue;
    ++tally.right;
    const Vector3d e(best.mean.x - way.end.x, best.mean.y - way.end.y, wrap(best.mean.phi - way.end.phi));
    tally.squared_error += e.dot(best.covariance.inverse() * e);
  }
  return tally;
}
}  // namespace

TEST(TrajectorySearchResult, RangesAndBearingsAlongAWayFindTheRobot)
{
  const Tally tally = tallyOf(60, 25, true);
  EXPECT_GE(tally.sure, 45);
  EXPECT_GE(tally.right, 0.95 * tally.sure);
  const double nees = tally.squared_error / tally.right;  // 3 expected
  EXPECT_GT(nees, 1.8);
  EXPECT_LT(nees, 4.5);
}

TEST(TrajectorySearchResult, BearingsAlongAWayFindTheRobot)
{
  const Tally tally = tallyOf(12, 25, false);
  EXPECT_GE(tally.sure, 5);
  EXPECT_GE(tally.right, 0.9 * tally.sure);
}

TEST(TrajectorySearchResult, SupposedPosesAreJudgedByTheSameEvidence)
{
  RandomStream random(9);
  int right_first = 0;
  for (int t = 0; t < 10; ++t)
  {
    const Travel way = travel(25, false, random);
    const Matrix3d covariance = Vector3d(0.01, 0.01, 0.002).asDiagonal();
    const std::vector<GaussianPose> supposed{{{6, 4, wrap(way.end.phi + 2)}, covariance}, {way.end, covariance}};
    const TrajectorySearchResult found = localizeOverTrajectory(way.steps, kSearch, kRegion, supposed);
    ASSERT_FALSE(found.hypotheses.empty());
    const bool among = std::any_of(found.hypotheses.begin(), found.hypotheses.end(),
                                   [&](const PoseHypothesis& h) { return isAt(h.pose.mean, way.end); });
    EXPECT_TRUE(among) << t;
    right_first += isAt(found.hypotheses.front().pose.mean, way.end);
  }
  EXPECT_GE(right_first, 9);
}

TEST(TrajectorySearchResult, WeightsLeaveRoomForElsewhere)
{
  RandomStream random(7);
  const TrajectorySearchResult found = localizeOverTrajectory(travel(8, true, random).steps, kSearch, kRegion);
  double sum = found.probability_elsewhere;
  for (const PoseHypothesis& h : found.hypotheses) sum += h.weight;
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST(TrajectorySearchResult, NothingSeenIsTooFew)
{
  EXPECT_EQ(localizeOverTrajectory({}, kSearch, kRegion).status, SolveStatus::too_few);
  const GaussianPose supposed{{4, 4, 0}, Matrix3d::Identity()};
  EXPECT_EQ(localizeOverTrajectory({}, kSearch, kRegion, {&supposed, 1}).status, SolveStatus::too_few);
  const std::vector<TrajectoryStep> blind(5);
  EXPECT_EQ(localizeOverTrajectory(blind, kSearch, kRegion).status, SolveStatus::too_few);
  EXPECT_EQ(localizeOverTrajectory(blind, kSearch, kRegion).probability_elsewhere, 1);
}

TEST(HypothesisTrack, ThereAndBackIsWhereItWas)
{
  HypothesisTrack track{{{1, 2, 0.5}, Matrix3d::Identity() * 0.01}, 0};
  const TrajectoryStep step{{0.3, 0.1, 0.4}, Vector3d(1e-4, 2e-4, 3e-4).asDiagonal(), {}};
  const Matrix3d before = track.pose.covariance;
  predict(track, step);
  retrodict(track, step);
  EXPECT_NEAR(track.pose.mean.x, 1, 1e-12);
  EXPECT_NEAR(track.pose.mean.phi, 0.5, 1e-12);
  EXPECT_GT((track.pose.covariance - before).trace(), 2 * 5.9e-4);  // noise both ways
}
}  // namespace mrpt_ext
