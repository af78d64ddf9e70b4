#include "mrpt_ext/filter/consider/place_variance.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/log_probability.h"

namespace mrpt_ext
{
namespace
{
// Scales in ratios of two; the mean of their squares is one.
constexpr double kWidest = 2.12157935;
constexpr std::array kScales = {kWidest, kWidest / 2, kWidest / 4, kWidest / 8, kWidest / 16, kWidest / 32};

/// Log-likelihood of a prior variance, up to a constant: of the data, with the parameters integrated out.
double logMarginal(const LinearEvidence& evidence, double variance)
{
  const Eigen::Index count = evidence.weighted.size();
  const Eigen::MatrixXd relative =
      Eigen::MatrixXd::Identity(count, count) + variance * evidence.information;  // to the prior's information
  const Eigen::LLT<Eigen::MatrixXd> solver(0.5 * (relative + relative.transpose()));
  const double log_det = 2 * solver.matrixLLT().diagonal().array().log().sum();
  return 0.5 * (variance * evidence.weighted.dot(solver.solve(evidence.weighted)) - log_det);
}
}  // namespace

double placeVariance(const LinearEvidence& evidence, double assumed_std)
{
  double log_weights = kLogZero, log_squares = kLogZero;
  for (const double scale : kScales)
  {
    const double log_weight = logMarginal(evidence, square(scale * assumed_std));
    if (!std::isfinite(log_weight)) continue;
    log_weights = logSum(log_weights, log_weight);
    log_squares = logSum(log_squares, log_weight + 2 * std::log(scale));
  }
  return square(assumed_std) * (std::isfinite(log_weights) ? std::exp(log_squares - log_weights) : 1);
}
}  // namespace mrpt_ext
