#include "mrpt_ext/diagnosis/calibration_trajectory.h"

#include <algorithm>
#include <utility>

#include "mrpt_ext/experiment/method_factory.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostEstimates = 100'000;  // bound the memory of a log of hours
constexpr double kMostlyOk = 0.5;                // share of the estimates
constexpr double kScaleStd = 0.05;               // of uncalibrated radios

bool isOfRanges(const BiasState& bias)
{
  return bias.kind == BiasKind::range_offset || bias.kind == BiasKind::range_scale;
}

bool hasOnlyRanges(const AvailableMeasurements& log)
{
  return log.identified_range && !log.identified_bearing && !log.identified_point && !log.anonymous_bearing && !log.fix;
}

CalibrationTrajectory passOver(const LocalizationInput& input, LocalizationConfig config, std::uint64_t seed)
{
  config.methods = {"particle_filter"};
  if (config.frames.independent) config.methods = {"bearing_maximum_likelihood", "two_landmark_pose"};
  const MethodFactory factory(config, input.context.map, input.log.available);
  const Methods methods = factory.make(seed, 0);
  CalibrationTrajectory trajectory(config);
  const FrameStream frames = streamOf(input);
  while (const auto frame = frames())
    for (const auto& method : methods.localizers)
      if (const Estimate estimate = method->process(*frame); estimate.point && trajectory.add(*estimate.point)) break;
  return trajectory;
}
}  // namespace

CalibrationTrajectory::CalibrationTrajectory(const LocalizationConfig& config)
    : dominant_weight_(config.filter.verdict.dominantWeight()),
      needs_heading_(config.filter.heading_observable),
      independent_frames_(config.frames.independent)
{
}

bool CalibrationTrajectory::add(const PoseEstimate& estimate)
{
  const bool is_ok = estimate.verdict == Verdict::ok, is_lost = estimate.verdict == Verdict::lost;
  added_ += 1;
  ok_ += is_ok ? 1 : 0;
  const bool dominates = !is_lost && estimate.best_weight >= dominant_weight_;
  const bool counts = (independent_frames_ ? is_ok : is_ok || dominates) && (estimate.heading_known || !needs_heading_);
  if (!counts)
  {
    if (!verified_ || is_lost) endUnverified();
    verified_ = verified_ && !is_lost;
    interrupted_ = verified_;
    return false;
  }
  if (is_ok)
  {
    if (verified_) chosen_.insert(chosen_.end(), pending_.begin(), pending_.end());
    pending_.clear();
    verified_ = true;
    interrupted_ = false;
  }
  if (chosen_.size() + pending_.size() < kMostEstimates)
    (verified_ && !interrupted_ ? chosen_ : pending_).push_back(estimate);
  return true;
}

std::vector<PoseEstimate> CalibrationTrajectory::take()
{
  endUnverified();
  return std::move(chosen_.empty() ? longest_unverified_ : chosen_);
}

void CalibrationTrajectory::endUnverified()
{
  if (!verified_ && pending_.size() > longest_unverified_.size()) longest_unverified_.swap(pending_);
  pending_.clear();
}

std::vector<PoseEstimate> likelierTrajectory(const LocalizationInput& input, const CalibrationPass& pass)
{
  CalibrationTrajectory configured = pass(input.config);
  if (configured.okShare() >= kMostlyOk || !hasOnlyRanges(input.log.available) || input.config.frames.independent ||
      std::any_of(input.config.biases.begin(), input.config.biases.end(), isOfRanges))
    return configured.take();
  LocalizationConfig uncertain = input.config;
  uncertain.biases.push_back({.kind = BiasKind::range_scale, .std = kScaleStd});
  uncertain.filter.biases = uncertain.biases;
  CalibrationTrajectory estimated = pass(uncertain);
  return (estimated.okShare() > configured.okShare() ? estimated : configured).take();
}

std::vector<PoseEstimate> calibrationTrajectory(const LocalizationInput& input, std::uint64_t seed)
{
  return likelierTrajectory(input, [&](const LocalizationConfig& config) { return passOver(input, config, seed); });
}
}  // namespace mrpt_ext
