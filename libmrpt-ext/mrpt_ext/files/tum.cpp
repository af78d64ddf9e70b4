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
  Trajectory trajectory;
  const auto add = [&](const TextTable& table)
  {
    const double time = table.number(0, 0);
    if (!trajectory.empty() && time <= trajectory.back().time)
      throw table.errorAt(0, "time " + table.text(0, 0) + " is not after the one before, expected ascending times");
    const std::optional<double> yaw = readYaw(table, 0);
    static_cast<void>(table.number(0, 3));  // the height is checked, and not used in the plane
    trajectory.push_back({time, {table.coordinate(0, 1), table.coordinate(0, 2), yaw.value_or(0)}, yaw.has_value()});
  };
  forEachRow(path, {Delimiter::white_space, "#", {"timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"}}, add);
  trajectory.shrink_to_fit();
  return trajectory;
}

std::string tumRow(const TimedPose& entry)
{
  constexpr int kDecimals = 6, kQuaternionDecimals = 9;
  const double half = wrap(entry.pose.phi) / 2;  // half of (-pi, pi]: qw is never negative
  std::string row = fixedText(entry.time, kDecimals) + ' ' + fixedText(entry.pose.x, kDecimals) + ' ' +
                    fixedText(entry.pose.y, kDecimals) + " 0 0 0 ";  // tz qx qy
  row += entry.heading_known
             ? fixedText(std::sin(half), kQuaternionDecimals) + ' ' + fixedText(std::cos(half), kQuaternionDecimals)
             : "0 0";
  return row + '\n';
}

void writeTum(const std::filesystem::path& path, const Trajectory& trajectory)
{
  writeFileAtomically(path,
                      [&](const TextSink& write)
                      {
                        for (const TimedPose& entry : trajectory) write(tumRow(entry));
                      });
}
}  // namespace mrpt_ext
