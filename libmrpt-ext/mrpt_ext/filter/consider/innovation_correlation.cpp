#include "mrpt_ext/filter/consider/innovation_correlation.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/consider/significant.h"

namespace mrpt_ext
{
namespace
{
constexpr PerDuration kInnovationLags = {0.1, 1, 20};  // [s] between two innovations that tell this duration
constexpr double kLongestLag = 4;                      // times that lag
constexpr double kInnovationSpacing = 0.1;             // [s] between the innovations that are kept
constexpr double kPriorLasting = 0.1, kPriorPairs = 300;
constexpr double kByChance = 1;   // standard deviations
constexpr double kMostShare = 4;  // of the stated variance
}  // namespace

void InnovationCorrelation::add(double time, const InnovationRow& row, const PerDuration& visible)
{
  const double std = std::sqrt(row.row.variance);
  const Past now{time, row.row.residual / std, row.variance / row.row.variance, visible};
  std::deque<Past>& past = past_[row.source];
  auto& sums = sums_[row.source.kind()];
  for (std::size_t k = 0; k < kInnovationLags.size(); ++k)
  {
    const auto later = std::partition_point(past.begin(), past.end(),
                                            [&](const Past& then) { return then.time <= time - kInnovationLags[k]; });
    if (later == past.begin()) continue;
    const Past& then = *std::prev(later);
    if (then.time < time - kLongestLag * kInnovationLags[k]) continue;
    // An innovation that the uncertainty of the pose dominates tells less.
    const double weight = 1 / std::sqrt(now.variance * then.variance);
    const double visible_twice = now.visible[k] * then.visible[k];
    sums[k].products += weight * visible_twice * now.innovation * then.innovation;
    sums[k].visible += weight * square(visible_twice);
    sums[k].variance += square(visible_twice);
  }
  if (past.empty() || time - past.back().time >= kInnovationSpacing) past.push_back(now);
}

void InnovationCorrelation::forget(double time)
{
  const double useful = time - kLongestLag * kInnovationLags.back();
  for (auto& [source, past] : past_)
    while (!past.empty() && past.front().time < useful) past.pop_front();
  std::erase_if(past_, [](const auto& entry) { return entry.second.empty(); });
}

PerDuration InnovationCorrelation::lastingShares(const ErrorKind& kind) const
{
  PerDuration shares{};
  const auto found = sums_.find(kind);
  if (found == sums_.end()) return shares;
  // What lasts for long is in the correlation over shorter times too.
  double longer = 0;
  for (std::size_t k = kInnovationLags.size(); k-- > 0;)
  {
    const Sums& sums = found->second[k];
    const double products = sums.products + kPriorLasting * kPriorPairs;
    const double covariance =
        significantPart(products, sums.variance + kPriorPairs, kByChance) / (sums.visible + kPriorPairs);
    shares[k] = std::clamp(covariance - longer, 0.0, kMostShare);
    longer += shares[k];
  }
  return shares;
}
}  // namespace mrpt_ext
