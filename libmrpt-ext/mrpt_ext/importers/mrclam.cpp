#include "mrpt_ext/importers/mrclam.h"

#include <algorithm>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/mrclam_files.h"
#include "mrpt_ext/importers/reading_collector.h"
#include "mrpt_ext/importers/recording_notes.h"
#include "mrpt_ext/importers/truth_heading.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

void expectRobot(const fs::path& folder, int robot)
{
  if (!fs::is_directory(folder)) throw dataError(folder.string() + ": no such folder, expected an MRCLAM data set");
  const std::vector<int> robots = mrclamRobots(folder);
  if (std::find(robots.begin(), robots.end(), robot) != robots.end()) return;
  std::string known;
  for (const int number : robots) (known += known.empty() ? "" : ", ") += std::to_string(number);
  if (known.empty()) throw dataError(folder.string() + ": no Robot<n>_Measurement.dat, expected an MRCLAM data set");
  throw configurationError(folder.string() + ": no robot " + std::to_string(robot) + ", expected one of " + known);
}

void addOdometry(Recording& recording, const fs::path& folder, int robot)
{
  const auto velocities = readMrclamVelocities(folder, robot, recording.notes);
  if (!velocities)
  {
    recording.notes.emplace_back("no odometry file: readings only");
    return;
  }
  const std::vector<OdometryRecord> odometry = integrateVelocities(*velocities);
  recording.records.insert(recording.records.end(), odometry.begin(), odometry.end());
  noteCount(recording, velocities->size(), "rows of commanded velocities");
  noteCount(recording, velocities->size() - odometry.size(),
            "of them share the stamp of the row before: the later velocity holds");
}

void addReadings(Recording& recording, const fs::path& folder, int robot)
{
  const auto subject_by_barcode = readMrclamBarcodes(folder);
  const auto measurements = readMrclamMeasurements(folder, robot, recording.notes);
  Reading prototype;
  prototype.horizontal_range = true;
  ReadingCollector collector(prototype);
  std::size_t other_robots = 0, unknown_barcodes = 0, unmapped = 0;
  for (const MrclamMeasurement& row : measurements)
  {
    const auto subject = subject_by_barcode.find(row.barcode);
    if (subject == subject_by_barcode.end())
      ++unknown_barcodes;
    else if (subject->second <= kMrclamLastRobot)
      ++other_robots;
    else if (!recording.map.indexOf(subject->second))
      ++unmapped;
    else
      collector.add(row.time, mrclamCamera(robot),
                    {subject->second, kMrclamCategory, row.bearing, row.range, kMrclamStdBearing, kMrclamStdRange});
  }
  recording.records.insert(recording.records.end(), collector.readings().begin(), collector.readings().end());
  noteCount(recording, measurements.size(), "rows of measurements");
  noteCount(recording, other_robots, "readings of other robots dropped");
  noteCount(recording, unknown_barcodes, "readings of unknown barcodes dropped");
  noteCount(recording, unmapped, "readings of landmarks without a position dropped");
}

void addTruth(Recording& recording, const fs::path& folder, int robot)
{
  if (auto dense = readMrclamTruth(folder, robot, recording.notes))
  {
    recording.truth = std::move(*dense);
    recording.notes.emplace_back("truth: motion capture");
  }
  else if (auto sparse = readMrclamSparseTruth(folder, robot))
  {
    recording.truth = std::move(*sparse);
    recording.notes.emplace_back("truth: sparse, one pose in the middle of each spell without motion");
  }
  else
  {
    recording.notes.emplace_back("no truth file");
  }
}
}  // namespace

Recording importMrclam(const fs::path& folder, int robot)
{
  expectRobot(folder, robot);
  Recording recording;
  recording.map = readMrclamLandmarks(folder);
  addOdometry(recording, folder, robot);
  addReadings(recording, folder, robot);
  addTruth(recording, folder, robot);
  sortByTime(recording);
  correctTruthHeading(recording);
  return recording;
}

std::string mrclamCamera(int robot) { return std::string(kMrclamSensor) + "." + std::to_string(robot); }

std::vector<int> mrclamRobots(const fs::path& folder)
{
  std::vector<int> robots;
  for (int robot = 1; robot <= kMrclamLastRobot; ++robot)
    if (findPlainOrGzipped(folder / ("Robot" + std::to_string(robot) + "_Measurement.dat"))) robots.push_back(robot);
  return robots;
}
}  // namespace mrpt_ext
