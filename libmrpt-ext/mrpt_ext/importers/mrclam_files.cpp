#include "mrpt_ext/importers/mrclam_files.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

std::string robotFile(int robot, const std::string& content)
{
  return "Robot" + std::to_string(robot) + "_" + content + ".dat";
}

std::optional<TextTable> readIfPresent(const fs::path& path, const TextTableFormat& format)
{
  const auto found = findPlainOrGzipped(path);
  if (!found) return std::nullopt;
  return TextTable(*found, format);
}

TextTable read(const fs::path& path, const std::vector<std::string>& columns)
{
  return TextTable(findPlainOrGzipped(path).value_or(path), {Delimiter::white_space, "#", columns});
}

/// The rows of `table`, each made into a Row with a time, in the order of time.
template <typename Row, typename Make>
std::vector<Row> orderedRows(const TextTable& table, std::vector<std::string>& notes, const Make& make)
{
  std::vector<Row> rows;
  rows.reserve(table.size());
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    rows.push_back(make(row));
    if (row > 0 && table.number(row, 0) < table.number(row - 1, 0))
      notes.push_back(std::string("warning: ") +
                      table.errorAt(row, "time goes back to " + table.text(row, 0) + ", rows were sorted").what());
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& l, const Row& r) { return l.time < r.time; });
  return rows;
}
}  // namespace

LandmarkTable readMrclamLandmarks(const fs::path& folder)
{
  const TextTable table = read(folder / "Landmark_Groundtruth.dat", {"subject", "x", "y", "x_std_dev", "y_std_dev"});
  std::vector<Landmark> landmarks;
  std::set<int> seen;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const int subject = table.integer(row, 0);
    if (subject < 0 || !seen.insert(subject).second)
      throw table.errorAt(row, "subject " + table.text(row, 0) + " is negative or occurs twice");
    landmarks.push_back({subject,
                         {table.number(row, 1), table.number(row, 2), 0},
                         kMrclamCategory,
                         {table.number(row, 3), table.number(row, 4)}});
  }
  return LandmarkTable(std::move(landmarks));
}

std::map<int, int> readMrclamBarcodes(const fs::path& folder)
{
  const TextTable table = read(folder / "Barcodes.dat", {"subject", "barcode"});
  std::map<int, int> subject_by_barcode;
  for (std::size_t row = 0; row < table.size(); ++row)
    if (!subject_by_barcode.emplace(table.integer(row, 1), table.integer(row, 0)).second)
      throw table.errorAt(row, "barcode " + table.text(row, 1) + " occurs twice, expected one subject per barcode");
  return subject_by_barcode;
}

std::vector<MrclamMeasurement> readMrclamMeasurements(const fs::path& folder, int robot,
                                                      std::vector<std::string>& notes)
{
  const TextTable table = read(folder / robotFile(robot, "Measurement"), {"time", "barcode", "range", "bearing"});
  return orderedRows<MrclamMeasurement>(
      table, notes,
      [&](std::size_t row)
      {
        const MrclamMeasurement measurement{table.number(row, 0), table.integer(row, 1), table.number(row, 2),
                                            table.number(row, 3)};
        if (measurement.range <= 0) throw table.errorAt(row, "range " + table.text(row, 2) + " m, expected > 0");
        if (std::abs(measurement.bearing) > kPi)
          throw table.errorAt(row, "bearing " + table.text(row, 3) + ", expected radians in [-pi, pi]");
        return measurement;
      });
}

std::optional<std::vector<VelocityRecord>> readMrclamVelocities(const fs::path& folder, int robot,
                                                                std::vector<std::string>& notes)
{
  const auto table = readIfPresent(folder / robotFile(robot, "Odometry"),
                                   {Delimiter::white_space, "#", {"time", "forward_velocity", "angular_velocity"}});
  if (!table) return std::nullopt;
  return orderedRows<VelocityRecord>(
      *table, notes,
      [&](std::size_t row) {
        return VelocityRecord{table->number(row, 0), table->number(row, 1), table->number(row, 2)};
      });
}

std::optional<Trajectory> readMrclamTruth(const fs::path& folder, int robot, std::vector<std::string>& notes)
{
  const auto table = readIfPresent(folder / robotFile(robot, "Groundtruth"),
                                   {Delimiter::white_space, "#", {"time", "x", "y", "orientation"}});
  if (!table) return std::nullopt;
  Trajectory truth = orderedRows<TimedPose>(
      *table, notes,
      [&](std::size_t row)
      {
        const Pose2 pose{table->coordinate(row, 1), table->coordinate(row, 2), wrap(table->number(row, 3))};
        return TimedPose{table->number(row, 0), pose, true};
      });
  const auto twice = std::adjacent_find(truth.begin(), truth.end(),
                                        [](const TimedPose& l, const TimedPose& r) { return l.time == r.time; });
  if (twice != truth.end())
    throw dataError(table->path().string() + ": time " + fixedText(twice->time, 3) +
                    " occurs twice, expected one pose per time");
  return truth;
}

std::optional<Trajectory> readMrclamSparseTruth(const fs::path& folder, int robot)
{
  constexpr double kFileTicks = 1e6;  ///< [1/s] times that are closer are equal in the file that is written of them
  const auto table = readIfPresent(folder / "GroundtruthSparse.csv", {});
  if (!table) return std::nullopt;
  const std::size_t robot_column = table->column("robot"), begin = table->column("t_begin"),
                    end = table->column("t_end"), x = table->column("x_m"), y = table->column("y_m"),
                    theta = table->column("theta_rad");
  Trajectory truth;
  for (std::size_t row = 0; row < table->size(); ++row)
  {
    if (table->integer(row, robot_column) != robot) continue;
    const double from = table->number(row, begin), to = table->number(row, end);
    if (to < from) throw table->errorAt(row, "t_end is before t_begin, expected t_begin <= t_end");
    truth.push_back({std::round((from + to) / 2 * kFileTicks) / kFileTicks,
                     {table->number(row, x), table->number(row, y), wrap(table->number(row, theta))},
                     true});
  }
  // Intervals may overlap or contain each other, so their middles need not be in order.
  std::stable_sort(truth.begin(), truth.end(), [](const TimedPose& l, const TimedPose& r) { return l.time < r.time; });
  truth.erase(
      std::unique(truth.begin(), truth.end(), [](const TimedPose& l, const TimedPose& r) { return l.time == r.time; }),
      truth.end());
  return truth;
}
}  // namespace mrpt_ext
