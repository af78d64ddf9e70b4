#include "mrpt_ext/evaluation/rmse_interval.h"

#include "mrpt_ext/evaluation/method_comparison.h"
#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMinValues = 5;
}  // namespace

std::optional<ConfidenceInterval> rmseInterval(const std::vector<ErrorSample>& errors, double from)
{
  std::vector<double> squares;
  for (const ErrorSample& error : errors)
    if (error.stamp >= from) squares.push_back(square(error.position_m));
  // A ratio to ones is the RMSE itself.
  const auto rmse = rmseRatio(squares, std::vector<double>(squares.size(), 1.0), kBlockOfStamps);
  if (!rmse) return std::nullopt;
  return ConfidenceInterval{rmse->low, rmse->high};
}

std::optional<ConfidenceInterval> medianInterval(const std::vector<double>& values)
{
  if (values.size() < kMinValues) return std::nullopt;
  RandomStream random(1);
  std::vector<double> medians, drawn(values.size());
  for (int k = 0; k < kResamples; ++k)
  {
    for (double& value : drawn) value = values[random.below(values.size())];
    medians.push_back(*median(drawn));
  }
  return ConfidenceInterval{*quantile(medians, 0.025), *quantile(medians, 0.975)};
}
}  // namespace mrpt_ext
