#include "mrpt_ext/evaluation/consistency.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>

namespace mrpt_ext
{
namespace
{
/// e^T P^-1 e of the leading coordinates that P covers; nothing when P is not positive definite.
template <typename Matrix, typename Vector>
std::optional<double> normalisedSquare(const Matrix& P, const Vector& e)
{
  const Eigen::LLT<Matrix> factor(P);
  if (factor.info() != Eigen::Success) return std::nullopt;
  const double value = e.dot(factor.solve(e));
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}
}  // namespace

double chiSquareQuantile(double degrees_of_freedom, double probability)
{
  return boost::math::quantile(boost::math::chi_squared(degrees_of_freedom), probability);
}

std::vector<NeesSample> neesOf(const std::vector<JudgedEstimate>& judged)
{
  std::vector<NeesSample> samples;
  for (const JudgedEstimate& entry : judged)
  {
    Vector3d error = entry.estimate.pose.mean.vector() - entry.truth.pose.vector();
    error.z() = wrap(error.z());
    const Matrix3d& P = entry.estimate.pose.covariance;
    const bool heading = entry.estimate.heading_known && entry.truth.heading_known;
    const auto nees = heading ? normalisedSquare<Matrix3d, Vector3d>(P, error)
                              : normalisedSquare<Matrix2d, Vector2d>(P.topLeftCorner<2, 2>(), error.head<2>());
    if (nees) samples.push_back({entry.stamp, *nees, heading ? 3 : 2, P});
  }
  return samples;
}

std::optional<double> coverage(const std::vector<JudgedEstimate>& judged, double probability)
{
  const std::vector<NeesSample> samples = neesOf(judged);
  if (samples.empty()) return std::nullopt;
  const double plane = chiSquareQuantile(2, probability), pose = chiSquareQuantile(3, probability);
  const auto within = std::count_if(samples.begin(), samples.end(),
                                    [&](const NeesSample& sample)
                                    { return sample.value <= (sample.degrees_of_freedom == 3 ? pose : plane); });
  return static_cast<double>(within) / static_cast<double>(samples.size());
}

Consistency consistency(const std::vector<JudgedEstimate>& judged)
{
  const std::vector<NeesSample> samples = neesOf(judged);
  Consistency result;
  result.count = samples.size();
  result.singular = judged.size() - samples.size();
  if (samples.empty()) return result;
  double sum = 0, degrees_of_freedom = 0;
  for (const NeesSample& sample : samples)
  {
    sum += sample.value;
    degrees_of_freedom += sample.degrees_of_freedom;
  }
  const auto n = static_cast<double>(result.count);
  result.mean = sum / n;
  result.band_low = chiSquareQuantile(degrees_of_freedom, 0.025) / n;
  result.band_high = chiSquareQuantile(degrees_of_freedom, 0.975) / n;
  return result;
}
}  // namespace mrpt_ext
