#include "mrpt_ext/importers/labyrinth.h"

#include <cmath>
#include <map>

#include "mrpt_ext/importers/ordered_time.h"
#include "mrpt_ext/importers/range_field.h"
#include "mrpt_ext/importers/reading_collector.h"
#include "mrpt_ext/importers/recording_notes.h"
#include "mrpt_ext/importers/run_files.h"
#include "mrpt_ext/importers/velocity_odometry.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

const RunFileName kInput{"", "_Input.txt"}, kTruth{"", "_GT.txt"};
const std::string kRangeRow = "range2", kWheelRow = "odom2diff", kTruthRow = "point2";

TextTable readRanges(const fs::path& path)
{
  return TextTable(path, {Delimiter::white_space,
                          "#",
                          {"type", "time", "range", "variance", "x", "y", "module", "snr"},
                          {kRangeRow, {kWheelRow}}});
}

TextTable readWheels(const fs::path& path)
{
  return TextTable(path, {Delimiter::white_space,
                          "#",
                          {"type", "time", "v_1", "v_2", "v_y", "half_axle", "variance_1", "variance_2", "variance_y"},
                          {kWheelRow, {kRangeRow}}});
}

void addOdometry(Recording& recording, const fs::path& path)
{
  const TextTable table = readWheels(path);
  std::vector<VelocityRecord> velocities;
  std::size_t sideways = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double left = table.number(row, 2), right = table.number(row, 3), half_axle = table.number(row, 5);
    if (!(half_axle > 0)) throw table.errorAt(row, "half_axle " + table.text(row, 5) + ", expected > 0 m");
    sideways += table.number(row, 4) != 0;
    velocities.push_back({orderedTime(table, row, 1), (left + right) / 2, (right - left) / (2 * half_axle)});
  }
  const std::vector<OdometryRecord> odometry = integrateVelocities(velocities);
  recording.records.insert(recording.records.end(), odometry.begin(), odometry.end());
  noteCount(recording, velocities.size(), "rows of wheel speeds");
  noteCount(recording, sideways, "speeds to the side dropped: the robot has two wheels");
  noteCount(recording, velocities.size() - odometry.size(),
            "rows of wheel speeds share the stamp of the row before: the later one holds");
}

/// The positions of the modules, which every row of ranges repeats.
LandmarkTable readModules(const TextTable& table)
{
  std::map<int, Landmark> modules;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const int id = table.integer(row, 6);
    const Vector3d position(table.number(row, 4), table.number(row, 5), 0);
    const auto [module, is_new] = modules.try_emplace(id, Landmark{id, position, kLabyrinthCategory, {0, 0}});
    if (!is_new && module->second.position != position)
      throw table.errorAt(row,
                          "module " + table.text(row, 6) + " has another position than before, expected fixed modules");
  }
  std::vector<Landmark> landmarks;
  for (const auto& [id, landmark] : modules) landmarks.push_back(landmark);
  return LandmarkTable(std::move(landmarks));
}

void addRanges(Recording& recording, const TextTable& table)
{
  Reading prototype;
  prototype.horizontal_range = true;
  ReadingCollector collector(prototype);
  std::size_t unanswered = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double time = orderedTime(table, row, 1), variance = table.number(row, 3);
    if (!(variance > 0)) throw table.errorAt(row, "variance " + table.text(row, 3) + ", expected > 0 m^2");
    if (const auto range = radioRange(table, row, 2, kLabyrinthMostRange))
      collector.add(time, kLabyrinthSensor,
                    {table.integer(row, 6), kLabyrinthCategory, std::nullopt, *range, 0, std::sqrt(variance)});
    else
      ++unanswered;
  }
  recording.records.insert(recording.records.end(), collector.readings().begin(), collector.readings().end());
  noteCount(recording, table.size(), "rows of ranges");
  noteCount(recording, unanswered, "ranges of 0 dropped");
}

void addTruth(Recording& recording, const fs::path& path)
{
  if (!fs::exists(path))
  {
    recording.notes.emplace_back("no truth file");
    return;
  }
  const TextTable table(
      path, {Delimiter::white_space, "#", {"type", "time", "x", "y", "cxx", "cxy", "cyx", "cyy"}, {kTruthRow, {}}});
  for (std::size_t row = 0; row < table.size(); ++row)
    recording.truth.push_back({ascendingTime(table, row, 1), {table.number(row, 2), table.number(row, 3), 0}, false});
  recording.notes.emplace_back("truth has no heading");
}
}  // namespace

Recording importLabyrinth(const fs::path& input)
{
  const RunFiles run = chooseRun(input, kInput);
  Recording recording;
  const TextTable ranges = readRanges(run.file(kInput));
  recording.map = readModules(ranges);
  addOdometry(recording, run.file(kInput));
  addRanges(recording, ranges);
  addTruth(recording, run.file(kTruth));
  sortByTime(recording);
  return recording;
}
}  // namespace mrpt_ext
