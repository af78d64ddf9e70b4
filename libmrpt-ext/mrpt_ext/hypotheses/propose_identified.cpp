#include <algorithm>
#include <array>

#include "mrpt_ext/hypotheses/pose_proposals.h"
#include "mrpt_ext/solvers/bearing_pose_ml.h"
#include "mrpt_ext/solvers/heading_from_landmark.h"
#include "mrpt_ext/solvers/pose_ml.h"
#include "mrpt_ext/solvers/pose_ring.h"
#include "mrpt_ext/solvers/range_position_robust.h"
#include "mrpt_ext/solvers/two_landmark_pose.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxSubsets = 80;         // minimal subsets per type of measurement
constexpr std::size_t kMaxMeasurements = 200;   // used for triples: the newest, with least odometry error
constexpr double kMinDistanceForHeading = 0.3;  // [m] between the ranges of a window that determine a heading
constexpr int kHeadingStarts = 12;

std::vector<LandmarkMeasurement> only(std::span<const LandmarkMeasurement> measurements, bool bearing, bool range)
{
  std::vector<LandmarkMeasurement> result;
  for (const LandmarkMeasurement& m : measurements)
    if ((!bearing || m.bearing) && (!range || m.range)) result.push_back(m);
  return result;
}

/// Keeps at most kMaxSubsets entries, evenly spaced, so that all parts of the frame are represented.
template <typename Subset>
void thin(std::vector<Subset>& subsets)
{
  if (subsets.size() <= kMaxSubsets) return;
  std::vector<Subset> kept;
  for (std::size_t k = 0; k < kMaxSubsets; ++k) kept.push_back(subsets[k * subsets.size() / kMaxSubsets]);
  subsets = std::move(kept);
}

/// The last kMaxMeasurements of a list that is ordered by time.
template <typename Measured>
std::span<const Measured> newest(const std::vector<Measured>& measurements)
{
  return std::span(measurements).last(std::min(measurements.size(), kMaxMeasurements));
}

/// Largest distance [m] of a sensor position from the first one.
double distanceCovered(std::span<const LandmarkMeasurement> measurements)
{
  double longest = 0;
  for (const LandmarkMeasurement& m : measurements)
    longest = std::max(longest, (m.T_robot_sensor.position() - measurements.front().T_robot_sensor.position()).norm());
  return longest;
}
}  // namespace

HypothesisSet proposeFromPointPairs(std::span<const LandmarkMeasurement> measurements)
{
  const std::vector<LandmarkMeasurement> points = only(measurements, true, true);
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      if (points[i].landmark != points[j].landmark) pairs.push_back({i, j});
  thin(pairs);
  HypothesisSet result;
  for (const auto& pair : pairs)
  {
    std::vector<SeenLandmark> seen;
    for (const std::size_t i : pair)
      seen.push_back({points[i].position, {points[i].pointInRobot(), points[i].pointCovariance()}});
    const PointPose fit = solvePointPose(seen);
    if (fit.status == SolveStatus::ok) result.push_back({.pose = fit.pose, .source = "two_landmark_pose"});
  }
  return result;
}

HypothesisSet proposeFromBearings(std::span<const LandmarkMeasurement> measurements)
{
  const std::vector<LandmarkMeasurement> with_bearing = only(measurements, true, false);
  const std::span<const LandmarkMeasurement> bearings = newest(with_bearing);
  std::vector<std::array<std::size_t, 3>> triples;
  for (std::size_t i = 0; i < bearings.size(); ++i)
    for (std::size_t j = i + 1; j < bearings.size(); ++j)
      for (std::size_t k = j + 1; k < bearings.size(); ++k)
        if (bearings[i].landmark != bearings[j].landmark && bearings[j].landmark != bearings[k].landmark &&
            bearings[i].landmark != bearings[k].landmark)
          triples.push_back({i, j, k});
  thin(triples);
  HypothesisSet result;
  for (const auto& triple : triples)
  {
    // The closed form assumes all sensors at the robot's centre; the refinement uses the sensor poses.
    std::vector<KnownBearing> known;
    std::vector<LandmarkMeasurement> members;
    for (const std::size_t i : triple)
    {
      const LandmarkMeasurement& m = bearings[i];
      known.push_back({m.position, wrap(*m.bearing + m.T_robot_sensor.phi), m.std_bearing});
      members.push_back(m);
      members.back().range.reset(), members.back().headings.reset();
    }
    const PoseMl start = solveBearingPoseMl(known);
    if (start.status != SolveStatus::ok) continue;
    const PoseMl fit = refinePose(poseMeasurements(members), start.pose.mean);
    if (fit.status == SolveStatus::ok) result.push_back({.pose = fit.pose, .source = "bearing_maximum_likelihood"});
  }
  return result;
}

namespace
{
/// Adds hypotheses at a position: heading from bearings, from the motion within the window, or unknown.
void addWithHeading(const RangePosition& fit, std::span<const LandmarkMeasurement> measurements, HypothesisSet& result)
{
  const Pose2 at{fit.position.mean.x(), fit.position.mean.y(), 0};
  std::vector<double> starts;
  for (const LandmarkMeasurement& m : measurements)
    if (m.bearing)
      if (const auto heading = headingFromBearing(m.position, fit.position.mean, *m.bearing))
        starts.push_back(wrap(*heading - m.T_robot_sensor.phi));
  thin(starts);
  if (starts.empty() && distanceCovered(measurements) > kMinDistanceForHeading)
    for (int k = 0; k < kHeadingStarts; ++k) starts.push_back(wrap(kTwoPi * k / kHeadingStarts));
  const std::vector<PoseMeasurement> rows = poseMeasurements(measurements);
  bool found = false;
  for (const double heading : starts)
  {
    const PoseMl refined = refinePose(rows, {at.x, at.y, heading}, Loss::cauchy);
    if (refined.status != SolveStatus::ok) continue;
    found = true;
    result.push_back({.pose = refined.pose, .source = "range_least_squares"});
  }
  if (found) return;
  PoseHypothesis any_heading{.pose = {at, Matrix3d::Zero()}, .source = "range_least_squares", .heading_known = false};
  const double offset = measurements.front().T_robot_sensor.position().norm();
  any_heading.pose.covariance.topLeftCorner<2, 2>() = fit.position.covariance + square(offset) * Matrix2d::Identity();
  result.push_back(any_heading);
}
}  // namespace

HypothesisSet proposeFromRanges(std::span<const LandmarkMeasurement> measurements)
{
  HypothesisSet result;
  std::vector<KnownRange> ranges;
  for (const LandmarkMeasurement& m : measurements)
    if (m.range)
    {
      // The range of a sensor off the robot's centre, or of an earlier pose, is known to within that offset.
      const double offset = m.T_robot_sensor.position().norm();
      ranges.push_back({m.position, *m.range, std::sqrt(square(m.std_range) + square(offset))});
    }
  if (ranges.size() < 2) return result;
  for (const RobustRangePosition& candidate : solveRangePositionRobust(newest(ranges)).candidates)
    addWithHeading(candidate.fit, measurements, result);
  return result;
}

namespace
{
PoseRing ringOf(const LandmarkMeasurement& m)
{
  return makePoseRing(m.position, *m.range, m.std_range, *m.bearing, m.std_bearing, m.T_robot_sensor);
}
}  // namespace

HypothesisSet proposeFromFacing(std::span<const LandmarkMeasurement> measurements)
{
  std::vector<LandmarkMeasurement> facing = only(measurements, true, true);
  std::erase_if(facing, [](const LandmarkMeasurement& m) { return !m.headings; });
  thin(facing);
  HypothesisSet result;
  for (const LandmarkMeasurement& m : facing)
    for (const PoseOnRing& found : posesOnRing(ringOf(m), *m.headings))
      result.push_back({.pose = found.pose, .source = "oriented_landmark"});
  return result;
}

HypothesisSet proposeFromRing(std::span<const LandmarkMeasurement> measurements, std::size_t points)
{
  HypothesisSet result;
  const std::vector<LandmarkMeasurement> seen = only(measurements, true, true);
  if (seen.empty()) return result;
  const PoseRing ring = ringOf(seen.back());  // the newest
  for (const HeadingPrior& heading : headingsToTry(std::nullopt, points))
    result.push_back({.pose = gaussianOnRing(ring, heading.heading, heading.std_heading), .source = "ring"});
  return result;
}
}  // namespace mrpt_ext
