#include "mrpt_ext/importers/scan_table.h"

#include "mrpt_ext/files/text_table.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStdRange = 0.02;  ///< [m]

/// Where the columns of a table of scans are.
class ScanColumns
{
 public:
  explicit ScanColumns(const TextTable& table) : t_(table.column("t")), sensor_(table.findColumn("sensor"))
  {
    ranges_ = numbered(table, 'r');
    intensities_ = numbered(table, 'i');
    if (ranges_.size() < 2 || ranges_.size() != intensities_.size())
      throw dataError(table.path().string() + ":1: " + std::to_string(ranges_.size()) + " columns r0, r1, ... and " +
                      std::to_string(intensities_.size()) +
                      " columns i0, i1, ..., expected as many of both, two at least");
    const std::size_t known = 1 + (sensor_ ? 1 : 0) + ranges_.size() + intensities_.size();
    if (table.columns().size() != known)
      throw dataError(table.path().string() + ":1: " + std::to_string(table.columns().size() - known) +
                      " other columns, expected t, sensor, r0, r1, ... and i0, i1, ...");
  }

  /// The scan in the row of `table`.
  [[nodiscard]] RangeScan scanIn(const TextTable& table, std::size_t row) const
  {
    RangeScan scan;
    scan.time = table.number(row, t_);
    scan.sensor = sensor_ ? table.text(row, *sensor_) : "laser";
    scan.std_range = kStdRange;
    for (const std::size_t column : ranges_)
    {
      const double range = table.coordinate(row, column);
      if (range < 0) throw table.errorAt(row, "a range of " + table.text(row, column) + " m, expected at least 0");
      scan.ranges.push_back(static_cast<float>(range));
    }
    for (const std::size_t column : intensities_)
      scan.intensities.push_back(static_cast<float>(table.coordinate(row, column)));
    return scan;
  }

 private:
  static std::vector<std::size_t> numbered(const TextTable& table, char letter)
  {
    std::vector<std::size_t> columns;
    while (const auto column = table.findColumn(letter + std::to_string(columns.size()))) columns.push_back(*column);
    return columns;
  }

  std::size_t t_;
  std::optional<std::size_t> sensor_;
  std::vector<std::size_t> ranges_, intensities_;
};

void mount(RangeScan& scan, const TextTable& table, std::size_t row, const std::map<std::string, SensorPose>& sensors)
{
  const auto sensor = sensors.find(scan.sensor);
  if (sensor == sensors.end() || !sensor->second.beams)
    throw table.errorAt(row, "a scan of sensor '" + scan.sensor +
                                 "', expected its row with first_bearing_deg and last_bearing_deg in sensors.csv");
  const SensorPose& pose = sensor->second;
  scan.T_robot_sensor = pose.T_robot_sensor;
  scan.sensor_height = pose.height;
  scan.first_bearing = pose.beams->first;
  scan.bearing_step = (pose.beams->last - pose.beams->first) / static_cast<double>(scan.ranges.size() - 1);
}
}  // namespace

std::vector<RangeScan> readScanTable(const std::filesystem::path& path,
                                     const std::map<std::string, SensorPose>& sensors)
{
  std::vector<RangeScan> scans;
  std::optional<ScanColumns> columns;
  forEachRow(path, {},
             [&](const TextTable& table)
             {
               if (!columns) columns.emplace(table);
               RangeScan scan = columns->scanIn(table, 0);
               if (!scans.empty() && scan.time < scans.back().time)
                 throw table.errorAt(0, "a time before that of the row above, expected ascending times");
               mount(scan, table, 0, sensors);
               scans.push_back(std::move(scan));
             });
  return scans;
}
}  // namespace mrpt_ext
