#include "mrpt_ext/files/tum.h"

#include <cmath>

#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/text_table.h"

namespace mrpt_ext
{
namespace
{
constexpr double kUnitTolerance = 1e-2;  // files with four decimals are still unit quaternions

// Yaw of the quaternion in columns 4..7; nothing for 0 0 0 0.
std::optional<double> readYaw(const TextTable& table, std::size_t row)
{
  const double x = table.number(row, 4), y = table.number(row, 5), z = table.number(row, 6), w = table.number(row, 7);
  const double norm = std::sqrt(x * x + y * y + z * z + w * w);
  if (norm == 0) return std::nullopt;
  if (std::abs(norm - 1) > kUnitTolerance)
    throw table.errorAt(
        row, "quaternion has length " + shortestText(norm) + ", expected 1, or 0 0 0 0 where no heading is known");
  return std::atan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z);
}
}  // namespace

Trajectory readTum(const std::filesystem::path& path)
{
  const TextTable table(path, {Delimiter::white_space, "#", {"timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"}});
  Trajectory trajectory;
  trajectory.reserve(table.size());
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double time = table.number(row, 0);
    if (!trajectory.empty() && time <= trajectory.back().time)
      throw table.errorAt(row, "time " + table.text(row, 0) + " is not after the one before, expected ascending times");
    const std::optional<double> yaw = readYaw(table, row);
    static_cast<void>(table.number(row, 3));  // the height is checked, and not used in the plane
    trajectory.push_back({time, {table.number(row, 1), table.number(row, 2), yaw.value_or(0)}, yaw.has_value()});
  }
  return trajectory;
}

void writeTum(const std::filesystem::path& path, const Trajectory& trajectory)
{
  constexpr int kDecimals = 6, kQuaternionDecimals = 9;
  std::string content;
  for (const auto& [time, pose, heading_known] : trajectory)
  {
    const double half = wrap(pose.phi) / 2;  // half of (-pi, pi]: qw is never negative
    content += fixedText(time, kDecimals) + ' ' + fixedText(pose.x, kDecimals) + ' ' + fixedText(pose.y, kDecimals);
    content += " 0 0 0 ";  // tz qx qy
    content += heading_known ? fixedText(std::sin(half), kQuaternionDecimals) + ' ' +
                                   fixedText(std::cos(half), kQuaternionDecimals)
                             : "0 0";
    content += '\n';
  }
  writeFileAtomically(path, content);
}
}  // namespace mrpt_ext
