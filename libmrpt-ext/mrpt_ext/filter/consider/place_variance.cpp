#include "mrpt_ext/filter/consider/place_variance.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <limits>

#include "mrpt_ext/geometry/angle.h"

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
  double best = -std::numeric_limits<double>::infinity(), weights = 0, sum = 0;
  std::array<double, kScales.size()> logs{};
  for (std::size_t k = 0; k < kScales.size(); ++k)
  {
    logs[k] = logMarginal(evidence, square(kScales[k] * assumed_std));
    if (logs[k] > best) best = logs[k];
  }
  for (std::size_t k = 0; k < kScales.size(); ++k)
  {
    const double weight = std::exp(logs[k] - best);
    if (!(weight > 0)) continue;
    weights += weight;
    sum += weight * square(kScales[k]);
  }
  return square(assumed_std) * (weights > 0 ? sum / weights : 1);
}
}  // namespace mrpt_ext
