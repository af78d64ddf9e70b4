#pragma once

#include <map>
#include <optional>
#include <string>

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// The most recent ranges of the log: they show whether the ranges of a running fix are logged one by one as well and
/// must not be counted twice.
class LoggedRanges
{
 public:
  static constexpr double kSameTime = 1e-3;  ///< [s]

  /// `span` [s]: longest time between the two ranges of a fix. Nothing: there are no fixes, nothing is kept.
  explicit LoggedRanges(std::optional<double> span) : span_(span) {}

  void add(const Reading& reading);
  /// True when a range to its landmark at one of its own times was logged, under its own label or, where an app writes
  /// fixes under another one, with its own value.
  [[nodiscard]] bool holds(const RunningFixReading& fix) const;
  /// Later calls concern fixes after `time` only.
  void forgetBefore(double time);

 private:
  struct LoggedRange
  {
    std::string sensor;
    double range;
  };
  [[nodiscard]] bool holds(const RunningFixReading& fix, double time, double range) const;

  std::optional<double> span_;
  std::map<int, std::multimap<double, LoggedRange>> ranges_;  // by landmark and time
};
}  // namespace mrpt_ext
