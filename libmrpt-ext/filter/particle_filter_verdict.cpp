// How a ParticleFilter judges itself.
#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
bool ParticleFilter::challengeDue(const Frame& frame) const
{
  if (!isOnePlace(modes_, options_.verdict)) return false;
  const RecoveryOptions& recovery = options_.recovery;
  const auto is_nameless = [](const Reading& reading)
  {
    return std::any_of(reading.detections.begin(), reading.detections.end(),
                       [](const Detection& d) { return d.id == kNoId; });
  };
  const double waited = since_injection_ + frame.motion.duration;
  if (!evidence_.proven()) return waited >= recovery.challenge_interval;
  return waited >= recovery.review_interval && std::any_of(frame.readings.begin(), frame.readings.end(), is_nameless);
}

void ParticleFilter::followEvidence(const Frame& frame, const ModeSet& modes)
{
  // From a known start, and nothing else tried since, a wide place is still the known one.
  if (options_.initial_mode == InitialMode::gaussian && std::isinf(since_injection_)) return;
  if (!isOnePlace(modes, options_.verdict))
    evidence_.restart();
  else if (isOnePlace(modes_, options_.verdict))
  {
    const KalmanState moved = bestPlaceAfter(frame.motion);
    const Vector2d away = modes.modes.front().pose.mean.position() - moved.mean.head<2>();
    const double turned = wrap(modes.modes.front().pose.mean.phi - moved.mean.z());
    if (away.norm() > options_.verdict.max_std_xy || std::abs(turned) > options_.verdict.max_std_phi)
      evidence_.restart();
  }
}

void ParticleFilter::checkAgreement(const Frame& frame, bool learn)
{
  double explained = 0, expected = 0, promised = 0;
  std::size_t detections = 0;
  for (const Reading& reading : scoredReadings(frame))
  {
    std::size_t before = detections;
    const double expected_before = expected;
    const double share =
        reliability_.observe(reading, map_, particles_, options_.learn_reliability && learn, options_.threads);
    explained += share * static_cast<double>(reading.detections.size());
    const LandmarkClutter clutter = reliability_.clutter(reading.model.clutter_probability);
    for (const Detection& detection : reading.detections)
    {
      if (!mayShowAny(detection, map_)) continue;  // not in the map: no pose could explain it
      const auto known = map_.indexOf(detection.id);
      expected += 1 - (known ? clutter[*known] : reading.model.clutter_probability);
      promised += 1 - reading.model.clutter_probability;
      ++detections;
    }
    const auto of_reading = static_cast<double>(std::max<std::size_t>(1, detections - before));
    kinds_.observe(kindOfReadings(reading), share * static_cast<double>(reading.detections.size()) / of_reading,
                   (expected - expected_before) / of_reading, detections - before);
  }
  if (detections == 0) return;
  const auto count = static_cast<double>(detections);
  monitor_.observe(explained / count, expected / count, detections);
  trust_.observe(explained / count, promised / count, detections);
  surprise_.observe(explained / count, promised / count, detections);
}

VerdictWithReason ParticleFilter::judgeStep(const FilterStep& step) const
{
  const double effective = step.effective_ratio * static_cast<double>(particles_.size());
  const bool surprised = surprise_.suspicious() || monitor_.suspicious();
  const double share = surprised ? std::min(surprise_.average(), monitor_.average()) : trust_.average();
  return judge(step.modes, {share, monitor_.lost(), effective, evidence_.logOdds(), evidence_.proven()},
               options_.verdict);
}
}  // namespace mrpt_ext
