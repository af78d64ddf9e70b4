#include "mrpt_ext/front_ends/measurement_csv.h"

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr int kDecimals = 4;

void append(std::string& line, const std::optional<double>& value, double unit = 1)
{
  line += ',';
  if (value) line += fixedText(*value * unit, kDecimals);
}
}  // namespace

void MeasurementCsv::add(const ImageFrame& frame, const std::vector<MeasurementRow>& rows)
{
  const double per_degree = radToDeg(1.0);
  for (const MeasurementRow& row : rows)
  {
    text_.append(std::to_string(frame.number)).append(",").append(shortestText(frame.time));
    text_.append(",").append(row.sensor).append(",").append(row.label);
    append(text_, row.azimuth, per_degree);
    append(text_, row.std_azimuth, per_degree);
    for (const auto& value : {row.range, row.std_range, row.u_left, row.u_right}) append(text_, value);
    text_ += '\n';
  }
}
}  // namespace mrpt_ext
