#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mrpt_ext/evaluation/error_statistics.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext::papers
{
/// Values of one quantity over trials.
class Sample
{
 public:
  void add(double value) { values_.push_back(value); }
  void add(const Sample& other) { values_.insert(values_.end(), other.values_.begin(), other.values_.end()); }

  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  [[nodiscard]] std::size_t count() const { return values_.size(); }
  [[nodiscard]] double mean() const { return errorStatistics(values_).mean.value_or(0); }
  [[nodiscard]] double spread() const { return errorStatistics(values_).std.value_or(0); }  ///< standard deviation
  [[nodiscard]] double rms() const { return std::hypot(mean(), spread()); }
  [[nodiscard]] double quantile(double share) const { return mrpt_ext::quantile(values_, share).value_or(0); }
  [[nodiscard]] double median() const { return quantile(0.5); }
  /// Share of the values for which `holds`.
  template <class Condition>
  [[nodiscard]] double share(Condition&& holds) const
  {
    const auto hits = std::count_if(values_.begin(), values_.end(), holds);
    return count() == 0 ? 0 : static_cast<double>(hits) / static_cast<double>(count());
  }

  /// "12.3 ± 4.5": mean and standard deviation.
  [[nodiscard]] std::string text(int decimals, double unit = 1) const
  {
    return fixedText(mean() / unit, decimals) + " ± " + fixedText(spread() / unit, decimals);
  }
  /// "12.3 (10.1 to 15.0)": median and what 90 % of the values lie in.
  [[nodiscard]] std::string medianText(int decimals, double unit = 1) const
  {
    return fixedText(median() / unit, decimals) + " (" + fixedText(quantile(0.05) / unit, decimals) + " to " +
           fixedText(quantile(0.95) / unit, decimals) + ")";
  }

 private:
  std::vector<double> values_;
};

/// A count of `trials` with the standard deviation of a repetition: "176 ± 11".
[[nodiscard]] inline std::string countText(double share, double trials)
{
  return fixedText(share * trials, 0) + " ± " + fixedText(std::sqrt(share * (1 - share) * trials), 0);
}

[[nodiscard]] inline std::string percent(double share, int decimals = 0)
{
  return fixedText(100 * share, decimals) + " %";
}
}  // namespace mrpt_ext::papers
