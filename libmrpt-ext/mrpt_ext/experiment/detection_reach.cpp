#include "mrpt_ext/experiment/detection_reach.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr double kWindow = 3;      // [s] in which the robot hardly moves, and each radio answers
constexpr double kHolds = 0.2;     // quantile of the limits of a window
constexpr double kWindows = 0.99;  // quantile over the windows
constexpr double kBinsPerOctave = 8;
constexpr double kLeast = 1e-3;   // [m] that is told from 0
constexpr double kDiagonals = 3;  // of the map

int binOf(double limit) { return static_cast<int>(std::ceil(kBinsPerOctave * std::log2(std::max(limit, kLeast)))); }
}  // namespace

void DetectionReach::add(const Frame& frame, const LandmarkTable& map)
{
  if (!limits_[0].empty() && std::abs(frame.time - begin_) > kWindow)
  {
    ++windows_[binOf(farthest(limits_))];
    ++count_;
    limits_ = {};
  }
  if (limits_[0].empty()) begin_ = frame.time;
  for (const Reading& reading : frame.readings)
    for (const Detection& detection : reading.detections) add(detection, reading.model, map);
}

void DetectionReach::add(const Detection& detection, const SensorModel& model, const LandmarkTable& map)
{
  anonymous_ = anonymous_ || detection.id == kNoId;
  const auto landmark = map.indexOf(detection.id);
  if (!landmark) return;
  if (!box_) box_ = map.boundingBox();
  const auto& [low, high] = *box_;
  if (!detection.range)
  {
    of_bearings_ = std::max(of_bearings_, model.max_range.value_or(kDiagonals * (high - low).norm()));
    return;
  }
  const Vector2d place = map[*landmark].position.head<2>();
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const auto k = static_cast<Eigen::Index>(axis);
    limits_[2 * axis].push_back(*detection.range - (place[k] - low[k]));
    limits_[2 * axis + 1].push_back(*detection.range - (high[k] - place[k]));
  }
}

double DetectionReach::farthest(const Limits& limits)
{
  double most = 0;
  for (const std::vector<double>& side : limits) most = std::max(most, quantile(side, kHolds).value_or(0));
  return most;
}

double DetectionReach::metres() const
{
  if (anonymous_) return 0;
  if (count_ == 0) return std::max(of_bearings_, farthest(limits_));  // a log of less than a window
  std::size_t below = 0;
  for (const auto& [bin, count] : windows_)
  {
    below += count;
    if (static_cast<double>(below) >= kWindows * static_cast<double>(count_))
      return std::max(of_bearings_, std::exp2(bin / kBinsPerOctave));
  }
  return of_bearings_;
}
}  // namespace mrpt_ext
