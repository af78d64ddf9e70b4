#pragma once

#include "mrpt_ext/filter/modes/modes.h"

namespace mrpt_ext
{
/// Sampling error of mean and covariance over few particles. The reported covariance of n effective particles is free
/// of the bias of a small sample, and contains the sampling variance of the mean: 1 / n of the covariance, and what is
/// left of that of the steps before.
class SamplingError
{
 public:
  /// Share of the sampling variance of the mean that a measurement leaves, both relative to the covariance at their
  /// time. `before`: covariance of the last step, `predicted`: after the motion, `after`: after the measurement.
  [[nodiscard]] static double remainder(const Matrix3d& before, const Matrix3d& predicted, const Matrix3d& after);

  /// Corrects the covariances of the modes. `remainder`: as above; 0 where there were several modes, or are now.
  void correct(ModeSet& modes, double effective, double remainder);

 private:
  double variance_ = 0;  // of the last mean, relative to its covariance
};
}  // namespace mrpt_ext
