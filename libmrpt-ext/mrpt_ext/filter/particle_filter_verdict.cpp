// How a ParticleFilter judges itself.
#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMajority = 0.5;  // of the weight: another place that has it is put to the test instead
}  // namespace

bool ParticleFilter::challengeDue(const Frame& frame, bool one_place, bool way_is_known) const
{
  const double waited = since_injection_ + frame.motion.duration;
  if (!one_place || !evidence_.proven()) return waited >= challenge_pause_ && (one_place || way_is_known);
  return waited >= options_.recovery.review_interval && (way_is_known || hasAnonymous(frame));
}

void ParticleFilter::followEvidence(const Frame& frame, const ModeSet& modes)
{
  // From a known start, and nothing else tried since, a wide place is still the known one.
  if (options_.initial_mode == InitialMode::gaussian && std::isinf(since_injection_)) return;
  if (modes.modes.empty()) return;
  const VerdictOptions& limits = options_.verdict;
  const Mode& best = modes.modes.front();
  const bool one_place = isUnimodal(modes, limits);
  bool restart = !tested_ && !one_place;
  if (tested_)
  {
    tested_ = predict(*tested_, particles_.bias_states, options_.motion, frame.motion);
    const Vector2d away = best.pose.mean.position() - tested_->mean.head<2>();
    const double turned = wrap(best.pose.mean.phi - tested_->mean.z());
    const bool elsewhere = away.norm() > limits.max_std_xy || std::abs(turned) > limits.max_std_phi;
    const bool vague = !isUnimodal({{{tested_->gaussianPose(), 1}}, {}}, limits);
    restart = vague || (elsewhere && best.weight > kMajority);
  }
  if (restart)
  {
    tested_.reset();
    evidence_.restart();
    challenge_pause_ = options_.recovery.challenge_interval;
  }
  if (one_place) tested_ = startingState(best.pose, particles_.bias_states);
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
    kinds_.observe(sensorKey(reading), share * static_cast<double>(reading.detections.size()) / of_reading,
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
  return judge(step.modes, {share, monitor_.lost(), effective, evidence_.logOdds(), evidence_.proven(), contradicted_},
               options_.verdict);
}
}  // namespace mrpt_ext
