#pragma once

#include "mrpt_ext/filter/modes/modes.h"

namespace mrpt_ext
{
/// Corrects the reported covariance for the finite number n of effective particles. It removes the bias of a small
/// sample, n / (n - 1), and adds the sampling variance of the mean: 1 / n of the covariance, and what remains of the
/// sampling variance of earlier steps.
class SamplingError
{
 public:
  /// False where so few particles are effective that their covariance tells nothing.
  [[nodiscard]] static bool corrects(double effective);

  /// Share of the mean's sampling variance that remains after a step; the variance is relative to the covariance of its
  /// time. Covariances: `before` the step, `predicted` by the motion, `after` the measurement.
  [[nodiscard]] static double remainder(const Matrix3d& before, const Matrix3d& predicted, const Matrix3d& after);

  /// Corrects the covariances of the modes. `effective`: effective particles of all modes together. `remainder`: from
  /// remainder(), or 0 if there were several modes before the step or are after it.
  void correct(ModeSet& modes, double effective, double remainder);

  /// Effective particles over generations: a cloud of which all but one died stays as good as one particle, whatever
  /// the number of its clones, until measurements have replaced what that one knew.
  [[nodiscard]] double effectiveAncestors() const { return variance_ > 0 ? 1 / variance_ : 0; }

 private:
  double variance_ = 0;  // sampling variance of the mean in the last step, relative to the covariance
};
}  // namespace mrpt_ext
