#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/front_ends/vision_front_end.h"

namespace mrpt_ext
{
/// Table of `--csv`: one row per measurement, a field that was not measured stays empty. The columns of facings are
/// there when one was measured.
class MeasurementCsv
{
 public:
  void add(const ImageFrame& frame, const std::vector<MeasurementRow>& rows);
  [[nodiscard]] std::string text() const;

 private:
  struct Line
  {
    std::string measured;
    std::optional<Facing> facing;
  };
  std::vector<Line> lines_;
};
}  // namespace mrpt_ext
