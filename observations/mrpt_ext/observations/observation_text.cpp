#include "mrpt_ext/observations/observation_text.h"

#include <mrpt/poses/CPose3D.h>

#include <algorithm>
#include <cstdio>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
std::string decimalText(double value, int decimals)
{
  const int length = std::snprintf(nullptr, 0, "%.*f", decimals, value);
  std::string text(static_cast<std::size_t>(length) + 1, '\0');
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  text.pop_back();
  return text;
}

std::string decimalText(const std::optional<double>& value, int decimals)
{
  return value ? decimalText(*value, decimals) : "nan";
}

std::string textOrDash(const std::string& text)
{
  if (text.empty()) return "-";
  std::string word = text;
  std::replace_if(
      word.begin(), word.end(), [](char c) { return c == ' ' || c == '\t' || c == '\n'; }, '_');
  return word;
}

void describeSensor(std::ostream& out, const mrpt::poses::CPose3D& pose, double field_of_view, double max_range)
{
  out << "Sensor pose on the robot: " << pose.asString() << '\n';
  if (field_of_view > 0) out << "Field of view: " << decimalText(radToDeg(field_of_view), 2) << " deg\n";
  if (max_range > 0) out << "Maximum range: " << decimalText(max_range, 3) << " m\n";
}

std::string numberedHeader(const std::vector<std::string>& names) { return 'N' + numberedNames(names); }

std::string numberedNames(const std::vector<std::string>& names)
{
  std::string header;
  for (std::size_t i = 1; i <= kExportedDetections; ++i)
    for (const std::string& name : names) header += ' ' + name + '_' + std::to_string(i);
  return header;
}

std::string numberedRow(std::size_t count, std::size_t columns,
                        const std::function<std::vector<std::string>(std::size_t)>& cells)
{
  return std::to_string(count) + numberedCells(count, columns, cells);
}

std::string numberedCells(std::size_t count, std::size_t columns,
                          const std::function<std::vector<std::string>(std::size_t)>& cells)
{
  std::string row;
  for (std::size_t i = 0; i < kExportedDetections; ++i)
    for (const std::string& cell : i < count ? cells(i) : std::vector<std::string>(columns, "nan")) row += ' ' + cell;
  return row;
}
}  // namespace mrpt_ext
