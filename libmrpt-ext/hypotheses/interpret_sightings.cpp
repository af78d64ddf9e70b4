#include "mrpt_ext/hypotheses/interpret_sightings.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
constexpr double kGate = 3.3;                 // standard deviations
constexpr std::size_t kMaxBearings = 10;      // more only cost time: the likelihood of the frame judges the rest
constexpr std::uint64_t kMaxTested = 100000;  // clusters of look-alike landmarks would take for ever

std::vector<int> candidatesFor(const LandmarkSighting& sighting, const LandmarkTable& map)
{
  std::vector<int> candidates;
  if (sighting.category.empty()) return candidates;
  for (std::size_t j = 0; j < map.size(); ++j)
    if (map[j].category == sighting.category) candidates.push_back(static_cast<int>(j));
  return candidates;
}

/// The bearings of the sensor place that has most of them, of several the newest; evenly thinned to what the search
/// takes.
std::vector<LandmarkSighting> bearingsOfOnePlace(std::span<const LandmarkSighting> sightings)
{
  std::vector<std::vector<LandmarkSighting>> places;
  for (const LandmarkSighting& s : sightings)
  {
    if (!s.bearing) continue;
    const bool same = !places.empty() && places.back().front().T_robot_sensor.vector() == s.T_robot_sensor.vector();
    if (!same) places.emplace_back();
    places.back().push_back(s);
  }
  std::vector<LandmarkSighting> most;
  for (std::vector<LandmarkSighting>& place : places)
    if (place.size() >= most.size()) most = std::move(place);
  if (most.size() <= kMaxBearings) return most;
  std::vector<LandmarkSighting> thinned;
  for (std::size_t k = 0; k < kMaxBearings; ++k) thinned.push_back(most[k * most.size() / kMaxBearings]);
  return thinned;
}
}  // namespace

SightingInterpretations interpretSightings(std::span<const LandmarkSighting> sightings, const LandmarkTable& map,
                                           const PoseRegion& region, bool allow_three)
{
  SightingInterpretations result;
  const std::vector<LandmarkSighting> bearings = bearingsOfOnePlace(sightings);
  if (bearings.empty()) return result;
  std::vector<UnidentifiedBearing> unidentified;
  double std = 0;
  for (const LandmarkSighting& s : bearings)
  {
    unidentified.push_back({*s.bearing, candidatesFor(s, map)});
    // A category that no landmark has can only be clutter; an empty list would mean "any".
    if (!s.category.empty() && unidentified.back().candidates.empty()) unidentified.pop_back();
    std = std::max(std, s.std_bearing);
  }
  const auto count = static_cast<int>(unidentified.size());
  if (count < (allow_three ? 3 : 4)) return result;

  std::vector<Vector2d> landmarks;
  for (const Landmark& landmark : map.all()) landmarks.push_back(landmark.position.head<2>());
  const Pose2& T_robot_sensor = bearings.front().T_robot_sensor;
  const double offset = T_robot_sensor.position().norm();
  InterpretationOptions options;
  options.gate = InterpretationGate::covariance;
  options.max_residual = kGate * std;
  options.std_bearing = std;
  // Seeding: of four or five bearings one may be false, and the three or four others still name the place.
  options.allow_three = allow_three && count <= 4;
  options.max_unmatched = std::clamp(std::min((count + 1) / 3, count - (options.allow_three ? 3 : 4)), 0, 2);
  options.area = MapArea{region.low.array() - offset, region.high.array() + offset};
  options.max_tested = kMaxTested;
  const Interpretations found = interpretBearings(landmarks, unidentified, options);
  result.status = found.status;
  for (const Interpretation& interpretation : found.solutions)
  {
    PoseHypothesis h{
        .pose = interpretation.pose, .log_score = interpretation.log_likelihood, .source = "interpretation_tree"};
    const Pose2 back = inverse(T_robot_sensor);
    const Matrix3d J = composeJacobianFirst(interpretation.pose.mean, back);
    h.pose = {compose(interpretation.pose.mean, back), J * interpretation.pose.covariance * J.transpose()};
    if (region.contains(h.pose.mean)) result.hypotheses.push_back(std::move(h));
  }
  if (result.hypotheses.empty() && result.status == SolveStatus::ok) result.status = SolveStatus::none;
  return result;
}
}  // namespace mrpt_ext
