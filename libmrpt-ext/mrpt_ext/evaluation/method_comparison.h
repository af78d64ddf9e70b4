#pragma once

#include <vector>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
inline constexpr std::size_t kBlockOfStamps = 10;  ///< neighbouring stamps that are resampled together
inline constexpr int kResamples = 1000;            ///< of the bootstrap

/// Ratio of two RMSE with the 95 % interval of its resamples.
struct RmseRatio
{
  double ratio = 1, low = 1, high = 1;
};

/// sqrt(sum of `squares` / sum of `reference_squares`), paired samples. Resampled in blocks of `block`
/// neighbouring pairs (moving block bootstrap: Kuensch, Annals of Statistics 17(3), 1989), since the errors of
/// neighbouring stamps are correlated; 1 for independent pairs. Nothing with fewer than five blocks.
[[nodiscard]] std::optional<RmseRatio> rmseRatio(const std::vector<double>& squares,
                                                 const std::vector<double>& reference_squares, std::size_t block);

/// Compares every other method that tracks (no oracle, not dead reckoning) with the judged one: at the common stamps
/// from `from` on, in blocks of ten.
[[nodiscard]] std::vector<MethodComparison> compareMethods(const RunScore& score, double from);

/// The same over trials: each trial's RMSE after convergence is one pair.
[[nodiscard]] std::vector<MethodComparison> compareMethods(const RunScore& merged, const std::vector<RunScore>& trials);
}  // namespace mrpt_ext
