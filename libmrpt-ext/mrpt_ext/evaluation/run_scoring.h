#pragma once

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// The method whose convergence counts: particle_filter, else the first other method that tracks. Dead reckoning does
/// not qualify, since its start is taken from the truth. Null when only closed forms ran: then convergence does not
/// apply, all estimates count, and success is absent.
[[nodiscard]] const MethodTrajectory* judgedMethod(const RunRecord& record);

/// Scores one trial. `record` as it comes from the run: dead reckoning is aligned here.
[[nodiscard]] RunScore scoreRun(const RunContext& context, const RunRecord& record, const ConvergenceLimits& limits);
}  // namespace mrpt_ext
