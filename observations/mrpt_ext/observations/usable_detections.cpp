#include "mrpt_ext/observations/usable_detections.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mrpt_ext/geometry/physical_limits.h"

namespace mrpt_ext
{
namespace
{
bool isStd(double value) { return isCoordinate(value) && value >= 0; }

std::string whyRangeUnusable(double range, double std)
{
  if (!std::isfinite(range)) return "range not finite";
  if (range <= 0) return "range not positive";
  if (!isCoordinate(range)) return "range beyond any sensor";
  return isStd(std) ? "" : "range std negative or not finite";
}

std::string whyBearingUnusable(double bearing, double std)
{
  if (!std::isfinite(bearing)) return "bearing not finite";
  return isStd(std) ? "" : "bearing std negative or not finite";
}

std::string whyUnusable(const Detection& d)
{
  if (!d.bearing && !d.range) return "neither bearing nor range";
  const std::string range = d.range ? whyRangeUnusable(*d.range, d.std_range) : "";
  return !range.empty() || !d.bearing ? range : whyBearingUnusable(*d.bearing, d.std_bearing);
}

/// Finite, with standard deviations above zero and probabilities that are some.
bool isUsable(const Facing& facing)
{
  const auto usable = [](const Facing::Attitude& a)
  { return a.weight == 0 || (std::isfinite(a.yaw) && isStd(a.std) && a.std > 0 && a.weight > 0 && a.weight <= 1); };
  return std::all_of(facing.attitudes.begin(), facing.attitudes.end(), usable);
}
}  // namespace

void removeUnusable(Reading& reading, UnusableCounts& counts)
{
  std::vector<Detection> usable;
  for (Detection& d : reading.detections)
  {
    const std::string reason = whyUnusable(d);
    if (!reason.empty())
    {
      ++counts[reason];
      continue;
    }
    if (d.bearing) d.bearing = wrap(*d.bearing);
    if (d.facing && !isUsable(*d.facing))
    {
      ++counts["direction of a landmark not finite or without standard deviation"];
      d.facing.reset();
    }
    usable.push_back(std::move(d));
  }
  reading.detections = std::move(usable);
}

std::string whyUnusable(const RunningFixReading& fix)
{
  for (const std::string& reason :
       {whyRangeUnusable(fix.first_range, fix.first_std), whyRangeUnusable(fix.second_range, fix.second_std),
        fix.second_bearing ? whyBearingUnusable(*fix.second_bearing, fix.second_bearing_std) : std::string()})
    if (!reason.empty()) return reason;
  if (!isFinite(fix.displacement) || !fix.displacement_covariance.allFinite()) return "displacement not finite";
  if (!std::isfinite(fix.first_time)) return "time of the first range not finite";
  return "";
}
}  // namespace mrpt_ext
