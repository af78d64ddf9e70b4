#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext
{
/// Gaps of the truth up to this long are interpolated [s].
inline constexpr double kMaxTruthGap = 0.5;
/// An estimate this close to a stamp of sparse truth is judged at it [s].
inline constexpr double kSparseTruthWindow = 0.5;

/// An estimate and the truth at the same time.
struct JudgedEstimate
{
  double stamp = 0;       ///< [s] the common scoring stamp it was judged for
  PoseEstimate estimate;  ///< at the time at which it was judged
  TimedPose truth;        ///< at that time
};

/// Absolute errors of one judged estimate.
struct ErrorSample
{
  double stamp = 0;                   ///< [s] the common scoring stamp
  double time = 0;                    ///< [s] of the comparison
  double position_m = 0;              ///< [m]
  std::optional<double> heading_deg;  ///< [deg], where truth and estimate know their heading
};

/// The stamps at which every method is scored: all full Unix seconds within the log that the truth covers, or the
/// truth's own stamps within the log when it is sparse. No truth: none.
[[nodiscard]] std::vector<double> scoringStamps(const RunContext& context);

/// The truth at `time`, interpolated; nothing where there is none, or a gap.
[[nodiscard]] std::optional<TimedPose> truthAt(const RunContext& context, double time);

/// Judges a method at the stamps.
/// Continuous methods: the last estimate at or before the stamp, predicted to it by dead reckoning; nothing before
/// the first estimate. Closed forms: see judgeAtOwnTimes().
[[nodiscard]] std::vector<JudgedEstimate> judge(const MethodTrajectory& trajectory, const RunContext& context);

/// Judges estimates at their own times: for each stamp s the last estimate within the second (s-1, s], against the
/// truth at the estimate's own time. Sparse truth is not interpolated: the nearest estimate within
/// kSparseTruthWindow is predicted to the stamp by dead reckoning instead.
[[nodiscard]] std::vector<JudgedEstimate> judgeAtOwnTimes(const MethodTrajectory& trajectory,
                                                          const RunContext& context);

[[nodiscard]] ErrorSample errorOf(const JudgedEstimate& entry);
[[nodiscard]] std::vector<ErrorSample> errorsOf(const std::vector<JudgedEstimate>& judged);
}  // namespace mrpt_ext
