#pragma once

#include <array>
#include <cstddef>

#include "mrpt_ext/diagnosis/time_blocks.h"

namespace mrpt_ext
{
/// Innovations of one sensor, bearings or ranges, in units of their standard deviation.
class InnovationStatistics
{
 public:
  void add(double value);
  [[nodiscard]] double count() const { return count_; }
  /// Robust standard deviation, from the median of the absolute values; 1 for a consistent filter and without a value.
  [[nodiscard]] double scatter() const;

 private:
  static constexpr double kBin = 0.1, kLargest = 30;
  std::array<double, static_cast<std::size_t>(kLargest / kBin)> histogram_{};  // of the absolute values
  double count_ = 0;
};

/// Detections of one sensor that agree with no landmark, counted by blocks of time: false detections come in groups,
/// and then a share is less certain than independent ones would make it.
class OutlierStatistics
{
 public:
  void add(bool outlier);
  [[nodiscard]] double count() const { return all_.count; }
  [[nodiscard]] double share() const { return all_.count > 0 ? all_.outliers / all_.count : 0; }
  /// Standard error of the share; 1 with too few blocks.
  [[nodiscard]] double shareStd() const;

 private:
  struct Block
  {
    double count = 0, outliers = 0;

    Block& operator+=(const Block& other)
    {
      count += other.count;
      outliers += other.outliers;
      return *this;
    }
  };
  TimeBlocks<Block> blocks_{Block{}, 50};  // detections
  Block all_;
};
}  // namespace mrpt_ext
