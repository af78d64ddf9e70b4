#include "mrpt_ext/filter/kalman/kalman_hypothesis.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
bool liesWithin(const Vector3d& difference, const Matrix3d& covariance)
{
  return difference.dot(covariance.llt().solve(difference)) < 1;
}

bool samePlace(const KalmanHypothesis& a, const KalmanHypothesis& b)
{
  Vector3d difference = a.state.mean.head<3>() - b.state.mean.head<3>();
  difference.z() = wrap(difference.z());
  return liesWithin(difference, a.state.gaussianPose().covariance) &&
         liesWithin(difference, b.state.gaussianPose().covariance);
}
}  // namespace

void update(KalmanHypothesis& hypothesis, const KalmanUpdate& result, const Frame& frame)
{
  hypothesis.state = result.state;
  hypothesis.log_weight += result.log_evidence;
  if (result.detections.empty()) return;
  double explained = 0;
  for (const DetectionUse& use : result.detections) explained += use.explained;
  const auto count = static_cast<double>(result.detections.size());
  double clutter = 0, sensors = 0;
  for (const Reading& reading : frame.readings)
  {
    clutter += reading.model.clutter_probability * static_cast<double>(reading.detections.size());
    sensors += static_cast<double>(reading.detections.size());
  }
  const double expected = sensors > 0 ? 1 - clutter / sensors : 1;
  hypothesis.quick.observe(explained / count, expected, result.detections.size());
  hypothesis.trust.observe(explained / count, expected, result.detections.size());
  hypothesis.detections += result.detections.size();
}

void rank(KalmanHypotheses& hypotheses)
{
  if (hypotheses.empty()) return;
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [](const auto& a, const auto& b) { return a.log_weight > b.log_weight; });
  const double best = hypotheses.front().log_weight;
  double sum = 0;
  for (const KalmanHypothesis& h : hypotheses) sum += std::exp(h.log_weight - best);
  for (KalmanHypothesis& h : hypotheses) h.log_weight -= best + std::log(sum);
}

void merge(KalmanHypotheses& hypotheses)
{
  KalmanHypotheses kept;
  for (KalmanHypothesis& candidate : hypotheses)
  {
    const auto twin =
        std::find_if(kept.begin(), kept.end(), [&](const auto& other) { return samePlace(other, candidate); });
    if (twin == kept.end())
      kept.push_back(std::move(candidate));
    else
      twin->log_weight += std::log1p(std::exp(candidate.log_weight - twin->log_weight));
  }
  hypotheses = std::move(kept);
  rank(hypotheses);
}

void prune(KalmanHypotheses& hypotheses, std::size_t count, double min_weight)
{
  std::erase_if(hypotheses, [&](const auto& h) { return h.log_weight < std::log(min_weight); });
  if (hypotheses.size() > count)
    hypotheses.erase(hypotheses.begin() + static_cast<std::ptrdiff_t>(count), hypotheses.end());
  rank(hypotheses);
}

ModeSet modesOf(const KalmanHypotheses& hypotheses)
{
  ModeSet modes;
  for (const KalmanHypothesis& h : hypotheses) modes.modes.push_back({h.state.gaussianPose(), std::exp(h.log_weight)});
  return modes;
}
}  // namespace mrpt_ext
