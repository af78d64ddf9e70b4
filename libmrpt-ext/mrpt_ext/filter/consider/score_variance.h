#pragma once

#include <Eigen/Core>

namespace mrpt_ext
{
/// How much less than white errors those of real readings, which last, tell of each parameter of a linear model.
///
/// A score is the sum of residuals, each times its derivative by the parameter over its variance. Of white errors its
/// variance is the information; the variance of the scores of whole blocks of time, within which errors last, is
/// larger in proportion (the robust variance of Huber, 1967, over clusters: Liang and Zeger, Biometrika 73, 1986).
class ScoreVariance
{
 public:
  /// The scores of one step, which lasted `duration` [s], and what they add to the information of each parameter.
  /// `kept`: what the earlier blocks count now.
  void add(double duration, const Eigen::VectorXd& score, const Eigen::VectorXd& information, double kept);

  /// Information of each parameter as a share of what white errors would tell; at most 1, and 1 before the first block,
  /// also of those of `size` parameters that no score has told of yet.
  [[nodiscard]] Eigen::VectorXd worth(Eigen::Index size) const;

 private:
  double duration_ = 0;                  // [s] of the block that lasts
  Eigen::VectorXd score_, information_;  // ... its sums
  Eigen::VectorXd squared_, expected_;  // sums over the blocks before: squares of the scores, and those of white errors
};
}  // namespace mrpt_ext
