#include "mrpt_ext/correspondence/pose_judge.h"

#include <Eigen/LU>

#include "mrpt_ext/correspondence/place_view.h"
#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext
{
namespace
{
constexpr int kMaxRounds = 6;  // of matching and refining; most poses settle in two

/// What the places see from one pose, and what matches it.
struct Matching
{
  std::vector<std::vector<ExpectedLandmark>> expected;  // per place
  std::vector<std::vector<int>> matches;                // per place and detection, into `expected`
  std::vector<int> assignment;                          // landmark per detection, all places in order
  int matched = 0;
};

Matching match(const LandmarkIndex& map, std::span<const SensorPlace> places, const GaussianPose& pose, double gate)
{
  Matching result;
  for (const SensorPlace& place : places)
  {
    const auto& expected = result.expected.emplace_back(expectedLandmarks(map, place, pose));
    for (const int h : result.matches.emplace_back(matchDetections(map, place, expected, gate)))
    {
      result.assignment.push_back(h < 0 ? -1 : static_cast<int>(expected[static_cast<std::size_t>(h)].landmark));
      result.matched += h >= 0;
    }
  }
  return result;
}

std::vector<PoseMeasurement> measurementsOf(const LandmarkIndex& map, std::span<const SensorPlace> places,
                                            const std::vector<int>& assignment)
{
  std::vector<PoseMeasurement> rows;
  std::size_t d = 0;
  for (const SensorPlace& place : places)
    for (const UnidentifiedDetection& z : place.detections)
    {
      const int landmark = assignment[d++];
      if (landmark < 0) continue;
      const Vector2d& position = map.position(static_cast<std::size_t>(landmark));
      if (z.bearing)
        rows.push_back({PoseMeasurement::Kind::bearing, position, *z.bearing, z.std_bearing, place.T_robot_sensor});
      if (z.range)
        rows.push_back({PoseMeasurement::Kind::range, position, *z.range, z.std_range, place.T_robot_sensor});
    }
  return rows;
}
}  // namespace

std::optional<ConsistentPose> judgePose(const LandmarkIndex& map, std::span<const SensorPlace> places,
                                        const PoseSearchOptions& options, const GaussianPose& candidate, int least)
{
  ConsistentPose result{.pose = candidate};
  Matching matching = match(map, places, result.pose, options.gate);
  for (int round = 0; round < kMaxRounds; ++round)
  {
    if (matching.matched < least) return std::nullopt;
    const std::vector<PoseMeasurement> rows = measurementsOf(map, places, matching.assignment);
    const PoseMl fit = refinePose(rows, result.pose.mean);
    if (fit.status != SolveStatus::ok) return std::nullopt;
    result.pose = fit.pose;
    Matching next = match(map, places, result.pose, options.gate);
    const bool settled = next.assignment == matching.assignment;
    matching = std::move(next);
    if (settled) break;
  }
  if (matching.matched < least) return std::nullopt;
  if (options.area && !options.area->contains(result.pose.mean.position())) return std::nullopt;

  result.matched = matching.matched;
  result.assignment = std::move(matching.assignment);
  for (std::size_t p = 0; p < places.size(); ++p)
    result.log_likelihood += placeLogLikelihood(map, places[p], matching.expected[p], matching.matches[p]);
  const double determinant = result.pose.covariance.determinant();
  if (!(determinant > 0)) return std::nullopt;
  result.log_evidence = result.log_likelihood + 0.5 * (3 * std::log(kTwoPi) + std::log(determinant));
  return result;
}
}  // namespace mrpt_ext
