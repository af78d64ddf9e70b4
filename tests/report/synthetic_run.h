#pragma once

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext::testing
{
/// A run with everything a report can show: eight landmarks in a 10 x 7 m room (one with a warning), truth on an
/// oval, dead reckoning in its own frame that drifts, a filter that is ambiguous for 8 s, three closed forms, an
/// oracle, reseeds, modes and an object. Deterministic.
[[nodiscard]] RunContext syntheticContext(double duration = 120);
[[nodiscard]] RunRecord syntheticRecord(const RunContext& context, int trial = 0);

/// Playback of `filter`: `steps` of its steps with `particles` particles each.
[[nodiscard]] std::vector<PlaybackStep> syntheticPlayback(const MethodTrajectory& filter, std::size_t steps,
                                                          std::size_t particles);
}  // namespace mrpt_ext::testing
