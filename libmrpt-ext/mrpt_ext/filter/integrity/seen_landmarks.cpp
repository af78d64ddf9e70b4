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

void SeenLandmarks::count(std::optional<std::size_t> landmark)
{
  if (!landmark) return;
  count_ += 1;
  if (std::find(indices_.begin(), indices_.end(), *landmark) == indices_.end()) new_ += 1;
  add(*landmark);
}

void SeenLandmarks::score(const Reading& part, const LandmarkTable& map, const Vector2d& origin, const PoseBatch& poses,
                          std::span<float> log_likelihood) const
{
  const std::vector<float> of_any = logLikelihoods(part, map, origin, poses);
  std::vector<float> of_seen = of_any;
  if (!indices_.empty())
  {
    std::vector<Landmark> landmarks;
    for (const std::size_t index : indices_) landmarks.push_back(map[index]);
    Reading same_volume = part;  // not that of a smaller map
    same_volume.model.max_range = part.model.max_range.value_or(defaultMaxRange(map));
    of_seen = logLikelihoods(same_volume, LandmarkTable(std::move(landmarks)), origin, poses);
  }
  const auto p_new = static_cast<float>((new_ + 1) / (count_ + 2));
  for (std::size_t i = 0; i < log_likelihood.size(); ++i)
    log_likelihood[i] += std::log(p_new * std::exp(of_any[i]) + (1 - p_new) * std::exp(of_seen[i]));
}
}  // namespace mrpt_ext
