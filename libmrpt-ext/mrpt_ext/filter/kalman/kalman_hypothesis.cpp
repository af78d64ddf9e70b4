#include "mrpt_ext/filter/kalman/kalman_hypothesis.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/kalman/distinct_hypotheses.h"
#include "mrpt_ext/geometry/log_probability.h"
#include "mrpt_ext/geometry/mahalanobis.h"

namespace mrpt_ext
{
namespace
{
bool isSame(const KalmanHypothesis& a, const KalmanHypothesis& b)
{
  const GaussianPose p = a.state.gaussianPose(), q = b.state.gaussianPose();
  return mahalanobis2(p.mean, q.mean, p.covariance) < 1 && mahalanobis2(p.mean, q.mean, q.covariance) < 1;
}
}  // namespace

void update(KalmanHypothesis& hypothesis, const KalmanUpdate& result, const Frame& frame)
{
  hypothesis.state = result.state;
  hypothesis.log_weight += result.log_evidence;
  if (result.detections.empty()) return;
  double inliers = 0;
  for (const DetectionUse& use : result.detections) inliers += use.inlier_probability;
  const auto count = static_cast<double>(result.detections.size());
  double clutter = 0, sum = 0;
  for (const Reading& reading : frame.readings)
  {
    clutter += reading.model.clutter_probability * static_cast<double>(reading.detections.size());
    sum += static_cast<double>(reading.detections.size());
  }
  const double expected = sum > 0 ? 1 - clutter / sum : 1;
  hypothesis.fast_ratio.observe(inliers / count, expected, result.detections.size());
  hypothesis.slow_ratio.observe(inliers / count, expected, result.detections.size());
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
  keepDistinct(hypotheses, isSame,
               [](KalmanHypothesis& kept, const KalmanHypothesis& other)
               { kept.log_weight = logSum(kept.log_weight, other.log_weight); });
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
