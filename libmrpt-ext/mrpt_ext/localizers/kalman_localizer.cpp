#include "mrpt_ext/localizers/kalman_localizer.h"

#include "mrpt_ext/geometry/bounded_frame.h"
#include "mrpt_ext/hypotheses/bias_inflation.h"
#include "mrpt_ext/hypotheses/informative_readings.h"
#include "mrpt_ext/hypotheses/window_readings.h"
#include "mrpt_ext/localizers/filter_localizer.h"
#include "mrpt_ext/relocalization/measurement_window.h"

namespace mrpt_ext
{
namespace
{
constexpr double kEqual = 0.99;  // share of the best weight, from which on two hypotheses cannot be ranked
}  // namespace

void KalmanLocalizer::buffer(const Frame& frame)
{
  if (recent_.empty()) first_time_ = frame.time;
  recent_.push_back(frame);
  while (recent_.front().time < frame.time - seed_window_) recent_.pop_front();
}

Proposal KalmanLocalizer::propose() const
{
  MeasurementWindow window(seed_window_, motion_);
  for (const Frame& frame : recent_) window.add(frame);
  Frame evidence = window.frame();
  if (isWindow(evidence.readings)) evidence.readings = informativeReadings(evidence.readings);
  if (auto bounded = boundedFrame(evidence, kMostJoined)) evidence = std::move(*bounded);
  evidence.readings = withBiasUncertainty(std::move(evidence.readings), biases_);
  Proposal proposal(proposePoses(evidence, map_, *search_, {.region = region_}));
  proposal.complete = recent_.back().time - first_time_ >= seed_window_;
  return proposal;
}

Estimate KalmanLocalizer::process(const Frame& whole)
{
  const std::optional<Frame> bounded = boundedFrame(whole, kMostKalmanDetections);
  const Frame& frame = bounded ? *bounded : whole;
  buffer(frame);
  step_ = bank_.process(frame, [this] { return propose(); });

  Estimate estimate = estimateFrom(step_.modes.modes, step_.verdict, heading_known_, name_, frame.time);
  if (estimate.candidates.size() > 1 && estimate.candidates[1].weight > kEqual * estimate.candidates[0].weight)
    estimate.point.reset();
  return estimate;
}
}  // namespace mrpt_ext
