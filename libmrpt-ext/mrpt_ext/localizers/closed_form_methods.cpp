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
constexpr double kOutlierGate = 3.3;  ///< standard deviations: one error in a thousand

/// Averages repeated measurements of one landmark from one sensor pose, in the order of first appearance.
std::vector<LandmarkMeasurement> averaged(const std::vector<LandmarkMeasurement>& measurements)
{
  std::vector<std::vector<LandmarkMeasurement>> groups;
  for (const LandmarkMeasurement& m : measurements)
  {
    const auto same = [&](const std::vector<LandmarkMeasurement>& group)
    {
      const LandmarkMeasurement& other = group.front();
      return other.landmark == m.landmark && other.T_robot_sensor.vector() == m.T_robot_sensor.vector() &&
             other.bearing.has_value() == m.bearing.has_value() && other.range.has_value() == m.range.has_value();
    };
    const auto group = std::find_if(groups.begin(), groups.end(), same);
    if (group == groups.end())
      groups.push_back({m});
    else
      group->push_back(m);
  }
  std::vector<LandmarkMeasurement> result;
  for (const auto& group : groups)
  {
    LandmarkMeasurement mean = group.front();
    const auto n = static_cast<double>(group.size());
    double turned = 0, range = 0;
    for (const LandmarkMeasurement& m : group)
    {
      if (mean.bearing) turned += wrap(*m.bearing - *group.front().bearing) / n;
      if (mean.range) range += *m.range / n;
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
  std::vector<LandmarkMeasurement> bearings = identifiedMeasurements(frame.readings, map);
  std::erase_if(bearings, [](const LandmarkMeasurement& m) { return !m.bearing; });
  for (LandmarkMeasurement& m : bearings) m.range.reset(), m.headings.reset();
  return averaged(bearings);
}

/// The frame in which a closed form works: that of the sensor if there is only one, else that of the robot.
struct WorkingFrame
{
  Pose2 T_robot_frame;
  std::vector<KnownBearing> bearings;
};

WorkingFrame workingFrame(const std::vector<LandmarkMeasurement>& measurements)
{
  WorkingFrame frame;
  const Pose2& first = measurements.front().T_robot_sensor;
  const bool single =
      std::all_of(measurements.begin(), measurements.end(),
                  [&](const LandmarkMeasurement& m) { return m.T_robot_sensor.vector() == first.vector(); });
  if (single) frame.T_robot_frame = first;
  for (const LandmarkMeasurement& m : measurements)
    frame.bearings.push_back(
        {m.position, single ? *m.bearing : wrap(*m.bearing + m.T_robot_sensor.phi), m.std_bearing});
  return frame;
}

ClosedFormResult single(SolveStatus status, const GaussianPose& pose, const char* source)
{
  ClosedFormResult result{.status = status};
  if (status == SolveStatus::ok) result.candidates.push_back({.pose = pose, .source = source});
  return result;
}

/// In a window, readings share odometry errors: refines the poses with these modelled.
void refineInWindow(HypothesisSet& candidates, std::vector<Reading> readings, const LandmarkTable& map)
{
  for (Reading& reading : readings)
    for (Detection& detection : reading.detections) detection.range.reset();
  for (PoseHypothesis& h : candidates)
    if (const auto refined = refineOnWindow(readings, map, h.pose.mean)) h.pose = *refined;
}

/// Whether the landmarks are as far from each other as the map has them, given the errors that are stated.
bool agreesWithMap(const PointPose& fit, std::size_t landmarks)
{
  const auto redundant = static_cast<double>(2 * landmarks - 3);  // the root of a sum of so many squares is as often
  return std::sqrt(fit.chi2) <= std::sqrt(redundant - 1) + kOutlierGate;  // beyond as a single error is, or less often
}

const auto kAny = [](const LandmarkMeasurement&) { return true; };

/// True if the bearings determine a pose: to three landmarks, or to two from several positions on the robot (the
/// cameras of paper 001).
bool determinePose(const std::vector<LandmarkMeasurement>& bearings)
{
  const std::size_t landmarks = distinctLandmarks(bearings, kAny);
  if (landmarks != 2) return landmarks > 2;
  return bearings.size() > 2 &&
         std::any_of(bearings.begin(), bearings.end(),
                     [&](const LandmarkMeasurement& m)
                     { return m.T_robot_sensor.position() != bearings.front().T_robot_sensor.position(); });
}
}  // namespace

ClosedFormResult bearingLeastSquares(const Frame& frame, const LandmarkTable& map)
{
  const std::vector<LandmarkMeasurement> measurements = bearingsOf(frame, map);
  if (distinctLandmarks(measurements, kAny) < 3) return {};
  const WorkingFrame work = workingFrame(measurements);
  const BearingPoseLinear fit = solveBearingPoseLinear(work.bearings);
  if (fit.status != SolveStatus::ok) return {.status = fit.status};
  const Pose2 robot = compose(fit.pose, inverse(work.T_robot_frame));
  const auto covariance = covarianceFromInformation(poseInformation(poseMeasurements(measurements), robot));
  if (!covariance) return {.status = SolveStatus::degenerate};
  return single(SolveStatus::ok, {robot, *covariance}, "bearing_least_squares");
}

ClosedFormResult bearingMaximumLikelihood(const Frame& frame, const LandmarkTable& map)
{
  const std::vector<LandmarkMeasurement> measurements = bearingsOf(frame, map);
  if (!determinePose(measurements)) return {};
  const IdentifiedPose solved = solvePoseFromLandmarks(poseMeasurements(measurements));
  ClosedFormResult result{.status = solved.status};
  for (const PoseCandidate& candidate : solved.candidates)
    result.candidates.push_back(
        {.pose = candidate.pose, .log_score = -0.5 * candidate.chi2, .source = "bearing_maximum_likelihood"});
  if (isWindow(frame.readings)) refineInWindow(result.candidates, frame.readings, map);
  return result;
}

ClosedFormResult rangeLeastSquares(const Frame& frame, const LandmarkTable& map, const PoseRegion& region)
{
  std::vector<LandmarkMeasurement> measurements = identifiedMeasurements(frame.readings, map);
  std::erase_if(measurements, [](const LandmarkMeasurement& m) { return !m.range; });
  for (LandmarkMeasurement& m : measurements) m.bearing.reset(), m.headings.reset();
  measurements = averaged(measurements);
  if (distinctLandmarks(measurements, kAny) < 2) return {};
  // Without a heading, the direction of the sensor's offset on the robot is unknown: it inflates the covariance.
  std::vector<KnownRange> ranges;
  double offset = 0;
  for (const LandmarkMeasurement& m : measurements)
  {
    ranges.push_back({m.position, *m.range, m.std_range});
    offset = std::max(offset, m.T_robot_sensor.position().norm());
  }
  const RangePositions positions = solveRangePosition(ranges);
  ClosedFormResult result{.status = positions.status};
  for (const RangePosition& candidate : positions.candidates)
  {
    PoseHypothesis h{.log_score = -0.5 * candidate.chi2, .source = "range_least_squares", .heading_known = false};
    h.pose.mean = {candidate.position.mean.x(), candidate.position.mean.y(), 0};
    h.pose.covariance.topLeftCorner<2, 2>() = candidate.position.covariance + square(offset) * Matrix2d::Identity();
    if (region.contains({h.pose.mean.x, h.pose.mean.y, region.phi_low})) result.candidates.push_back(h);
  }
  if (result.candidates.empty() && result.status == SolveStatus::ok) result.status = SolveStatus::none;
  return result;
}

ClosedFormResult twoLandmarkPose(const Frame& frame, const LandmarkTable& map)
{
  std::vector<LandmarkMeasurement> measurements = identifiedMeasurements(frame.readings, map);
  std::erase_if(measurements, [](const LandmarkMeasurement& m) { return !m.hasPoint(); });
  measurements = averaged(measurements);
  if (distinctLandmarks(measurements, kAny) < 2) return {};
  std::vector<SeenLandmark> points;
  for (const LandmarkMeasurement& m : measurements)
    points.push_back({m.position, {m.pointInRobot(), m.pointCovariance()}});
  const PointPose fit = solvePointPose(points);
  ClosedFormResult result = single(fit.status, fit.pose, "two_landmark_pose");
  result.unique = agreesWithMap(fit, points.size());
  return result;
}

ClosedFormResult interpretationTree(const Frame& frame, const LandmarkTable& map, const GlobalPoseSearch& search,
                                    const PoseRegion& region)
{
  AssociationProposals found = proposeFromAssociation(frame.readings, map, search, region);
  return {found.status, std::move(found.hypotheses), found.unique};
}
}  // namespace mrpt_ext
