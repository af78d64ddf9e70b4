#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/front_ends/vision_front_end.h"

namespace mrpt_ext
{
/// Table of `--csv`: one row per measurement, a field that was not measured stays empty.
class MeasurementCsv
{
 public:
  void add(const ImageFrame& frame, const std::vector<MeasurementRow>& rows);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_ = "frame,time_s,sensor,label,azimuth_deg,std_azimuth_deg,range_m,std_range_m,u_left,u_right\n";
};
}  // namespace mrpt_ext
