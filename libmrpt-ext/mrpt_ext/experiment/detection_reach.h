#pragma once

#include <cstddef>
#include <map>
#include <optional>

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// How far outside the map a robot may be, by the detections of its log: as far as they reach. A robot that is outside
/// the box of possible positions is found at a wrong place inside.
class DetectionReach
{
 public:
  void add(const Reading& reading);
  /// [m]: the 99 % quantile of the ranges (some are false), and where bearings come without ranges the range limit of
  /// their sensor; without one three times `map_diagonal` [m], from where bearings hardly tell the distance any more.
  /// Nothing without identified detections, or with anonymous ones: those fit by chance, the more often the larger the
  /// box.
  [[nodiscard]] std::optional<double> metres(double map_diagonal) const;

 private:
  [[nodiscard]] double rangeQuantile() const;

  std::map<int, std::size_t> ranges_;  // identified detections, by range in logarithmic bins
  std::size_t count_ = 0;              // of them
  double farthest_bearing_ = 0;        // [m] declared limit of those without range
  bool unlimited_ = false;             // ... or none is declared
  bool anonymous_ = false;
};
}  // namespace mrpt_ext
