#include "mrpt_ext/importers/odometry_lag.h"

#include <algorithm>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/formatted.h"

namespace mrpt_ext
{
std::optional<OdometryLag> odometryLag(const std::vector<double>& odometry, const std::vector<double>& readings)
{
  OdometryLag lag;
  std::vector<double> ages;
  for (const double time : readings)
  {
    const auto later = std::upper_bound(odometry.begin(), odometry.end(), time);
    if (later == odometry.begin())
      ++lag.before;
    else
      ages.push_back(time - *std::prev(later));
    lag.after += !odometry.empty() && time > odometry.back();
  }
  if (ages.empty()) return std::nullopt;
  std::sort(ages.begin(), ages.end());
  lag.median = ages[ages.size() / 2];
  lag.largest = ages.back();
  return lag;
}

std::string describe(const OdometryLag& lag)
{
  std::string text = "at a reading the newest odometry is " + fixedText(lag.median, 3) + " s old (median), " +
                     fixedText(lag.largest, 3) + " s at most";
  if (lag.before > 0) text += "; " + countOf(lag.before, "reading") + " before the first odometry";
  if (lag.after > 0) text += "; " + countOf(lag.after, "reading") + " after the last odometry";
  return text;
}
}  // namespace mrpt_ext
