#include "mrpt_ext/front_ends/measurement_csv.h"

#include <algorithm>

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

/// Both attitudes, the second with its probability where there is one.
void append(std::string& line, const std::optional<Facing>& facing)
{
  const double per_degree = radToDeg(1.0);
  for (std::size_t k = 0; k < 2; ++k)
  {
    const bool seen = facing && facing->attitudes[k].weight > 0;
    append(line, seen ? std::optional(facing->attitudes[k].yaw) : std::nullopt, per_degree);
    append(line, seen ? std::optional(facing->attitudes[k].std) : std::nullopt, per_degree);
    if (k == 1) append(line, seen ? std::optional(facing->attitudes[k].weight) : std::nullopt);
  }
}
}  // namespace

void MeasurementCsv::add(const ImageFrame& frame, const std::vector<MeasurementRow>& rows)
{
  const double per_degree = radToDeg(1.0);
  for (const MeasurementRow& row : rows)
  {
    std::string text;
    text.append(std::to_string(frame.number)).append(",").append(shortestText(frame.time));
    text.append(",").append(row.sensor).append(",").append(row.label);
    append(text, row.azimuth, per_degree);
    append(text, row.std_azimuth, per_degree);
    for (const auto& value : {row.range, row.std_range, row.u_left, row.u_right}) append(text, value);
    lines_.push_back({std::move(text), row.facing});
  }
}

std::string MeasurementCsv::text() const
{
  const bool faces =
      std::any_of(lines_.begin(), lines_.end(), [](const Line& line) { return line.facing.has_value(); });
  std::string text = "frame,time_s,sensor,label,azimuth_deg,std_azimuth_deg,range_m,std_range_m,u_left,u_right";
  text += faces ? ",yaw_deg,std_yaw_deg,other_yaw_deg,other_std_yaw_deg,other_weight\n" : "\n";
  for (const Line& line : lines_)
  {
    text += line.measured;
    if (faces) append(text, line.facing);
    text += '\n';
  }
  return text;
}
}  // namespace mrpt_ext
