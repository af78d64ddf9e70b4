#include "mrpt_ext/importers/mrclam_snapshots.h"

#include <map>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/importers/mrclam.h"
#include "mrpt_ext/importers/mrclam_files.h"
#include "mrpt_ext/importers/recording_notes.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

struct SnapshotRow
{
  int snapshot = 0, robot = 0, subject = 0;
  double range = 0, bearing = 0;
  bool inlier = false;
  Pose2 truth;
};

std::vector<SnapshotRow> readSnapshotRows(const fs::path& folder, const LandmarkTable& map)
{
  const fs::path path = folder / "Snapshots.csv";
  const TextTable table(findPlainOrGzipped(path).value_or(path), {});
  const std::size_t snapshot = table.column("snapshot"), robot = table.column("robot"),
                    subject = table.column("subject"), range = table.column("range_m"),
                    bearing = table.column("bearing_rad"), inlier = table.column("inlier"), x = table.column("gt_x_m"),
                    y = table.column("gt_y_m"), theta = table.column("gt_theta_rad");
  std::vector<SnapshotRow> rows;
  rows.reserve(table.size());
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    rows.push_back({table.integer(i, snapshot),
                    table.integer(i, robot),
                    table.integer(i, subject),
                    table.number(i, range),
                    table.number(i, bearing),
                    table.integer(i, inlier) == 1,
                    {table.number(i, x), table.number(i, y), wrap(table.number(i, theta))}});
    const SnapshotRow& row = rows.back();
    if (row.snapshot < 1 || (i > 0 && row.snapshot < rows[i - 1].snapshot))
      throw table.errorAt(i, "snapshot " + table.text(i, snapshot) + ", expected ascending numbers from 1 on");
    if (!map.indexOf(row.subject))
      throw table.errorAt(i, "subject " + table.text(i, subject) + " is not in Landmark_Groundtruth.dat");
    if (row.range <= 0) throw table.errorAt(i, "range_m " + table.text(i, range) + ", expected > 0");
  }
  return rows;
}

/// Mean of the readings of one landmark; bearings are averaged about the first one, safe at +-pi.
struct LandmarkMean
{
  double first_bearing = 0, bearing_sum = 0, range_sum = 0;
  int count = 0;

  void add(double bearing, double range)
  {
    if (count++ == 0) first_bearing = bearing;
    bearing_sum += wrap(bearing - first_bearing);
    range_sum += range;
  }
  [[nodiscard]] Detection detection(int id) const
  {
    return {id,
            kMrclamCategory,
            wrap(first_bearing + bearing_sum / count),
            range_sum / count,
            kMrclamStdBearing,
            kMrclamStdRange};
  }
};

using SnapshotMeans = std::map<int, LandmarkMean>;  // by landmark id

Reading snapshotReading(double time, const SnapshotMeans& means)
{
  Reading reading;
  reading.time = time;
  reading.sensor = kMrclamSensor;
  reading.horizontal_range = true;
  for (const auto& [id, mean] : means) reading.detections.push_back(mean.detection(id));
  return reading;
}
}  // namespace

Recording importMrclamSnapshots(const fs::path& folder, std::optional<int> robot)
{
  Recording recording;
  recording.map = readMrclamLandmarks(folder);
  const std::vector<SnapshotRow> rows = readSnapshotRows(folder, recording.map);
  std::size_t outliers = 0, other_robots = 0, averaged = 0, too_few = 0;
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end)
  {
    SnapshotMeans means;
    for (end = begin; end < rows.size() && rows[end].snapshot == rows[begin].snapshot; ++end)
    {
      if (rows[end].inlier)
        means[rows[end].subject].add(rows[end].bearing, rows[end].range);
      else
        ++outliers;
    }
    for (const auto& [id, mean] : means) averaged += static_cast<std::size_t>(mean.count - 1);
    const bool wanted = !robot || rows[begin].robot == *robot;
    other_robots += !wanted;
    too_few += wanted && means.size() < kMrclamLeastLandmarks;
    if (!wanted || means.size() < kMrclamLeastLandmarks) continue;
    recording.records.emplace_back(snapshotReading(rows[begin].snapshot, means));
    recording.truth.push_back({static_cast<double>(rows[begin].snapshot), rows[begin].truth, true});
  }
  noteCount(recording, rows.size(), "rows of readings");
  noteCount(recording, outliers, "readings marked as outliers dropped");
  noteCount(recording, averaged, "readings averaged into another one of the same landmark and snapshot");
  noteCount(recording, other_robots, "snapshots of other robots dropped");
  noteCount(recording, too_few, "snapshots with fewer than 3 distinct landmarks dropped");
  recording.notes.emplace_back("independent frames: the stamp of a snapshot is its number, in seconds");
  return recording;
}
}  // namespace mrpt_ext
