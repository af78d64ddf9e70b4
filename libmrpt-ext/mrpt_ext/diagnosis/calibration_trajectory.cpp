#include "mrpt_ext/diagnosis/calibration_trajectory.h"

#include <utility>

#include "mrpt_ext/experiment/method_factory.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostEstimates = 100'000;  // bound the memory of a log of hours
}  // namespace

CalibrationTrajectory::CalibrationTrajectory(const LocalizationConfig& config)
    : min_best_weight_(config.filter.verdict.min_best_weight),
      needs_heading_(config.filter.heading_observable),
      independent_frames_(config.frames.independent)
{
}

bool CalibrationTrajectory::add(const PoseEstimate& estimate)
{
  const bool is_ok = estimate.verdict == Verdict::ok;
  const bool dominates = estimate.verdict != Verdict::lost && estimate.best_weight >= min_best_weight_;
  const bool counts = (independent_frames_ ? is_ok : is_ok || dominates) && (estimate.heading_known || !needs_heading_);
  if (!counts)
  {
    endSpell();
    return false;
  }
  if (is_ok && !verified_) spell_.clear();
  verified_ = verified_ || is_ok;
  if (chosen_.size() + spell_.size() < kMostEstimates) spell_.push_back(estimate);
  return true;
}

std::vector<PoseEstimate> CalibrationTrajectory::take()
{
  endSpell();
  return std::move(chosen_.empty() ? longest_unverified_ : chosen_);
}

void CalibrationTrajectory::endSpell()
{
  if (verified_)
    chosen_.insert(chosen_.end(), spell_.begin(), spell_.end());
  else if (spell_.size() > longest_unverified_.size())
    longest_unverified_.swap(spell_);
  spell_.clear();
  verified_ = false;
}

std::vector<PoseEstimate> calibrationTrajectory(const LocalizationInput& input, std::uint64_t seed)
{
  LocalizationConfig config = input.config;
  config.methods = {"particle_filter"};
  if (config.frames.independent) config.methods = {"bearing_maximum_likelihood", "two_landmark_pose"};
  const MethodFactory factory(config, input.context.map, input.log.available);
  const Methods methods = factory.make(seed, 0);
  CalibrationTrajectory trajectory(config);
  const FrameStream frames = streamOf(input);
  while (const auto frame = frames())
    for (const auto& method : methods.localizers)
      if (const Estimate estimate = method->process(*frame); estimate.point && trajectory.add(*estimate.point)) break;
  return trajectory.take();
}
}  // namespace mrpt_ext
