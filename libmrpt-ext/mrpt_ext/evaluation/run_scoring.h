#pragma once

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// The method whose convergence is judged: particle_filter, else the first other method that carries its pose from
/// frame to frame. Dead reckoning does not count, since its start is taken from the truth. Nothing when only closed
/// forms ran: then convergence does not apply, all their estimates count, and success is absent.
[[nodiscard]] const MethodTrajectory* judgedMethod(const RunRecord& record);

/// Judges one trial. `record` as it comes from the run: dead reckoning is aligned here.
[[nodiscard]] RunScore scoreRun(const RunContext& context, const RunRecord& record, const ConvergenceLimits& limits);
}  // namespace mrpt_ext
