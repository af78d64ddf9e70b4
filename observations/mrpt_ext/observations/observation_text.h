#pragma once

#include <mrpt/poses/poses_frwds.h>

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

/// Shared by the text forms of our observations.
namespace mrpt_ext
{
/// Detections written by exportTxt*: the format allows one row per observation with a fixed number of columns.
inline constexpr std::size_t kExportedDetections = 8;

[[nodiscard]] std::string decimalText(double value, int decimals);
[[nodiscard]] std::string decimalText(const std::optional<double>& value, int decimals);  ///< "nan" without a value
[[nodiscard]] std::string textOrDash(const std::string& text);                            ///< blanks become '_'

/// Sensor pose and, where declared (not 0), field of view [rad] and maximum range [m].
void describeSensor(std::ostream& out, const mrpt::poses::CPose3D& pose, double field_of_view, double max_range);

/// "N a_1 b_1 ... a_2 b_2 ...": the column names for kExportedDetections detections.
[[nodiscard]] std::string numberedHeader(const std::vector<std::string>& names);
/// " a_1 b_1 ... a_2 b_2 ...": more columns at its end.
[[nodiscard]] std::string numberedNames(const std::vector<std::string>& names);

/// Data row to numberedHeader: `cells(i)` gives the columns of detection i; absent detections are "nan".
[[nodiscard]] std::string numberedRow(std::size_t count, std::size_t columns,
                                      const std::function<std::vector<std::string>(std::size_t)>& cells);
/// The same without the number: the cells to numberedNames().
[[nodiscard]] std::string numberedCells(std::size_t count, std::size_t columns,
                                        const std::function<std::vector<std::string>(std::size_t)>& cells);
}  // namespace mrpt_ext
