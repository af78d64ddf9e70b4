#include "mrpt_ext/filter/kalman/kalman_update.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/kalman/facing_update.h"
#include "mrpt_ext/filter/kalman/kalman_association.h"
#include "mrpt_ext/filter/kalman/kalman_innovation.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/missed_detections.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"
#include "mrpt_ext/likelihood/scoring_work.h"

namespace mrpt_ext
{
namespace
{
constexpr double kCompassClutter = 0.05;  // magnetic disturbances, as for particles
constexpr double kMostPairs = 1e6;        // of a detection and a landmark, in one update of all filters
constexpr double kCostOutOfRange = 0.03;  // of a landmark that is told to be out of range: share of a comparison

/// The frame's detections in the order of the update.
std::vector<DetectionUse> ordered(const std::vector<Reading>& readings, const LandmarkTable& map,
                                  const KalmanState& prior, const BiasModel& biases, double default_max_range)
{
  std::vector<DetectionUse> order;
  bool anonymous = false;
  for (std::size_t r = 0; r < readings.size(); ++r)
    for (std::size_t d = 0; d < readings[r].detections.size(); ++d)
    {
      anonymous = anonymous || readings[r].detections[d].id == kNoId;
      order.push_back({.reading = r, .detection = d});
    }
  if (!anonymous) return order;
  std::vector<std::pair<double, DetectionUse>> certainty;
  for (const DetectionUse& use : order)
  {
    const Reading& reading = readings[use.reading];
    const Detection& detection = reading.detections[use.detection];
    certainty.emplace_back(associate(detection, reading, map, prior, biases, default_max_range).best, use);
  }
  std::stable_sort(certainty.begin(), certainty.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = certainty[i].second;
  return order;
}

void useCompass(const CompassRecord& compass, KalmanUpdate& update)
{
  const KalmanRow row = lineariseHeading(compass.heading, compass.std_heading, update.state.mean);
  const Innovation innovation = innovationOf({&row, 1}, update.state.covariance);
  const double inlier = (1 - kCompassClutter) * std::exp(innovation.log_density), outlier = kCompassClutter / kTwoPi;
  update.log_evidence += std::log(inlier + outlier);
  if (!(inlier > outlier)) return;
  applyRows({&row, 1}, update.state);
  update.nis += innovation.nis;
  ++update.degrees_of_freedom;
  update.compass_used = true;
}

/// The direction of the landmark of a detection, after its bearing and range.
void useFacing(DetectionUse& use, const Reading& reading, const LandmarkTable& map, const BiasModel& biases,
               KalmanUpdate& update)
{
  const Detection& detection = reading.detections[use.detection];
  const auto compared = compareFacing(detection, reading, map, update.state, biases);
  if (!compared) return;
  update.log_evidence += std::log(compared->evidence);
  if (!use.landmark || !compared->attitude) return;
  use.attitude = compared->attitude;
  const KalmanRow row = lineariseFacing(detection, *use.attitude, reading, map, update.state.mean, biases);
  applyRows({&row, 1}, update.state);
  update.nis += compared->nis;
  ++update.degrees_of_freedom;
}

double logMissed(const std::vector<Reading>& readings, const LandmarkTable& map, const Pose2& pose)
{
  double sum = 0;
  for (const Reading& reading : readings)
  {
    if (!scoresMissedDetections(reading)) continue;
    std::vector<LandmarkPrediction> predictions;
    for (const Landmark& landmark : map.all()) predictions.push_back(predict(landmark, reading, pose));
    sum += logMissedDetections(reading, map, predictions);
  }
  return sum;
}

}  // namespace

std::optional<Frame> affordableToUpdate(const Frame& frame, const LandmarkTable& map, std::size_t filters)
{
  double pairs = 0;
  for (const Reading& reading : frame.readings)
  {
    const double share = std::min(1.0, shareInRange(reading.model, map, Vector2d::Zero()) + kCostOutOfRange);
    const double compared = std::max(1.0, static_cast<double>(map.size()) * share);
    for (const Detection& detection : reading.detections) pairs += detection.id == kNoId ? compared : 1;
  }
  return affordableFrame(frame, static_cast<double>(filters) * pairs, kMostPairs);
}

KalmanUpdate updateExtended(const KalmanState& prior, const Frame& frame, const LandmarkTable& map,
                            const BiasModel& biases)
{
  const std::vector<Reading> readings = scoredReadings(frame);
  const double default_max_range = defaultMaxRange(map);
  KalmanUpdate update{.state = prior};
  update.log_evidence = logMissed(readings, map, prior.pose());
  if (frame.compass) useCompass(*frame.compass, update);
  update.detections = ordered(readings, map, update.state, biases, default_max_range);
  for (DetectionUse& use : update.detections)
  {
    const Reading& reading = readings[use.reading];
    const Detection& detection = reading.detections[use.detection];
    const Association found = associate(detection, reading, map, update.state, biases, default_max_range);
    update.log_evidence += std::log(found.evidence);
    use.inlier_probability = found.inlier_probability;
    if (found.best > 0.5)
    {
      use.landmark = found.landmark;
      update.nis += found.nis;
      update.degrees_of_freedom += found.rows.count;
      applyRows(rowsOf(found.rows), update.state);
    }
    useFacing(use, reading, map, biases, update);
  }
  return update;
}
}  // namespace mrpt_ext
