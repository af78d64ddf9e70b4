#pragma once

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/relocalization/measurement_window.h"

namespace mrpt_ext
{
/// All readings since the start, for initialization from identified ranges alone: at standstill they do not determine
/// the heading, and only together they determine the pose. Ends for good with any other type of measurement, after 120
/// s, or with too many readings.
class RangeOnlyStart
{
 public:
  explicit RangeOnlyStart(const MotionModel& motion) : window_(kLongest, motion) {}

  void add(const Frame& frame);
  /// Called when the pose is determined.
  void end() { ended_ = true; }
  /// Propagated to the newest frame; empty after the end, and while the odometry is less accurate than the ranges.
  [[nodiscard]] std::vector<Reading> readings() const;

 private:
  static constexpr double kLongest = 120;                                // [s]
  static constexpr std::size_t kMostReadings = 400, kMostRanges = 4000;  // each is scored for every particle

  MeasurementWindow window_;
  std::size_t reading_count_ = 0, range_count_ = 0;
  bool ended_ = false;
};
}  // namespace mrpt_ext
