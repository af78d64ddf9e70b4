#include "mrpt_ext/files/mrpt_index_truth.h"

#include <cmath>

#include "mrpt_ext/files/text_table.h"

namespace mrpt_ext
{
namespace
{
// Some MRPT tools write the step as a floating-point number.
int readStep(const TextTable& table, std::size_t row)
{
  const double step = table.number(row, 0);
  if (step < 0 || step > 1e9 || step != std::floor(step))
    throw table.errorAt(row, "'" + table.text(row, 0) + "' is not a step number, expected a whole number >= 0");
  return static_cast<int>(step);
}
}  // namespace

std::map<int, Pose2> readMrptIndexTruth(const std::filesystem::path& path, const Pose2& T_map_file)
{
  const TextTable table(path, {Delimiter::white_space, "%", {"step", "x", "y", "phi"}});
  std::map<int, Pose2> poses;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const int step = readStep(table, row);
    if (!poses.empty() && step <= poses.rbegin()->first)
      throw table.errorAt(row, "step " + std::to_string(step) + " is not after the one before, expected ascending");
    poses[step] = compose(T_map_file, {table.coordinate(row, 1), table.coordinate(row, 2), table.number(row, 3)});
  }
  return poses;
}
}  // namespace mrpt_ext
