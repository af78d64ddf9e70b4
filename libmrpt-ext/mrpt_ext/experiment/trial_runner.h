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
  const LocalizationInput& run;          ///< its truth is used after the estimates, for the oracle rows only
  const std::atomic<bool>& stop;         ///< set on Ctrl-C: the trial ends after the frame in work
  std::function<void(double)> progress;  ///< told the share done, in [0, 1]
  /// Shown every frame after the methods have seen it, with its number and the filter (null without one). May be empty.
  std::function<void(std::size_t, const Frame&, const FilterLocalizer*)> watch;
};

/// A finished trial, and its end with all particles.
struct TrialOutcome
{
  RunRecord record;
  PlaybackStep end;
};

/// Feeds all frames to all methods and keeps what they say. The same (seed, trial) gives the same record, whatever
/// runs beside it.
[[nodiscard]] TrialOutcome runTrial(const TrialInput& input, std::uint64_t seed, int trial);
}  // namespace mrpt_ext
