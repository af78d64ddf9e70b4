#include "mrpt_ext/hypotheses/interpret_readings.h"

#include <algorithm>

#include "mrpt_ext/correspondence/interpretation_tree.h"
#include "mrpt_ext/hypotheses/carried_readings.h"
#include "mrpt_ext/hypotheses/joined_places.h"
#include "mrpt_ext/hypotheses/sensor_places.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kSource = "interpretation_tree";
constexpr std::size_t kConstellation = 3;  // joined points that speak for themselves
constexpr double kGate = 3.3;              // standard deviations
constexpr double kRangeMargin = 1.3;       // a pose from few bearings may put its landmarks a little too far away

/// The place with most bearings, of several the newest.
const SensorPlace* fullestPlace(std::span<const SensorPlace> places)
{
  const auto bearings = [](const SensorPlace& place)
  {
    return std::count_if(place.detections.begin(), place.detections.end(),
                         [](const UnidentifiedDetection& d) { return d.bearing && d.kind != kNoSuchKind; });
  };
  const SensorPlace* fullest = nullptr;
  for (const SensorPlace& place : places)
    if (!fullest || bearings(place) >= bearings(*fullest)) fullest = &place;
  return fullest;
}

std::vector<int> landmarksOfKind(const LandmarkIndex& index, int kind)
{
  std::vector<int> landmarks;
  if (kind == kAnyKind) return landmarks;  // empty: any
  for (std::size_t l = 0; l < index.size(); ++l)
    if (index.kind(l) == kind) landmarks.push_back(static_cast<int>(l));
  return landmarks;
}

/// The pose of a sensor as the pose of its robot.
GaussianPose robotPose(const GaussianPose& sensor, const Pose2& T_robot_sensor)
{
  const Pose2 back = inverse(T_robot_sensor);
  const Matrix3d J = composeJacobianFirst(sensor.mean, back);
  return {compose(sensor.mean, back), J * sensor.covariance * J.transpose()};
}
}  // namespace

ReadingInterpretation interpretReadings(std::span<const Reading> readings, const LandmarkTable& map,
                                        const LostRobotSearch& search, const PoseRegion& region,
                                        std::uint64_t max_tree_nodes)
{
  std::vector<SensorPlace> places = joinedPlaces(readings, map, search.index());
  if (places.empty()) return {};
  // Where joining gave a constellation, what did not join it is mostly false, and would be counted again and again.
  const auto is_point = [](const UnidentifiedDetection& d) { return d.bearing && d.range; };
  const auto& joined = places.front().detections;
  if (areJoined(readings) && joined.size() >= kConstellation && std::all_of(joined.begin(), joined.end(), is_point))
    places.resize(1);
  PoseSearchOptions options;
  options.gate = kGate;
  options.area = MapArea{region.low, region.low + region.extent()};
  options.max_tree_nodes = max_tree_nodes;
  const PoseSearch found = search.search(places, options);

  ReadingInterpretation result{.status = found.status, .unique = found.unique, .finished = found.finished};
  for (const ConsistentPose& pose : found.poses)
    if (region.contains(pose.pose.mean))
      result.hypotheses.push_back(
          {.pose = pose.pose, .log_score = pose.log_evidence, .weight = pose.probability, .source = kSource});
  if (result.hypotheses.empty() && result.status == SolveStatus::ok) result.status = SolveStatus::none;
  return result;
}

HypothesisSet interpretThreeBearings(std::span<const Reading> readings, const LandmarkTable& map,
                                     const LostRobotSearch& search, const PoseRegion& region)
{
  const LandmarkIndex& index = search.index();
  const std::vector<SensorPlace> places = sensorPlaces(readings, map, index);
  const SensorPlace* place = fullestPlace(places);
  if (!place || index.size() > kLargestTreeMap) return {};
  std::vector<UnidentifiedBearing> bearings;
  double std = 0;
  for (const UnidentifiedDetection& d : place->detections)
  {
    if (!d.bearing || d.kind == kNoSuchKind) continue;
    bearings.push_back({*d.bearing, landmarksOfKind(index, d.kind)});
    std = std::max(std, d.std_bearing);
  }
  if (bearings.size() < 3 || bearings.size() > 4) return {};

  const double offset = place->T_robot_sensor.position().norm();
  InterpretationOptions options;
  options.gate = InterpretationGate::covariance;
  options.max_residual = kGate * std;
  options.std_bearing = std;
  options.allow_three = true;
  options.max_unmatched = static_cast<int>(bearings.size()) - 3;
  options.area = MapArea{region.low.array() - offset, region.low.array() + region.extent().array() + offset};
  if (place->model.max_range) options.max_range = kRangeMargin * *place->model.max_range;
  HypothesisSet hypotheses;
  for (const Interpretation& interpretation : interpretBearings(index.positions(), bearings, options).solutions)
  {
    PoseHypothesis h{.pose = robotPose(interpretation.pose, place->T_robot_sensor),
                     .log_score = interpretation.log_likelihood,
                     .source = kSource};
    if (region.contains(h.pose.mean)) hypotheses.push_back(std::move(h));
  }
  return hypotheses;
}
}  // namespace mrpt_ext
