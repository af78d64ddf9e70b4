#pragma once

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/relocalization/measurement_window.h"

namespace mrpt_ext
{
/// All readings of a robot that is not found yet and knows nothing but distances to landmarks it can tell apart: at
/// standstill they say nothing about its heading, and only all of them together place it. Ends for good when a reading
/// tells more than that, when odometry on the way has become less sure than the ranges, or when there are too many.
class RangeOnlyStart
{
 public:
  explicit RangeOnlyStart(const MotionModel& motion) : joiner_(kLongest, motion) {}

  void add(const Frame& frame);
  void end() { ended_ = true; }
  /// Seen from the newest frame; empty once it has ended or odometry is less sure.
  [[nodiscard]] std::vector<Reading> readings() const;

 private:
  static constexpr double kLongest = 120;          // [s]
  static constexpr std::size_t kMostRanges = 400;  // readings: each of them is scored for every particle

  MeasurementWindow joiner_;
  std::size_t ranges_ = 0;
  bool ended_ = false;
};
}  // namespace mrpt_ext
