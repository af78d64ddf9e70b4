#pragma once

#include <map>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// Finds frames that join two readings of one sensor, because it measures faster than `frame_window_s`.
class FrameWindowCheck
{
 public:
  void add(const Frame& frame);
  /// A line for each sensor that half of the frames join, with the command that helps.
  [[nodiscard]] std::vector<std::string> hints() const;

 private:
  struct Count
  {
    std::size_t frames = 0, joined = 0;
    double shortest = 0;  ///< [s] between two joined readings
  };
  std::map<std::string, Count> sensors_;
};
}  // namespace mrpt_ext
