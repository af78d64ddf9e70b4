#include "mrpt_ext/filter/integrity/heading_and_directions.h"

#include <algorithm>

namespace mrpt_ext
{
void HeadingAndDirections::add(double variance)
{
  const Eigen::Index n = covariance_.rows();
  covariance_.conservativeResize(n + 1, n + 1);
  covariance_.col(n).head(n) = covariance_.col(0).head(n);
  covariance_.row(n).head(n) = covariance_.row(0).head(n);
  covariance_(n, n) = covariance_(0, 0) + variance;
}

void HeadingAndDirections::remove(Eigen::Index direction)
{
  const Eigen::Index n = covariance_.rows(), after = size() - direction - 1, at = n - after - 1;
  covariance_.block(at, 0, after, n) = covariance_.block(at + 1, 0, after, n).eval();
  covariance_.block(0, at, n, after) = covariance_.block(0, at + 1, n, after).eval();
  covariance_.conservativeResize(n - 1, n - 1);
}

double HeadingAndDirections::bearingVariance(Eigen::Index direction) const
{
  const Eigen::Index k = direction + 1;
  return std::max(0.0, covariance_(0, 0) + covariance_(k, k) - 2 * covariance_(0, k));
}

HeadingAndDirections::Correction HeadingAndDirections::update(Eigen::Index direction, double innovation,
                                                              double variance, double spread)
{
  const Eigen::Index k = direction + 1;
  const double known = bearingVariance(direction);
  Eigen::VectorXd gain = Eigen::VectorXd::Zero(covariance_.rows());
  if (known > variance)
  {
    // Measured so imprecisely that afterwards the bearing is known as one measurement tells it.
    const double total = known + known * variance / (known - variance);
    gain = (covariance_.col(k) - covariance_.col(0)) / total;
    covariance_ -= total * gain * gain.transpose();
  }
  const Eigen::VectorXd correction = gain * innovation;
  // Each range that the feature may have predicts a different bearing: the moments of that mixture.
  gain(k) -= 1;
  covariance_ += spread * gain * gain.transpose();
  return {correction(0), correction.tail(size())};
}
}  // namespace mrpt_ext
