#include "mrpt_ext/correspondence/pose_verification.h"

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/correspondence/scan_matching.h"
#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext
{
namespace
{
constexpr int kMaxRounds = 6;  // of matching and refining; most poses refine in two

/// The detections that a pose matches.
struct Matching
{
  std::vector<int> assignment;  // landmark per detection, all scans in order
  int matched = 0;
};

Matching match(const LandmarkIndex& map, std::span<const Scan> scans, const GaussianPose& pose, double gate)
{
  Matching result;
  for (const Scan& scan : scans)
  {
    const std::vector<ExpectedLandmark> expected = expectedLandmarks(map, scan, pose);
    for (const int h : associate(map, scan, expected, gate))
    {
      result.assignment.push_back(h < 0 ? -1 : static_cast<int>(expected[static_cast<std::size_t>(h)].landmark));
      result.matched += h >= 0;
    }
  }
  return result;
}

struct MatchedRows
{
  std::vector<PoseMeasurement> rows;
  std::vector<std::size_t> detection;  // of each row, counted over all scans
};

MatchedRows measurementsOf(const LandmarkIndex& map, std::span<const Scan> scans, const std::vector<int>& assignment)
{
  MatchedRows result;
  std::size_t d = 0;
  for (const Scan& scan : scans)
    for (const AnonymousDetection& z : scan.detections)
    {
      const std::size_t detection = d++;
      if (assignment[detection] < 0) continue;
      const Vector2d& position = map.position(static_cast<std::size_t>(assignment[detection]));
      const auto add = [&](PoseMeasurement::Kind kind, double value, double std)
      {
        result.rows.push_back({kind, position, value, std, scan.T_robot_sensor});
        result.detection.push_back(detection);
      };
      if (z.bearing) add(PoseMeasurement::Kind::bearing, *z.bearing, z.std_bearing);
      if (z.range) add(PoseMeasurement::Kind::range, *z.range, z.std_range);
    }
  return result;
}

/// Associates and refines in turn until the association stays. False when fewer than `least` detections match or
/// the pose is degenerate.
bool refine(const LandmarkIndex& map, std::span<const Scan> scans, double gate, int least, GaussianPose& pose,
            Matching& matching)
{
  matching = match(map, scans, pose, gate);
  for (int round = 0; round < kMaxRounds; ++round)
  {
    if (matching.matched < least) return false;
    const PoseMl fit = refinePose(measurementsOf(map, scans, matching.assignment).rows, pose.mean);
    if (fit.status != SolveStatus::ok) return false;
    pose = fit.pose;
    Matching next = match(map, scans, pose, gate);
    const bool unchanged = next.assignment == matching.assignment;
    matching = std::move(next);
    if (unchanged) break;
  }
  return matching.matched >= least;
}

/// Drops the worst match while its residual exceeds the gate of a single detection: while the pose was uncertain, a
/// wrong landmark could pass. Detections that the pose was drawn away from can then match again.
bool dropMisfits(const LandmarkIndex& map, std::span<const Scan> scans, double gate, int least, GaussianPose& pose,
                 std::vector<int>& assignment)
{
  for (auto matched = std::count_if(assignment.begin(), assignment.end(), [](int l) { return l >= 0; });
       matched >= least; --matched)
  {
    const MatchedRows matches = measurementsOf(map, scans, assignment);
    const PoseMl fit = refinePose(matches.rows, pose.mean);
    if (fit.status != SolveStatus::ok) return false;
    pose = fit.pose;
    const auto misfit = [&](std::size_t row) { return std::abs(fit.residuals[row]) / matches.rows[row].std; };
    std::size_t worst = 0;
    for (std::size_t row = 1; row < matches.rows.size(); ++row)
      if (misfit(row) > misfit(worst)) worst = row;
    if (misfit(worst) <= gate) return true;
    assignment[matches.detection[worst]] = -1;
  }
  return false;
}

/// log_likelihood and log_evidence of a pose with its assignment.
bool score(const LandmarkIndex& map, std::span<const Scan> scans, ConsistentPose& pose)
{
  std::size_t d = 0;
  for (const Scan& scan : scans)
  {
    const std::vector<ExpectedLandmark> expected = expectedLandmarks(map, scan, pose.pose);
    std::vector<int> matches;
    for (std::size_t n = 0; n < scan.detections.size(); ++n)
    {
      const int landmark = pose.assignment[d++];
      const auto at = std::find_if(expected.begin(), expected.end(),
                                   [&](const auto& h) { return static_cast<int>(h.landmark) == landmark; });
      matches.push_back(at == expected.end() ? -1 : static_cast<int>(at - expected.begin()));
    }
    pose.log_likelihood += scanLogLikelihood(map, scan, expected, matches);
  }
  const double determinant = pose.pose.covariance.determinant();
  if (!(determinant > 0)) return false;
  pose.log_evidence = pose.log_likelihood + 0.5 * (3 * std::log(kTwoPi) + std::log(determinant));
  return true;
}
}  // namespace

std::uint64_t costOfVerification(const LandmarkIndex& map, std::span<const Scan> scans)
{
  constexpr std::uint64_t kMatchings = 4, kOfFit = 1000, kOfFits = 5000;
  std::uint64_t cost = kOfFits;
  for (const Scan& scan : scans) cost += kMatchings * costOfMatching(map, scan) + kOfFit * scan.detections.size();
  return cost;
}

std::optional<ConsistentPose> verifyPose(const LandmarkIndex& map, std::span<const Scan> scans,
                                         const PoseSearchOptions& options, const GaussianPose& candidate, int least)
{
  ConsistentPose result{.pose = candidate};
  Matching matching;
  if (!refine(map, scans, options.gate, least, result.pose, matching)) return std::nullopt;
  // What a dropped misfit had bent away may fit now: refine once more from the better pose.
  if (!dropMisfits(map, scans, options.gate, least, result.pose, matching.assignment)) return std::nullopt;
  if (!refine(map, scans, options.gate, least, result.pose, matching)) return std::nullopt;
  if (!dropMisfits(map, scans, options.gate, least, result.pose, matching.assignment)) return std::nullopt;
  if (options.area && !options.area->contains(result.pose.mean.position())) return std::nullopt;
  result.assignment = std::move(matching.assignment);
  result.matched = static_cast<int>(
      std::count_if(result.assignment.begin(), result.assignment.end(), [](int landmark) { return landmark >= 0; }));
  if (!score(map, scans, result)) return std::nullopt;
  return result;
}
}  // namespace mrpt_ext
