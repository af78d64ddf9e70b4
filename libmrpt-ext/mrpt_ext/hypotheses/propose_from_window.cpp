#include "mrpt_ext/hypotheses/propose_from_window.h"

#include <algorithm>
#include <array>

#include "mrpt_ext/hypotheses/pose_proposals.h"
#include "mrpt_ext/hypotheses/window_readings.h"
#include "mrpt_ext/solvers/pose_ring.h"
#include "mrpt_ext/solvers/two_landmark_pose.h"

namespace mrpt_ext
{
namespace
{
constexpr double kOutlierGate = 4;      // standard deviations
constexpr std::size_t kMaxPairs = 200;  // of landmarks, evenly sampled

/// A landmark of the map and its candidate positions in the robot frame.
struct Located
{
  Vector2d landmark{0, 0};
  std::vector<LocalizedLandmark> candidates;
};

std::vector<Located> locateAll(std::span<const Reading> oldest_first, const LandmarkTable& map)
{
  std::vector<Located> result;
  for (const auto& [landmark, observations] : windowObservations(oldest_first, map))
    if (WindowLandmark found = locateLandmark(observations); found.status == SolveStatus::ok)
      result.push_back({map[landmark].position.head<2>(), std::move(found.candidates)});
  return result;
}

void addPair(const Located& a, const Located& b, HypothesisSet& result)
{
  for (const LocalizedLandmark& at_a : a.candidates)
    for (const LocalizedLandmark& at_b : b.candidates)
    {
      const std::array seen{SeenLandmark{a.landmark, at_a.in_robot}, SeenLandmark{b.landmark, at_b.in_robot}};
      const PointPose fit = solvePointPose(seen);
      if (fit.status == SolveStatus::ok && fit.chi2 <= square(kOutlierGate))
        result.push_back({.pose = fit.pose, .source = "window_landmarks"});
    }
}

/// The measurements within the gate at `pose`.
std::vector<WindowMeasurements> inliers(std::vector<WindowMeasurements> readings, const Pose2& pose)
{
  for (WindowMeasurements& reading : readings)
    std::erase_if(reading.measurements,
                  [&](const PoseMeasurement& m)
                  {
                    const JacobianRow row = jacobian(m, pose) * composeJacobianSecond(pose);
                    const double variance = square(m.std) + row * reading.odometry_covariance * row.transpose();
                    return square(residual(m, pose)) > square(kOutlierGate) * variance;
                  });
  return readings;
}
}  // namespace

HypothesisSet proposeFromWindowLandmarks(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                         const std::optional<CompassRecord>& compass, std::size_t points)
{
  const std::vector<Located> located = locateAll(oldest_first, map);
  HypothesisSet result;
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < located.size(); ++i)
    for (std::size_t j = i + 1; j < located.size(); ++j) pairs.push_back({i, j});
  const std::size_t tried = std::min(pairs.size(), kMaxPairs);
  for (std::size_t k = 0; k < tried; ++k)
  {
    const auto& [i, j] = pairs[k * pairs.size() / tried];
    addPair(located[i], located[j], result);
  }
  if (!result.empty() || located.empty()) return result;
  const auto area = [](const Located& l) { return l.candidates.front().in_robot.covariance.trace(); };
  const Located& most_precise = *std::min_element(
      located.begin(), located.end(), [&](const Located& a, const Located& b) { return area(a) < area(b); });
  for (const LocalizedLandmark& candidate : most_precise.candidates)
    for (const HeadingPrior& heading : headingsToTry(compass, points))
      result.push_back(
          {.pose = gaussianOnRing({most_precise.landmark, candidate.in_robot}, heading.heading, heading.std_heading),
           .source = "window_ring"});
  return result;
}

std::optional<GaussianPose> refineOnWindow(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                           const Pose2& start)
{
  const std::vector<WindowMeasurements> all = windowMeasurements(oldest_first, map);
  const PoseMl first = refineWindowPose(inliers(all, start), start);
  if (first.status != SolveStatus::ok || !first.converged) return std::nullopt;
  // Once more with the inliers of the better pose.
  const PoseMl fit = refineWindowPose(inliers(all, first.pose.mean), first.pose.mean);
  if (fit.status != SolveStatus::ok || !fit.converged) return std::nullopt;
  return fit.pose;
}
}  // namespace mrpt_ext
