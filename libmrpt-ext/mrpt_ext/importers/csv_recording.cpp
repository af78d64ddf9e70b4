#include "mrpt_ext/importers/csv_recording.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/importers/ordered_time.h"
#include "mrpt_ext/importers/reading_collector.h"
#include "mrpt_ext/importers/recording_notes.h"
#include "mrpt_ext/importers/truth_heading.h"
#include "mrpt_ext/importers/velocity_odometry.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

std::vector<OdometryRecord> readPoses(const TextTable& table)
{
  table.expectOnlyColumns({"t", "x", "y", "phi_deg"});
  const std::size_t t = table.column("t"), x = table.column("x"), y = table.column("y"), phi = table.column("phi_deg");
  std::vector<OdometryRecord> odometry;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const OdometryRecord record{
        orderedTime(table, row, t),
        {table.coordinate(row, x), table.coordinate(row, y), wrap(degToRad(table.number(row, phi)))}};
    // Of rows with one stamp the last one counts.
    if (!odometry.empty() && odometry.back().time == record.time) odometry.pop_back();
    odometry.push_back(record);
  }
  return odometry;
}

std::vector<OdometryRecord> readVelocities(const TextTable& table)
{
  table.expectOnlyColumns({"t", "v", "omega_deg_s"});
  const std::size_t t = table.column("t"), v = table.column("v"), omega = table.column("omega_deg_s");
  std::vector<VelocityRecord> velocities;
  for (std::size_t row = 0; row < table.size(); ++row)
    velocities.push_back({orderedTime(table, row, t), table.number(row, v), degToRad(table.number(row, omega))});
  return integrateVelocities(velocities);
}

void addOdometry(Recording& recording, const fs::path& path)
{
  const TextTable table(path, {});
  const bool velocities = table.findColumn("v") || table.findColumn("omega_deg_s");
  const std::vector<OdometryRecord> odometry = velocities ? readVelocities(table) : readPoses(table);
  recording.records.insert(recording.records.end(), odometry.begin(), odometry.end());
  noteCount(recording, table.size() - odometry.size(),
            "odometry rows share the stamp of the row before: the later one holds");
}

TextTable readDetectionRows(const fs::path& path)
{
  TextTable table(path, {});
  table.expectOnlyColumns(
      {"t", "sensor", "id", "category", "bearing_deg", "range_m", "std_bearing_deg", "std_range_m"});
  return table;
}

/// The rows of detections.csv.
class DetectionTable
{
 public:
  explicit DetectionTable(const fs::path& path) : table_(readDetectionRows(path)) {}

  [[nodiscard]] std::size_t size() const { return table_.size(); }
  [[nodiscard]] double time(std::size_t row) const { return orderedTime(table_, row, t_); }
  [[nodiscard]] const std::string& sensor(std::size_t row) const
  {
    if (table_.text(row, sensor_).empty()) throw table_.errorAt(row, "no sensor, expected its label");
    return table_.text(row, sensor_);
  }

  [[nodiscard]] Detection detection(std::size_t row) const
  {
    Detection detection;
    detection.id = id(row);
    detection.category = table_.text(row, category_);
    if (const auto degrees = checked(row, bearing_, -360, 360)) detection.bearing = wrap(degToRad(*degrees));
    detection.range = checked(row, range_, 0, kMost);
    if (!detection.bearing && !detection.range)
      throw table_.errorAt(row, "neither bearing_deg nor range_m, expected at least one of them");
    detection.std_bearing = degToRad(stdOf(row, std_bearing_, detection.bearing.has_value()));
    detection.std_range = stdOf(row, std_range_, detection.range.has_value());
    return detection;
  }

 private:
  static constexpr double kMost = 1e6;

  [[nodiscard]] int id(std::size_t row) const
  {
    if (table_.text(row, id_).empty()) return kNoId;
    const int id = table_.integer(row, id_);
    if (id < kNoId)
      throw table_.errorAt(row, "id " + table_.text(row, id_) + ", expected >= 0, or empty when not known");
    return id;
  }

  [[nodiscard]] std::optional<double> checked(std::size_t row, std::size_t column, double least, double most) const
  {
    const auto value = table_.optionalNumber(row, column);
    if (value && (*value < least || *value > most))
      throw table_.errorAt(row, table_.columns()[column] + ' ' + table_.text(row, column) +
                                    " is out of range, expected " + (most == kMost ? ">= 0" : "within +-360"));
    return value;
  }

  [[nodiscard]] double stdOf(std::size_t row, std::size_t column, bool needed) const
  {
    const auto value = table_.optionalNumber(row, column);
    if ((needed && !value) || (value && *value <= 0))
      throw table_.errorAt(row, table_.columns()[column] + " is '" + table_.text(row, column) +
                                    "', expected a standard deviation > 0 of a measurement");
    return value.value_or(0);
  }

  TextTable table_;
  std::size_t t_ = table_.column("t"), sensor_ = table_.column("sensor"), id_ = table_.column("id"),
              category_ = table_.column("category"), bearing_ = table_.column("bearing_deg"),
              range_ = table_.column("range_m"), std_bearing_ = table_.column("std_bearing_deg"),
              std_range_ = table_.column("std_range_m");
};

void addReadings(Recording& recording, const fs::path& path)
{
  const DetectionTable table(path);
  ReadingCollector collector;
  for (std::size_t row = 0; row < table.size(); ++row)
    collector.add(table.time(row), table.sensor(row), table.detection(row));
  recording.records.insert(recording.records.end(), collector.readings().begin(), collector.readings().end());
}
}  // namespace

CsvFiles findCsvFiles(const std::vector<fs::path>& inputs)
{
  if (inputs.size() == 1)
  {
    const fs::path& folder = inputs[0];
    if (!fs::is_directory(folder)) throw dataError(folder.string() + ": no such folder, expected landmarks.csv in it");
    const auto optional = [&](const char* name) { return fs::exists(folder / name) ? folder / name : fs::path(); };
    return {folder / "landmarks.csv", optional("odometry.csv"), folder / "detections.csv",
            optional("ground_truth.tum")};
  }
  if (inputs.size() != 3 && inputs.size() != 4)
    throw configurationError("csv: " + std::to_string(inputs.size()) +
                             " inputs, expected a folder or LANDMARKS ODOMETRY DETECTIONS [GROUND_TRUTH]");
  return {inputs[0], inputs[1], inputs[2], inputs.size() == 4 ? inputs[3] : fs::path()};
}

Recording importCsv(const CsvFiles& files)
{
  Recording recording;
  recording.map = readLandmarkCsv(files.landmarks);
  if (files.odometry.empty())
    recording.notes.emplace_back("no odometry.csv: the log has no odometry");
  else
    addOdometry(recording, files.odometry);
  addReadings(recording, files.detections);
  if (files.ground_truth.empty())
    recording.notes.emplace_back("no truth file");
  else
    recording.truth = readTum(files.ground_truth);
  sortByTime(recording);
  correctTruthHeading(recording);
  return recording;
}
}  // namespace mrpt_ext
