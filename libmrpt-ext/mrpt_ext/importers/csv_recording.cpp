#include "mrpt_ext/importers/csv_recording.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/files/landmark_map_file.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/geometry/formatted.h"
#include "mrpt_ext/importers/ordered_time.h"
#include "mrpt_ext/importers/reading_collector.h"
#include "mrpt_ext/importers/recording_notes.h"
#include "mrpt_ext/importers/scan_table.h"
#include "mrpt_ext/importers/sensor_poses.h"
#include "mrpt_ext/importers/truth_heading.h"
#include "mrpt_ext/importers/velocity_odometry.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

constexpr double kMostSteering = 1.5;      ///< [rad]
constexpr double kLeastWheelSpeed = 0.05;  ///< of the wheel that measures the speed, as a share of the axle's

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

/// A car turns about a point on the line of its rear axle.
std::vector<OdometryRecord> readSteering(const TextTable& table, const CsvFiles& files)
{
  table.expectOnlyColumns({"t", "speed_m_s", "steering_rad"});
  if (!files.wheelbase)
    throw configurationError(table.path().string() +
                             ": steering_rad needs the distance of the axles, set --wheelbase M");
  const std::size_t t = table.column("t"), speed = table.column("speed_m_s"), steering = table.column("steering_rad");
  std::vector<VelocityRecord> velocities;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double angle = table.number(row, steering);
    if (std::abs(angle) > kMostSteering)
      throw table.errorAt(row, "steering_rad " + table.text(row, steering) + ", expected radians within +-1.5");
    const double curvature = std::tan(angle) / *files.wheelbase;
    // A wheel nearer to the centre of the turn is slower than the middle of the axle.
    const double slower = 1 - curvature * files.wheel_offset;
    if (slower < kLeastWheelSpeed)
      throw table.errorAt(row, "steering_rad " + table.text(row, steering) +
                                   " puts the centre of the turn at the wheel of --wheel-offset");
    const double forward = table.number(row, speed) / slower;
    velocities.push_back({orderedTime(table, row, t), forward, forward * curvature});
  }
  return integrateVelocities(velocities);
}

void addOdometry(Recording& recording, const CsvFiles& files)
{
  const TextTable table(files.odometry, {});
  const bool velocities = table.findColumn("v") || table.findColumn("omega_deg_s");
  const bool steering = table.findColumn("steering_rad") || table.findColumn("speed_m_s");
  if ((files.wheelbase || files.wheel_offset != 0) && !steering)
    throw configurationError(std::string(files.wheelbase ? "--wheelbase: " : "--wheel-offset: ") +
                             files.odometry.string() + " has no column steering_rad");
  const std::vector<OdometryRecord> odometry = steering     ? readSteering(table, files)
                                               : velocities ? readVelocities(table)
                                                            : readPoses(table);
  recording.records.insert(recording.records.end(), odometry.begin(), odometry.end());
  noteCount(recording, table.size() - odometry.size(),
            "odometry rows share the stamp of the row before: the later one holds");
}

TextTable readDetectionRows(const fs::path& path)
{
  TextTable table(path, {});
  table.expectOnlyColumns({"t", "sensor", "id", "category", "bearing_deg", "range_m", "std_bearing_deg", "std_range_m",
                           "yaw_deg", "std_yaw_deg", "other_yaw_deg", "other_std_yaw_deg", "other_weight"});
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
    if (category_) detection.category = table_.text(row, *category_);
    if (const auto degrees = checked(row, bearing_, -360, 360)) detection.bearing = wrap(degToRad(*degrees));
    detection.range = checked(row, range_, 0, kMost);
    if (!detection.bearing && !detection.range)
      throw table_.errorAt(row, "neither bearing_deg nor range_m, expected at least one of them");
    detection.std_bearing = degToRad(stdOf(row, std_bearing_, detection.bearing.has_value()));
    detection.std_range = stdOf(row, std_range_, detection.range.has_value());
    detection.facing = facing(row);
    return detection;
  }

 private:
  static constexpr double kMost = 1e6;

  [[nodiscard]] int id(std::size_t row) const
  {
    if (!id_ || table_.text(row, *id_).empty()) return kNoId;
    const int id = table_.integer(row, *id_);
    if (id < kNoId)
      throw table_.errorAt(row, "id " + table_.text(row, *id_) + ", expected >= 0, or empty when not known");
    return id;
  }

  /// Of the landmark, one attitude or two.
  [[nodiscard]] std::optional<Facing> facing(std::size_t row) const
  {
    const auto yaw = checked(row, yaw_, -360, 360), other = checked(row, other_yaw_, -360, 360);
    const double std = degToRad(stdOf(row, std_yaw_, yaw.has_value()));
    const double other_std = degToRad(stdOf(row, other_std_yaw_, other.has_value()));
    if (!yaw && other) throw table_.errorAt(row, "other_yaw_deg without yaw_deg, expected both or neither");
    if (!yaw) return std::nullopt;
    if (!other) return Facing::single(degToRad(*yaw), std);
    const auto weight = other_weight_ ? table_.optionalNumber(row, *other_weight_) : std::nullopt;
    if (!weight || *weight < 0 || *weight > 1)
      throw table_.errorAt(row, "other_weight is missing or no probability, expected 0 to 1 beside other_yaw_deg");
    return Facing::either({degToRad(*yaw), std}, {degToRad(*other), other_std}, *weight);
  }

  [[nodiscard]] std::optional<double> checked(std::size_t row, std::optional<std::size_t> column, double least,
                                              double most) const
  {
    if (!column) return std::nullopt;
    const auto value = table_.optionalNumber(row, *column);
    if (value && (*value < least || *value > most))
      throw table_.errorAt(row, table_.columns()[*column] + ' ' + table_.text(row, *column) +
                                    " is out of range, expected " + (most == kMost ? ">= 0" : "within +-360"));
    return value;
  }

  [[nodiscard]] double stdOf(std::size_t row, std::optional<std::size_t> column, bool needed) const
  {
    if (!column) return 0;
    const auto value = table_.optionalNumber(row, *column);
    if ((needed && !value) || (value && *value <= 0))
      throw table_.errorAt(row, table_.columns()[*column] + " is '" + table_.text(row, *column) +
                                    "', expected a standard deviation > 0 of a measurement");
    return value.value_or(0);
  }

  /// The column of the standard deviations, which a column of measurements needs.
  [[nodiscard]] std::optional<std::size_t> stdColumn(std::optional<std::size_t> measurement,
                                                     std::string_view name) const
  {
    return measurement ? table_.column(name) : table_.findColumn(name);
  }

  TextTable table_;
  std::size_t t_ = table_.column("t"), sensor_ = table_.column("sensor");
  std::optional<std::size_t> id_ = table_.findColumn("id"), category_ = table_.findColumn("category"),
                             bearing_ = table_.findColumn("bearing_deg"), range_ = table_.findColumn("range_m"),
                             std_bearing_ = stdColumn(bearing_, "std_bearing_deg"),
                             std_range_ = stdColumn(range_, "std_range_m"), yaw_ = table_.findColumn("yaw_deg"),
                             other_yaw_ = table_.findColumn("other_yaw_deg"), std_yaw_ = stdColumn(yaw_, "std_yaw_deg"),
                             other_std_yaw_ = stdColumn(other_yaw_, "other_std_yaw_deg"),
                             other_weight_ = table_.findColumn("other_weight");
};

void addReadings(Recording& recording, const fs::path& path)
{
  const DetectionTable table(path);
  ReadingCollector collector;
  for (std::size_t row = 0; row < table.size(); ++row)
    collector.add(table.time(row), table.sensor(row), table.detection(row));
  recording.records.insert(recording.records.end(), collector.readings().begin(), collector.readings().end());
}

void addScans(Recording& recording, const fs::path& path, const std::map<std::string, SensorPose>& sensors)
{
  for (RangeScan& scan : readScanTable(path, sensors)) recording.records.emplace_back(std::move(scan));
}

void setBase(Recording& recording, const CsvFiles& files, const std::map<std::string, SensorPose>& sensors)
{
  if (files.base.empty()) return;
  const auto base = sensors.find(files.base);
  if (base == sensors.end())
    throw configurationError(
        "--base " + files.base + ": " +
        (files.sensors.empty() ? "there is no sensors.csv" : files.sensors.string() + " has no such sensor"));
  setRobotFrame(recording, base->second);
}

/// Whole numbers seconds apart are a log at standstill, or one in milliseconds.
void noteSparseWholeStamps(Recording& recording)
{
  constexpr double kSparse = 5;  ///< [s] between records on average
  const std::vector<Record>& records = recording.records;
  if (records.size() < 3) return;
  for (const Record& record : records)
    if (timeOf(record) != std::floor(timeOf(record))) return;
  const double interval = (timeOf(records.back()) - timeOf(records.front())) / static_cast<double>(records.size() - 1);
  if (interval >= kSparse)
    recording.notes.push_back(
        formatted("one record in %.0f s: are the times in milliseconds? Seconds are expected", interval));
}

/// The map of the folder: landmarks.csv, or the one other format that is there.
fs::path mapIn(const fs::path& folder)
{
  fs::path found = folder / "landmarks.csv";
  for (const char* name : {"landmarks.json", "tags.yaml"})
  {
    if (!fs::exists(folder / name)) continue;
    if (fs::exists(found))
      throw configurationError((folder / name).string() + ": a second map beside " + found.string());
    found = folder / name;
  }
  return found;
}
}  // namespace

CsvFiles findCsvFiles(const std::vector<fs::path>& inputs)
{
  if (inputs.size() == 1)
  {
    const fs::path& folder = inputs[0];
    if (!fs::is_directory(folder)) throw dataError(folder.string() + ": no such folder, expected landmarks.csv in it");
    const auto optional = [&](const char* name) { return findPlainOrGzipped(folder / name).value_or(fs::path()); };
    const fs::path scans = optional("scans.csv");
    return {.landmarks = mapIn(folder),
            .odometry = optional("odometry.csv"),
            .detections = scans.empty() ? folder / "detections.csv" : optional("detections.csv"),
            .scans = scans,
            .ground_truth = optional("ground_truth.tum"),
            .sensors = optional("sensors.csv"),
            .wheelbase = {},
            .wheel_offset = 0,
            .base = {}};
  }
  if (inputs.size() != 3 && inputs.size() != 4)
    throw configurationError("csv: " + std::to_string(inputs.size()) +
                             " inputs, expected a folder or LANDMARKS ODOMETRY DETECTIONS [GROUND_TRUTH]");
  return {.landmarks = inputs[0],
          .odometry = inputs[1],
          .detections = inputs[2],
          .scans = {},
          .ground_truth = inputs.size() == 4 ? inputs[3] : fs::path(),
          .sensors = {},
          .wheelbase = {},
          .wheel_offset = 0,
          .base = {}};
}

Recording importCsv(const CsvFiles& files)
{
  Recording recording;
  recording.map = readLandmarkMapFile(files.landmarks);
  if (files.odometry.empty())
    recording.notes.emplace_back("no odometry.csv: the log has no odometry");
  else
    addOdometry(recording, files);
  const auto sensors = files.sensors.empty() ? std::map<std::string, SensorPose>() : readSensorPoses(files.sensors);
  if (!files.detections.empty()) addReadings(recording, files.detections);
  const bool are_scans_described = !files.sensors.empty() || files.detections.empty();
  if (!files.scans.empty() && are_scans_described) addScans(recording, files.scans, sensors);
  if (!files.scans.empty() && !are_scans_described)
    recording.notes.push_back(files.scans.filename().string() +
                              ": left out, there are detections, and no sensors.csv says where its beams point");
  if (files.sensors.empty())
    recording.notes.emplace_back("no sensors.csv: all sensors are at the robot's origin and face forward");
  else
    mountSensors(recording, sensors, files.sensors);
  setBase(recording, files, sensors);
  if (files.ground_truth.empty())
    recording.notes.emplace_back("no truth file");
  else
    recording.truth = readTum(files.ground_truth);
  sortByTime(recording);
  noteSparseWholeStamps(recording);
  correctTruthHeading(recording);
  return recording;
}
}  // namespace mrpt_ext
