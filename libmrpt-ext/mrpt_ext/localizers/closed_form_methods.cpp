#include "mrpt_ext/localizers/closed_form_methods.h"

#include <algorithm>
#include <map>

#include "mrpt_ext/hypotheses/landmark_measurement.h"
#include "mrpt_ext/hypotheses/propose_from_association.h"
#include "mrpt_ext/hypotheses/propose_from_window.h"
#include "mrpt_ext/hypotheses/window_readings.h"
#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "mrpt_ext/solvers/pose_from_landmarks.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/range_position.h"
#include "mrpt_ext/solvers/two_landmark_pose.h"

namespace mrpt_ext
{
namespace
{
/// Means of repeated sightings of one landmark by one sensor place, in the order of first appearance.
std::vector<LandmarkMeasurement> averaged(const std::vector<LandmarkMeasurement>& sightings)
{
  std::vector<std::vector<LandmarkMeasurement>> groups;
  for (const LandmarkMeasurement& s : sightings)
  {
    const auto same = [&](const std::vector<LandmarkMeasurement>& group)
    {
      const LandmarkMeasurement& other = group.front();
      return other.landmark == s.landmark && other.T_robot_sensor.vector() == s.T_robot_sensor.vector() &&
             other.bearing.has_value() == s.bearing.has_value() && other.range.has_value() == s.range.has_value();
    };
    const auto group = std::find_if(groups.begin(), groups.end(), same);
    if (group == groups.end())
      groups.push_back({s});
    else
      group->push_back(s);
  }
  std::vector<LandmarkMeasurement> result;
  for (const auto& group : groups)
  {
    LandmarkMeasurement mean = group.front();
    const auto n = static_cast<double>(group.size());
    double turned = 0, range = 0;
    for (const LandmarkMeasurement& s : group)
    {
      if (mean.bearing) turned += wrap(*s.bearing - *group.front().bearing) / n;
      if (mean.range) range += *s.range / n;
    }
    if (mean.bearing) mean.bearing = wrap(*mean.bearing + turned);
    if (mean.range) mean.range = range;
    mean.std_bearing /= std::sqrt(n);
    mean.std_range /= std::sqrt(n);
    result.push_back(mean);
  }
  return result;
}

std::vector<LandmarkMeasurement> bearingsOf(const Frame& frame, const LandmarkTable& map)
{
  std::vector<LandmarkMeasurement> bearings = identifiedSightings(frame.readings, map);
  std::erase_if(bearings, [](const LandmarkMeasurement& s) { return !s.bearing; });
  for (LandmarkMeasurement& s : bearings) s.range.reset();
  return averaged(bearings);
}

/// The frame the closed form works in: the sensor's, when all sightings come from one, else the robot's.
struct WorkingFrame
{
  Pose2 T_robot_frame;
  std::vector<KnownBearing> bearings;
};

WorkingFrame workingFrame(const std::vector<LandmarkMeasurement>& sightings)
{
  WorkingFrame frame;
  const Pose2& first = sightings.front().T_robot_sensor;
  const bool single =
      std::all_of(sightings.begin(), sightings.end(),
                  [&](const LandmarkMeasurement& s) { return s.T_robot_sensor.vector() == first.vector(); });
  if (single) frame.T_robot_frame = first;
  for (const LandmarkMeasurement& s : sightings)
    frame.bearings.push_back(
        {s.position, single ? *s.bearing : wrap(*s.bearing + s.T_robot_sensor.phi), s.std_bearing});
  return frame;
}

ClosedFormAnswer single(SolveStatus status, const GaussianPose& pose, const char* source)
{
  ClosedFormAnswer answer{.status = status};
  if (status == SolveStatus::ok) answer.candidates.push_back({.pose = pose, .source = source});
  return answer;
}

/// In a frame joined through odometry the errors of the way are shared: poses are refined with them.
void refineJoined(HypothesisSet& candidates, std::vector<Reading> readings, const LandmarkTable& map)
{
  for (Reading& reading : readings)
    for (Detection& detection : reading.detections) detection.range.reset();
  for (PoseHypothesis& h : candidates)
    if (const auto refined = refineOnWindow(readings, map, h.pose.mean)) h.pose = *refined;
}

const auto kAnySighting = [](const LandmarkMeasurement&) { return true; };

/// True when bearings give a pose: of three landmarks, or of two when they are seen from several places on the robot
/// (paper 001's cameras).
bool giveAPose(const std::vector<LandmarkMeasurement>& bearings)
{
  const std::size_t landmarks = distinctLandmarks(bearings, kAnySighting);
  if (landmarks != 2) return landmarks > 2;
  return bearings.size() > 2 &&
         std::any_of(bearings.begin(), bearings.end(),
                     [&](const LandmarkMeasurement& s)
                     { return s.T_robot_sensor.position() != bearings.front().T_robot_sensor.position(); });
}
}  // namespace

ClosedFormAnswer bearingLeastSquares(const Frame& frame, const LandmarkTable& map)
{
  const std::vector<LandmarkMeasurement> sightings = bearingsOf(frame, map);
  if (distinctLandmarks(sightings, kAnySighting) < 3) return {};
  const WorkingFrame work = workingFrame(sightings);
  const BearingPoseLinear fit = solveBearingPoseLinear(work.bearings);
  if (fit.status != SolveStatus::ok) return {.status = fit.status};
  const Pose2 robot = compose(fit.pose, inverse(work.T_robot_frame));
  const auto covariance = covarianceFromInformation(poseInformation(poseMeasurements(sightings), robot));
  if (!covariance) return {.status = SolveStatus::degenerate};
  return single(SolveStatus::ok, {robot, *covariance}, "bearing_least_squares");
}

ClosedFormAnswer bearingMaximumLikelihood(const Frame& frame, const LandmarkTable& map)
{
  const std::vector<LandmarkMeasurement> sightings = bearingsOf(frame, map);
  if (!giveAPose(sightings)) return {};
  // A frame in doubt is answered too, and says so by its status.
  const IdentifiedPose solved = solvePoseFromLandmarks(poseMeasurements(sightings));
  ClosedFormAnswer answer{.status = solved.status};
  for (const PoseCandidate& candidate : solved.candidates)
    answer.candidates.push_back(
        {.pose = candidate.pose, .log_score = -0.5 * candidate.chi2, .source = "bearing_maximum_likelihood"});
  if (isWindow(frame.readings)) refineJoined(answer.candidates, frame.readings, map);
  return answer;
}

ClosedFormAnswer rangeLeastSquares(const Frame& frame, const LandmarkTable& map, const PoseRegion& region)
{
  std::vector<LandmarkMeasurement> sightings = identifiedSightings(frame.readings, map);
  std::erase_if(sightings, [](const LandmarkMeasurement& s) { return !s.range; });
  for (LandmarkMeasurement& s : sightings) s.bearing.reset();
  sightings = averaged(sightings);
  if (distinctLandmarks(sightings, kAnySighting) < 2) return {};
  // Without a heading the sensor's offset on the robot points anywhere: it widens the covariance instead.
  std::vector<KnownRange> ranges;
  double offset = 0;
  for (const LandmarkMeasurement& s : sightings)
  {
    ranges.push_back({s.position, *s.range, s.std_range});
    offset = std::max(offset, s.T_robot_sensor.position().norm());
  }
  const RangePositions places = solveRangePosition(ranges);
  ClosedFormAnswer answer{.status = places.status};
  for (const RangePosition& place : places.candidates)
  {
    PoseHypothesis h{.log_score = -0.5 * place.chi2, .source = "range_least_squares", .heading_known = false};
    h.pose.mean = {place.position.mean.x(), place.position.mean.y(), 0};
    h.pose.covariance.topLeftCorner<2, 2>() = place.position.covariance + square(offset) * Matrix2d::Identity();
    if (region.contains({h.pose.mean.x, h.pose.mean.y, region.phi_low})) answer.candidates.push_back(h);
  }
  if (answer.candidates.empty() && answer.status == SolveStatus::ok) answer.status = SolveStatus::none;
  return answer;
}

ClosedFormAnswer twoLandmarkPose(const Frame& frame, const LandmarkTable& map)
{
  std::vector<LandmarkMeasurement> sightings = identifiedSightings(frame.readings, map);
  std::erase_if(sightings, [](const LandmarkMeasurement& s) { return !s.hasPoint(); });
  sightings = averaged(sightings);
  if (distinctLandmarks(sightings, kAnySighting) < 2) return {};
  std::vector<SeenLandmark> seen;
  for (const LandmarkMeasurement& s : sightings) seen.push_back({s.position, {s.pointInRobot(), s.pointCovariance()}});
  const PointPose fit = solvePointPose(seen);
  return single(fit.status, fit.pose, "two_landmark_pose");
}

ClosedFormAnswer interpretationTree(const Frame& frame, const LandmarkTable& map, const GlobalPoseSearch& search,
                                    const PoseRegion& region)
{
  ReadingInterpretation found = interpretReadings(frame.readings, map, search, region);
  return {found.status, std::move(found.hypotheses), found.unique};
}
}  // namespace mrpt_ext
