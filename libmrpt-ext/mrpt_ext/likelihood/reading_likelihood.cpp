#include "mrpt_ext/likelihood/reading_likelihood.h"

#include <algorithm>

#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/facing_likelihood.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"
#include "mrpt_ext/likelihood/missed_detections.h"
#include "mrpt_ext/likelihood/reading_scorer.h"

namespace mrpt_ext
{
namespace
{
/// All that does not depend on the pose, prepared once per reading.
struct PreparedReading
{
  const Reading& reading;
  const LandmarkTable& map;
  const LandmarkClutter& clutter;
  bool score_missed = false;
  std::vector<std::size_t> relevant;                 // landmarks that need a prediction
  std::vector<std::vector<std::size_t>> candidates;  // per detection: positions in `relevant`
  std::vector<double> clutter_density;               // per detection: 1 / V

  PreparedReading(const Reading& r, const LandmarkTable& m, const LandmarkClutter& c)
      : reading(r), map(m), clutter(c), score_missed(scoresMissedDetections(r))
  {
    const double default_max_range = defaultMaxRange(map);
    std::vector<std::size_t> index(map.size(), map.size());
    const auto index_of = [&](std::size_t landmark)
    {
      if (index[landmark] == map.size())
      {
        index[landmark] = relevant.size();
        relevant.push_back(landmark);
      }
      return index[landmark];
    };
    if (score_missed)
      for (std::size_t j = 0; j < map.size(); ++j) index_of(j);
    for (const Detection& detection : reading.detections)
    {
      clutter_density.push_back(1 / measurementVolume(detection, reading.model, default_max_range));
      auto& list = candidates.emplace_back();
      if (detection.id != kNoId)
      {
        if (const auto known = map.indexOf(detection.id)) list.push_back(index_of(*known));
        continue;
      }
      for (std::size_t j = 0; j < map.size(); ++j)
        if (mayShow(detection, map[j])) list.push_back(index_of(j));
    }
  }
};

/// The terms of p(z) = sum_j term_j + clutter_term for one detection and one pose.
struct MixtureTerms
{
  double clutter = 0;
  double total = 0;
};

constexpr double kFar = 12;  // standard deviations: a density below e^-72 of its peak, which need not be computed

/// Fills terms[i] for candidate i of detection d.
MixtureTerms mixture(const PreparedReading& prepared, std::size_t d, const std::vector<LandmarkPrediction>& predictions,
                     std::vector<double>& terms)
{
  const Detection& detection = prepared.reading.detections[d];
  const auto& candidates = prepared.candidates[d];
  const bool identified = detection.id != kNoId;
  double visibility_sum = 0;
  for (const std::size_t index : candidates) visibility_sum += predictions[index].visibility;

  MixtureTerms result;
  double clutter_share = candidates.empty() ? 1.0 : 0.0;
  terms.assign(candidates.size(), 0.0);
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    const LandmarkPrediction& prediction = predictions[candidates[i]];
    // An identified detection was reported, so it was in view, whatever the declared limits say.
    const double fallback = 1.0 / static_cast<double>(candidates.size());
    const double share = identified ? 1.0 : visibility_sum > 0 ? prediction.visibility / visibility_sum : 0.0;
    const double clutter = clutterOf(prepared.clutter, prepared.reading.model, prepared.relevant[candidates[i]]);
    clutter_share += clutter * (visibility_sum > 0 || identified ? share : fallback);
    if (share > 0 && isWithin(detection, prediction, kFar))
      terms[i] = (1 - clutter) * share * std::exp(logDensity(detection, prediction));
    result.total += terms[i];
  }
  result.clutter = clutter_share * prepared.clutter_density[d];
  result.total += result.clutter;
  return result;
}

void predictAll(const PreparedReading& prepared, const Pose2& robot, const SensorBias& bias,
                std::vector<LandmarkPrediction>& predictions)
{
  predictions.clear();
  for (const std::size_t landmark : prepared.relevant)
  {
    predictions.push_back(predict(prepared.map[landmark], prepared.reading, robot));
    applyBias(predictions.back(), bias);
  }
}

double logLikelihoodOf(const PreparedReading& prepared, const Pose2& robot, const SensorBias& bias)
{
  std::vector<LandmarkPrediction> predictions;
  std::vector<double> terms;
  predictAll(prepared, robot, bias, predictions);
  double sum = 0;
  for (std::size_t d = 0; d < prepared.reading.detections.size(); ++d)
    sum += std::log(mixture(prepared, d, predictions, terms).total);
  if (prepared.score_missed) sum += logMissedDetections(prepared.reading, prepared.map, predictions);
  return sum;
}
}  // namespace

double logLikelihood(const Reading& reading, const LandmarkTable& map, const Pose2& robot,
                     const LandmarkClutter& clutter, const SensorBias& bias)
{
  return logLikelihoodOf(PreparedReading(reading, map, clutter), robot, bias) +
         facingLogLikelihood(reading, map, robot, bias);
}

void addLogLikelihood(const Reading& reading, const LandmarkTable& map, const LandmarkClutter& clutter,
                      const PoseBatch& robots, std::span<float> log_likelihood)
{
  ReadingScorer(reading, map, clutter, robots.origin).addTo(robots, log_likelihood);
  addFacingLogLikelihood(reading, map, robots, log_likelihood);
}

std::vector<std::vector<double>> associationProbabilities(const Reading& reading, const LandmarkTable& map,
                                                          const LandmarkClutter& clutter, const Pose2& robot,
                                                          const SensorBias& bias)
{
  const PreparedReading prepared(reading, map, clutter);
  std::vector<LandmarkPrediction> predictions;
  std::vector<double> terms;
  predictAll(prepared, robot, bias, predictions);
  std::vector<std::vector<double>> probabilities(reading.detections.size(), std::vector<double>(map.size(), 0.0));
  for (std::size_t d = 0; d < reading.detections.size(); ++d)
  {
    const MixtureTerms result = mixture(prepared, d, predictions, terms);
    for (std::size_t i = 0; i < terms.size(); ++i)
      probabilities[d][prepared.relevant[prepared.candidates[d][i]]] = terms[i] / result.total;
  }
  return probabilities;
}
}  // namespace mrpt_ext
