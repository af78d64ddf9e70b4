#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/evaluation/consistency.h"
#include "mrpt_ext/evaluation/convergence.h"
#include "mrpt_ext/evaluation/error_statistics.h"
#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/evaluation/scoring.h"

namespace mrpt_ext
{
/// A number of a run, absent where it does not exist; in a merged score the median over the trials.
using OptionalNumber = std::optional<double>;

/// Score of one method.
struct MethodScore
{
  std::string name;
  bool continuous = false;
  bool oracle = false;
  OptionalNumber estimates;                             ///< number of estimates
  OptionalNumber availability;                          ///< frames with an estimate / frames with any detection
  OptionalNumber ambiguous;                             ///< frames with candidates of equal rank
  ErrorStatistics position_error_m, heading_error_deg;  ///< from the convergence of the judged method on
  ErrorStatistics position_error_whole_run_m;
  ErrorStatistics position_error_with_detections_m;  ///< as position_error_m, without blind stretches
  ErrorStatistics position_error_blind_m;            ///< ... in blind stretches alone (detection_gaps.h)
  OptionalNumber rmse_low, rmse_high;                ///< [m] 95 % interval of the position RMSE, see rmse_interval.h
  OptionalNumber step_ms_median, step_ms_p95, step_ms_p99, step_ms_max;
  std::vector<ErrorSample> errors;  ///< whole run; of one trial only, empty in a merged score
  std::vector<double> trial_rmse;   ///< [m] of a merged score: position RMSE of the trials that have one
};

/// Final estimate of a bias.
struct BiasScore
{
  OptionalNumber mean, std;
};

/// Diagnostics of the filter, and consistency of its covariance.
struct FilterScore
{
  OptionalNumber particles_min, particles_median, particles_max;
  OptionalNumber nees_mean, nees_band_low, nees_band_high;
  OptionalNumber coverage_95;    ///< share of the `ok` estimates whose truth lies in their 95 % region; whole run
  OptionalNumber ok_outside;     ///< `ok` estimates beyond the limits of convergence; whole run of one trial
  std::vector<NeesSample> nees;  ///< whole run; of one trial only, empty in a merged score
  OptionalNumber effective_sample_ratio_min;
  OptionalNumber lost_steps, reseeds;
  OptionalNumber late_estimates, most_steps_late;  ///< where steps have a budget of work
  std::map<std::string, BiasScore> biases;
  std::optional<std::vector<ModeSummary>> modes_at_end;  ///< absent in a merged score: a list has no median
};

struct LandmarkScore
{
  OptionalNumber seen, associated, inlier_rate, residual_mean, residual_std;
};

/// Posterior Cramer-Rao bound of the run, where it was computed.
struct LimitScore
{
  OptionalNumber position_rmse_m, heading_rmse_deg;
  std::string why_none;  ///< reason when the bound of a tracked robot does not exist
};

struct CostScore
{
  OptionalNumber cpu_s, wall_s, peak_memory_mb;
  OptionalNumber realtime_factor;  ///< duration of the log / wall time
};

/// One line of trials_detail.
struct TrialScore
{
  int trial = 0;
  std::uint64_t seed = 0;
  std::optional<bool> success;  ///< absent where convergence does not apply or there is no truth
  Verdict verdict = Verdict::lost;
  OptionalNumber rmse;            ///< position RMSE of the judged method after convergence [m]
  OptionalNumber converged_at_s;  ///< [s] since the start of the log
};

/// A method compared with the judged one.
struct MethodComparison
{
  std::string method, reference;
  double rmse_ratio = 1;                 ///< of the position RMSE to the reference's, at the same stamps
  double ratio_low = 1, ratio_high = 1;  ///< 95 % interval of the resamples
  OptionalNumber cost_ratio;             ///< of the median times per step
};

/// Score of a run: one trial, or several merged.
struct RunScore
{
  std::optional<std::string> judged_method;  ///< whose convergence counts for all; see judgedMethod()
  std::vector<MethodScore> methods;          ///< in the order of the record
  FilterScore filter;
  std::map<std::string, LandmarkScore> landmarks;
  LimitScore limit;
  std::vector<MethodComparison> comparisons;  ///< see method_comparison.h
  CostScore cost;
  ConvergenceLimits limits;  ///< limits of convergence
  OptionalNumber converged_at_s;
  std::size_t truth_stamps = 0;  ///< at which errors are judged; of one trial
  bool truth_is_sparse = false;
  std::vector<TrialScore> trials;
  OptionalNumber success_rate;     ///< successes / trials with a known success
  std::vector<std::string> hints;  ///< of the trial; in a merged score of the first trial that has some
  VerdictShares verdict_shares;    ///< in a merged score their means
  std::optional<std::vector<VerdictSpell>> verdict_spells;  ///< [s] of the log; absent in a merged score
  Verdict verdict = Verdict::lost;
  std::string verdict_reason;
  bool interrupted = false;
};
}  // namespace mrpt_ext
