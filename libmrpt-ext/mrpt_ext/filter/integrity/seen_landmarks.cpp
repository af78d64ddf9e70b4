#include "mrpt_ext/filter/integrity/seen_landmarks.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/reading_scorer.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMost = 100;  // as many as a null model tracks

std::vector<float> logLikelihoods(const Reading& part, const LandmarkTable& map, const Vector2d& origin,
                                  const PoseBatch& poses)
{
  std::vector<float> result(poses.size(), 0.0F);
  const LandmarkClutter clutter;
  ReadingScorer(part, map, clutter, origin).addTo(poses, result);
  return result;
}
}  // namespace

void SeenLandmarks::add(std::size_t landmark)
{
  std::erase(indices_, landmark);
  indices_.push_back(landmark);
  if (indices_.size() > kMost) indices_.erase(indices_.begin());
}

void SeenLandmarks::score(const Reading& part, const LandmarkTable& map, const Vector2d& origin, const PoseBatch& poses,
                          const FeatureMixture::Outcome& expected, std::span<float> log_likelihood) const
{
  const std::vector<float> of_any = logLikelihoods(part, map, origin, poses);
  std::vector<Landmark> seen;
  for (const std::size_t index : indices_)
    if (mayShow(part.detections.front(), map[index])) seen.push_back(map[index]);
  std::vector<float> of_seen = of_any;
  double in_view = 0;
  if (!seen.empty() && !of_any.empty())
  {
    const auto best = std::max_element(log_likelihood.begin(), log_likelihood.end()) - log_likelihood.begin();
    const Pose2 pose = poses[static_cast<std::size_t>(best)];
    for (const Landmark& landmark : seen) in_view += predict(landmark, part, pose).visibility;
    Reading same_volume = part;  // not that of a smaller map
    same_volume.model.max_range = part.model.max_range.value_or(defaultMaxRange(map));
    of_seen = logLikelihoods(same_volume, LandmarkTable(seen), origin, poses);
  }
  const double p_new = seen.empty() ? 1 : expected.share_new;
  const double p_seen = std::min(1 - p_new, expected.share_each * std::max(1.0, in_view));
  const double clutter = boundedClutter(part.model.clutter_probability) /
                         measurementVolume(part.detections.front(), part.model, defaultMaxRange(map));
  for (std::size_t i = 0; i < log_likelihood.size(); ++i)
    log_likelihood[i] += static_cast<float>(std::log(
        p_new * std::exp(double{of_any[i]}) + p_seen * std::exp(double{of_seen[i]}) + (1 - p_new - p_seen) * clutter));
}
}  // namespace mrpt_ext
