#include "mrpt_ext/evaluation/method_comparison.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/evaluation/odometry_alignment.h"
#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMinBlocks = 5;

const MethodScore* find(const RunScore& score, const std::string& name)
{
  const auto found = std::find_if(score.methods.begin(), score.methods.end(),
                                  [&](const MethodScore& method) { return method.name == name; });
  return found == score.methods.end() ? nullptr : &*found;
}

/// Squared errors of two methods, pair by pair.
struct Pairs
{
  std::vector<double> squares, reference_squares;

  void add(double error, double reference_error)
  {
    squares.push_back(square(error));
    reference_squares.push_back(square(reference_error));
  }
};

Pairs pairedErrors(const MethodScore& method, const MethodScore& reference, double from)
{
  Pairs pairs;
  auto other = reference.errors.begin();
  for (const ErrorSample& error : method.errors)
  {
    while (other != reference.errors.end() && other->stamp < error.stamp) ++other;
    if (other == reference.errors.end()) break;
    if (error.stamp >= from && other->stamp == error.stamp) pairs.add(error.position_m, other->position_m);
  }
  return pairs;
}

Pairs pairedTrials(const std::string& method, const std::string& reference, const std::vector<RunScore>& trials)
{
  Pairs pairs;
  for (const RunScore& trial : trials)
  {
    const MethodScore *one = find(trial, method), *other = find(trial, reference);
    if (one && other && one->position_error_m.rmse && other->position_error_m.rmse)
      pairs.add(*one->position_error_m.rmse, *other->position_error_m.rmse);
  }
  return pairs;
}

template <typename PairsOf>
std::vector<MethodComparison> compareAll(const RunScore& score, std::size_t block, PairsOf pairs_of)
{
  std::vector<MethodComparison> comparisons;
  const MethodScore* reference = score.judged_method ? find(score, *score.judged_method) : nullptr;
  if (!reference) return comparisons;
  for (const MethodScore& method : score.methods)
  {
    if (!method.continuous || method.oracle || &method == reference || method.name == kOdometryMethod) continue;
    const Pairs pairs = pairs_of(method, *reference);
    const auto ratio = rmseRatio(pairs.squares, pairs.reference_squares, block);
    if (!ratio) continue;
    MethodComparison comparison{method.name, reference->name, ratio->ratio, ratio->low, ratio->high, {}};
    if (method.step_ms_median && reference->step_ms_median && *reference->step_ms_median > 0)
      comparison.cost_ratio = *method.step_ms_median / *reference->step_ms_median;
    comparisons.push_back(comparison);
  }
  return comparisons;
}
}  // namespace

std::optional<RmseRatio> rmseRatio(const std::vector<double>& squares, const std::vector<double>& reference_squares,
                                   std::size_t block)
{
  const std::size_t n = squares.size();
  if (n != reference_squares.size() || n < kMinBlocks * block) return std::nullopt;
  const auto ratio_of = [](double sum, double reference) { return std::sqrt(sum / std::max(reference, 1e-300)); };
  RandomStream random(1);
  std::vector<double> resampled;
  for (int k = 0; k < kResamples; ++k)
  {
    double sum = 0, reference = 0;
    for (std::size_t drawn = 0; drawn < n; drawn += block)
    {
      const std::size_t first = random.below(n - block + 1);
      for (std::size_t i = first; i < first + block; ++i)
      {
        sum += squares[i];
        reference += reference_squares[i];
      }
    }
    resampled.push_back(ratio_of(sum, reference));
  }
  double sum = 0, reference = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    sum += squares[i];
    reference += reference_squares[i];
  }
  return RmseRatio{ratio_of(sum, reference), *quantile(resampled, 0.025), *quantile(resampled, 0.975)};
}

std::vector<MethodComparison> compareMethods(const RunScore& score, double from)
{
  return compareAll(score, kBlockOfStamps,
                    [from](const MethodScore& method, const MethodScore& reference)
                    { return pairedErrors(method, reference, from); });
}

std::vector<MethodComparison> compareMethods(const RunScore& merged, const std::vector<RunScore>& trials)
{
  return compareAll(merged, 1,
                    [&trials](const MethodScore& method, const MethodScore& reference)
                    { return pairedTrials(method.name, reference.name, trials); });
}
}  // namespace mrpt_ext
