#include "mrpt_ext/filter/integrity/seen_landmarks.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/reading_scorer.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMost = 40;  // those seen last, as many as the null models track

std::vector<float> logLikelihoods(const Reading& part, const LandmarkTable& map, const Vector2d& origin,
                                  const PoseBatch& poses)
{
  std::vector<float> result(poses.size(), 0.0F);
  const LandmarkClutter clutter;
  ReadingScorer(part, map, clutter, origin).addTo(poses, result);
  return result;
}

/// Expected number of the landmarks that the sensor has in view at the likeliest of the poses.
double numberInView(const LandmarkTable& landmarks, const Reading& reading, const PoseBatch& poses,
                    std::span<const float> log_likelihood)
{
  const auto best = std::max_element(log_likelihood.begin(), log_likelihood.end()) - log_likelihood.begin();
  const Pose2 pose = poses[static_cast<std::size_t>(best)];
  double number = 0;
  for (std::size_t k = 0; k < landmarks.size(); ++k) number += predict(landmarks[k], reading, pose).visibility;
  return number;
}
}  // namespace

void SeenLandmarks::add(std::size_t landmark)
{
  std::erase(indices_, landmark);
  indices_.push_back(landmark);
  if (indices_.size() > kMost) indices_.erase(indices_.begin());
}

LandmarkTable SeenLandmarks::seenOf(const Detection& detection, const LandmarkTable& map) const
{
  std::vector<Landmark> seen;
  for (const std::size_t index : indices_)
    if (mayShow(detection, map[index])) seen.push_back(map[index]);
  return LandmarkTable(seen);
}

LandmarkTable SeenLandmarks::unseen(const LandmarkTable& map) const
{
  std::vector<bool> is_seen(map.size(), false);
  for (const std::size_t index : indices_) is_seen[index] = true;
  std::vector<Landmark> rest;
  for (std::size_t k = 0; k < map.size(); ++k)
    if (!is_seen[k]) rest.push_back(map[k]);
  return LandmarkTable(rest);
}

void SeenLandmarks::score(const Reading& part, const LandmarkTable& map, const Vector2d& origin, const PoseBatch& poses,
                          const FeatureMixture::Outcome& expected, std::span<float> log_likelihood) const
{
  if (poses.size() == 0) return;
  const Detection& detection = part.detections.front();
  Reading same_volume = part;  // not that of a smaller map
  same_volume.model.max_range = part.model.max_range.value_or(defaultMaxRange(map));
  // A bearing that the null model recognizes shows no landmark for the first time. The same holds for detections with a
  // range, but there this left two thirds of the right poses among barriers unverified and rejected no wrong one more.
  const bool is_known = expected.isKnown() && !detection.range && !indices_.empty();
  const std::vector<float> of_new = logLikelihoods(same_volume, is_known ? unseen(map) : map, origin, poses);
  const LandmarkTable seen = seenOf(detection, map);
  const std::vector<float> of_seen = logLikelihoods(same_volume, seen, origin, poses);
  const double p_new = seen.empty() ? 1 : expected.share_new;
  double p_seen = 1 - p_new;
  // Of bearings the null model has several features of one landmark after a while, of which odometry has lost all but
  // one: the share of a landmark is not that of a feature.
  if (detection.range && !seen.empty())
    p_seen = std::min(p_seen, expected.share_each * std::max(1.0, numberInView(seen, part, poses, log_likelihood)));
  const double clutter =
      boundedClutter(part.model.clutter_probability) / measurementVolume(detection, part.model, defaultMaxRange(map));
  for (std::size_t i = 0; i < log_likelihood.size(); ++i)
    log_likelihood[i] += static_cast<float>(std::log(
        p_new * std::exp(double{of_new[i]}) + p_seen * std::exp(double{of_seen[i]}) + (1 - p_new - p_seen) * clutter));
}
}  // namespace mrpt_ext
