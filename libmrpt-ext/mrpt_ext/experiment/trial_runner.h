#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/experiment/localization_input.h"
#include "mrpt_ext/experiment/method_factory.h"

namespace mrpt_ext
{
/// What all trials of a run share.
struct TrialInput
{
  const MethodFactory& methods;
  const LocalizationInput& run;             ///< its truth is used for the oracle rows only, after the estimates
  const std::atomic<bool>& stop;            ///< set on Ctrl-C: the trial ends after the frame in work
  std::function<void(double)> on_progress;  ///< called with the share done, in [0, 1]; may be empty
  /// Called after each frame with its number and the filter (null without one); may be empty.
  std::function<void(std::size_t, const Frame&, const FilterLocalizer*)> on_frame;
};

/// A finished trial, and its last frame with all particles.
struct TrialOutcome
{
  RunRecord record;
  PlaybackStep final_step;
};

/// Passes all frames to all methods and records their estimates. The same (seed, trial) gives the same record, whatever
/// runs concurrently.
[[nodiscard]] TrialOutcome runTrial(const TrialInput& input, std::uint64_t seed, int trial);
}  // namespace mrpt_ext
