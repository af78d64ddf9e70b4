#include "mrpt_ext/filter/sampling_error.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kMinEffectiveParticles = 4;  // particles
}  // namespace

bool SamplingError::corrects(double effective) { return effective >= kMinEffectiveParticles; }

double SamplingError::remainder(const Matrix3d& before, const Matrix3d& predicted, const Matrix3d& after)
{
  // An error e of the predicted mean is one of P M^-1 e after the measurement (M, P: covariance before and after it).
  // With e relative to the covariance of the last step, it is this times that relative to P, averaged over directions:
  const double M = predicted.determinant();
  const double ratio = before.determinant() * after.determinant() / square(M);
  return M > 0 && ratio > 0 ? std::min(1.0, std::cbrt(ratio)) : 0;
}

void SamplingError::correct(ModeSet& modes, double effective, double remainder)
{
  const double earlier = variance_ * remainder;
  variance_ = earlier + 1 / std::max(1.0, effective);
  for (Mode& mode : modes.modes)
  {
    const double n = std::max(kMinEffectiveParticles, mode.weight * effective);
    mode.pose.covariance *= (n + 1) / (n - 1);
  }
  if (!modes.modes.empty()) modes.modes.front().pose.covariance *= 1 + earlier;
}
}  // namespace mrpt_ext
