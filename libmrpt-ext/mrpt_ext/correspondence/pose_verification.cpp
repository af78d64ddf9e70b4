#include "mrpt_ext/correspondence/pose_verification.h"

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/correspondence/scan_matching.h"
#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext
{
namespace
{
constexpr int kMaxRounds = 6;              // of matching and refining; most poses refine in two
constexpr std::uint64_t kWorkOfRow = 150;  // operations, in a fit

/// The detections that a pose matches.
struct Matching
{
  std::vector<int> assignment;  // landmark per detection, all scans in order
  int matched = 0;
};

/// The fixed arguments of a verification, and its work.
struct Verification
{
  const LandmarkIndex& map;
  std::span<const Scan> scans;
  double gate;
  int least;
  WorkBudget* budget;

  /// False when there is no work left.
  [[nodiscard]] bool spend(std::uint64_t operations) const { return budget == nullptr || budget->spend(operations); }
};

std::vector<ExpectedLandmark> expectedFrom(const Verification& with, const Scan& scan, const GaussianPose& pose)
{
  std::vector<ExpectedLandmark> expected = expectedLandmarks(with.map, scan, pose);
  static_cast<void>(with.spend(costOfMatching(expected.size(), scan.detections.size())));
  return expected;
}

/// Without a pose when there is no work left for the fit.
PoseMl refined(const Verification& with, std::span<const PoseMeasurement> rows, const Pose2& start)
{
  return with.spend(kWorkOfRow * rows.size()) ? refinePose(rows, start) : PoseMl{};
}

Matching match(const Verification& with, const GaussianPose& pose)
{
  Matching result;
  for (const Scan& scan : with.scans)
  {
    const std::vector<ExpectedLandmark> expected = expectedFrom(with, scan, pose);
    for (const int h : associate(with.map, scan, expected, with.gate))
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

MatchedRows measurementsOf(const Verification& with, const std::vector<int>& assignment)
{
  MatchedRows result;
  std::size_t d = 0;
  for (const Scan& scan : with.scans)
    for (const AnonymousDetection& z : scan.detections)
    {
      const std::size_t detection = d++;
      if (assignment[detection] < 0) continue;
      const Vector2d& position = with.map.position(static_cast<std::size_t>(assignment[detection]));
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
bool refine(const Verification& with, GaussianPose& pose, Matching& matching)
{
  matching = match(with, pose);
  for (int round = 0; round < kMaxRounds; ++round)
  {
    if (matching.matched < with.least) return false;
    const PoseMl fit = refined(with, measurementsOf(with, matching.assignment).rows, pose.mean);
    if (fit.status != SolveStatus::ok) return false;
    pose = fit.pose;
    Matching next = match(with, pose);
    const bool unchanged = next.assignment == matching.assignment;
    matching = std::move(next);
    if (unchanged) break;
  }
  return matching.matched >= with.least;
}

/// Drops the worst match while its residual exceeds the gate of a single detection: while the pose was uncertain, a
/// wrong landmark could pass. Detections that the pose was drawn away from can then match again.
bool dropMisfits(const Verification& with, GaussianPose& pose, std::vector<int>& assignment)
{
  for (auto matched = std::count_if(assignment.begin(), assignment.end(), [](int l) { return l >= 0; });
       matched >= with.least; --matched)
  {
    const MatchedRows matches = measurementsOf(with, assignment);
    const PoseMl fit = refined(with, matches.rows, pose.mean);
    if (fit.status != SolveStatus::ok) return false;
    pose = fit.pose;
    const auto misfit = [&](std::size_t row) { return std::abs(fit.residuals[row]) / matches.rows[row].std; };
    std::size_t worst = 0;
    for (std::size_t row = 1; row < matches.rows.size(); ++row)
      if (misfit(row) > misfit(worst)) worst = row;
    if (misfit(worst) <= with.gate) return true;
    assignment[matches.detection[worst]] = -1;
  }
  return false;
}

/// log_likelihood and log_evidence of a pose with its assignment.
bool score(const Verification& with, ConsistentPose& pose)
{
  std::size_t d = 0;
  for (const Scan& scan : with.scans)
  {
    const std::vector<ExpectedLandmark> expected = expectedFrom(with, scan, pose.pose);
    std::vector<int> matches;
    for (std::size_t n = 0; n < scan.detections.size(); ++n)
    {
      const int landmark = pose.assignment[d++];
      const auto at = std::find_if(expected.begin(), expected.end(),
                                   [&](const auto& h) { return static_cast<int>(h.landmark) == landmark; });
      matches.push_back(at == expected.end() ? -1 : static_cast<int>(at - expected.begin()));
    }
    pose.log_likelihood += scanLogLikelihood(with.map, scan, expected, matches);
  }
  const double determinant = pose.pose.covariance.determinant();
  if (!(determinant > 0)) return false;
  pose.log_evidence = pose.log_likelihood + 0.5 * (3 * std::log(kTwoPi) + std::log(determinant));
  return true;
}
}  // namespace

std::optional<ConsistentPose> verifyPose(const LandmarkIndex& map, std::span<const Scan> scans,
                                         const PoseSearchOptions& options, const GaussianPose& candidate, int least)
{
  const Verification with{map, scans, options.gate, least, options.budget};
  ConsistentPose result{.pose = candidate};
  Matching matching;
  if (!refine(with, result.pose, matching)) return std::nullopt;
  // What a dropped misfit had bent away may fit now: refine once more from the better pose.
  if (!dropMisfits(with, result.pose, matching.assignment)) return std::nullopt;
  if (!refine(with, result.pose, matching)) return std::nullopt;
  if (!dropMisfits(with, result.pose, matching.assignment)) return std::nullopt;
  if (options.area && !options.area->contains(result.pose.mean.position())) return std::nullopt;
  result.assignment = std::move(matching.assignment);
  result.matched = static_cast<int>(
      std::count_if(result.assignment.begin(), result.assignment.end(), [](int landmark) { return landmark >= 0; }));
  if (!score(with, result)) return std::nullopt;
  return result;
}
}  // namespace mrpt_ext
