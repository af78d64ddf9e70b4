#include "mrpt_ext/likelihood/missed_scorer.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/vector_math.h"
#include "mrpt_ext/likelihood/missed_detections.h"

namespace mrpt_ext
{
namespace
{
/// log_sum += ln of the mixture of the count's Gaussian and a uniform share.
MRPT_EXT_VECTOR_CLONES
void addLogOfCount(const SensorTile::Column& mean, const SensorTile::Column& variance, float count, float uniform,
                   float gaussian_share, SensorTile::Column& log_sum)
{
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < SensorTile::kSize; ++i)
  {
    const float error = count - mean[i], inverse = 1.0F / variance[i];
    const float gaussian = 0.398942280F * std::sqrt(inverse) * vector_math::expOf(-0.5F * error * error * inverse);
    log_sum[i] += vector_math::logOf(gaussian_share * gaussian + uniform);
  }
}
}  // namespace

MissedScorer::MissedScorer(const Reading& reading, const LandmarkTable& map, const ScoringFrame& frame)
    : reading_(reading),
      map_(map),
      frame_(frame),
      limits_(reading.model),
      identified_(areIdentified(reading)),
      reported_(map.size(), 0)
{
  for (const Detection& detection : reading.detections)
    if (const auto known = map.indexOf(detection.id)) reported_[*known] = 1;
}

void MissedScorer::prepare(const LandmarkCulling& culling, Terms& terms) const
{
  const double detected = *reading_.model.detection_probability;
  terms.rim.clear();
  terms.log_sum = terms.mean = terms.variance = 0;
  for (std::size_t j = 0; j < map_.size(); ++j)
  {
    if (identified_ && map_[j].id == kNoId && !reading_.detections.empty()) continue;
    const InView in_view = culling.inView()[j];
    const bool reported = reported_[j] != 0;
    if (in_view == InView::some)
    {
      ViewedLandmark landmark = viewedLandmark(map_[j], frame_);
      landmark.base = static_cast<float>(reportProbability(0, reported));
      landmark.gain = static_cast<float>(reportProbability(detected, reported)) - landmark.base;
      terms.rim.push_back(landmark);
      continue;
    }
    const double p = in_view == InView::all ? detected : 0.0;
    terms.log_sum += identified_ ? std::log(reportProbability(p, reported)) : 0.0;
    terms.mean += p;
    terms.variance += p * (1 - p);
  }
}

void MissedScorer::addTo(const SensorTile& tile, const Terms& terms, SensorTile::Column& log_sum) const
{
  if (identified_)
  {
    for (float& value : log_sum) value += static_cast<float>(terms.log_sum);
    return addLogReports(tile, terms.rim, limits_, log_sum);
  }
  const CountModel model = countModel(reading_, map_.size());
  alignas(64) SensorTile::Column mean, variance;
  std::fill_n(mean, SensorTile::kSize, static_cast<float>(terms.mean + model.expected_clutter));
  std::fill_n(variance, SensorTile::kSize, static_cast<float>(terms.variance + model.extra_variance));
  addCountMoments(tile, terms.rim, limits_, static_cast<float>(*reading_.model.detection_probability), mean, variance);
  addLogOfCount(mean, variance, static_cast<float>(model.count), static_cast<float>(model.uniform),
                static_cast<float>(model.gaussian_share), log_sum);
}
}  // namespace mrpt_ext
