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
constexpr std::size_t kMaxSubsets = 80;     // minimal subsets tried per kind of evidence
constexpr std::size_t kMaxSightings = 200;  // of which triples are formed; the newest carry least odometry error
constexpr double kTravelForHeading = 0.3;   // [m] way between joined ranges that tells the heading
constexpr int kHeadingStarts = 12;

std::vector<LandmarkMeasurement> only(std::span<const LandmarkMeasurement> sightings, bool bearing, bool range)
{
  std::vector<LandmarkMeasurement> result;
  for (const LandmarkMeasurement& s : sightings)
    if ((!bearing || s.bearing) && (!range || s.range)) result.push_back(s);
  return result;
}

/// Keeps at most kMaxSubsets entries, evenly spaced, so that all parts of the frame stay represented.
template <typename Subset>
void thin(std::vector<Subset>& subsets)
{
  if (subsets.size() <= kMaxSubsets) return;
  std::vector<Subset> kept;
  for (std::size_t k = 0; k < kMaxSubsets; ++k) kept.push_back(subsets[k * subsets.size() / kMaxSubsets]);
  subsets = std::move(kept);
}

/// The last kMaxSightings of a list that is ordered by time.
template <typename Measured>
std::span<const Measured> newest(const std::vector<Measured>& sightings)
{
  return std::span(sightings).last(std::min(sightings.size(), kMaxSightings));
}

/// Largest distance between the places that the sightings were made from.
double travel(std::span<const LandmarkMeasurement> sightings)
{
  double longest = 0;
  for (const LandmarkMeasurement& s : sightings)
    longest = std::max(longest, (s.T_robot_sensor.position() - sightings.front().T_robot_sensor.position()).norm());
  return longest;
}
}  // namespace

HypothesisSet proposeFromPointPairs(std::span<const LandmarkMeasurement> sightings)
{
  const std::vector<LandmarkMeasurement> points = only(sightings, true, true);
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

HypothesisSet proposeFromBearings(std::span<const LandmarkMeasurement> sightings)
{
  const std::vector<LandmarkMeasurement> with_bearing = only(sightings, true, false);
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
    // The closed form takes all bearings from the robot's centre; the refinement puts each sensor in its place.
    std::vector<KnownBearing> known;
    std::vector<LandmarkMeasurement> members;
    for (const std::size_t i : triple)
    {
      const LandmarkMeasurement& s = bearings[i];
      known.push_back({s.position, wrap(*s.bearing + s.T_robot_sensor.phi), s.std_bearing});
      members.push_back(s);
      members.back().range.reset();
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
/// A position without heading, as a hypothesis: heading from the first bearing, from the way, or left open.
void addWithHeading(const RangePosition& place, std::span<const LandmarkMeasurement> sightings, HypothesisSet& result)
{
  const Pose2 at{place.position.mean.x(), place.position.mean.y(), 0};
  std::vector<double> starts;
  for (const LandmarkMeasurement& s : sightings)
    if (s.bearing)
      if (const auto heading = headingFromBearing(s.position, place.position.mean, *s.bearing))
        starts.push_back(wrap(*heading - s.T_robot_sensor.phi));
  thin(starts);
  if (starts.empty() && travel(sightings) > kTravelForHeading)
    for (int k = 0; k < kHeadingStarts; ++k) starts.push_back(wrap(kTwoPi * k / kHeadingStarts));
  const std::vector<PoseMeasurement> rows = poseMeasurements(sightings);
  bool found = false;
  for (const double heading : starts)
  {
    const PoseMl fit = refinePose(rows, {at.x, at.y, heading}, {.loss = Loss::cauchy});
    if (fit.status != SolveStatus::ok) continue;
    found = true;
    result.push_back({.pose = fit.pose, .source = "range_least_squares"});
  }
  if (found) return;
  PoseHypothesis open{.pose = {at, Matrix3d::Zero()}, .source = "range_least_squares", .heading_known = false};
  const double offset = sightings.front().T_robot_sensor.position().norm();
  open.pose.covariance.topLeftCorner<2, 2>() = place.position.covariance + square(offset) * Matrix2d::Identity();
  result.push_back(open);
}
}  // namespace

HypothesisSet proposeFromRanges(std::span<const LandmarkMeasurement> sightings)
{
  HypothesisSet result;
  std::vector<KnownRange> ranges;
  for (const LandmarkMeasurement& s : sightings)
    if (s.range)
    {
      // From another place of the way, or off the centre, the range holds for the robot to within that distance.
      const double offset = s.T_robot_sensor.position().norm();
      ranges.push_back({s.position, *s.range, std::sqrt(square(s.std_range) + square(offset))});
    }
  if (ranges.size() < 2) return result;
  for (const RobustRangePosition& candidate : solveRangePositionRobust(newest(ranges)).candidates)
    addWithHeading(candidate.fit, sightings, result);
  return result;
}

HypothesisSet proposeFromRing(std::span<const LandmarkMeasurement> sightings, std::size_t points)
{
  HypothesisSet result;
  const std::vector<LandmarkMeasurement> seen = only(sightings, true, true);
  if (seen.empty()) return result;
  const LandmarkMeasurement& s = seen.back();  // the newest
  const PoseRing ring = makePoseRing(s.position, *s.range, s.std_range, *s.bearing, s.std_bearing, s.T_robot_sensor);
  const double spacing = kTwoPi / static_cast<double>(points);
  for (std::size_t k = 0; k < points; ++k)
    result.push_back(
        {.pose = gaussianOnRing(ring, wrap(spacing * static_cast<double>(k)), spacing / 2), .source = "ring"});
  return result;
}
}  // namespace mrpt_ext
