#include "mrpt_ext/importers/plaza.h"

#include <cmath>
#include <set>

#include "mrpt_ext/geometry/arc_motion.h"
#include "mrpt_ext/importers/ordered_time.h"
#include "mrpt_ext/importers/range_field.h"
#include "mrpt_ext/importers/reading_collector.h"
#include "mrpt_ext/importers/recording_notes.h"
#include "mrpt_ext/importers/run_files.h"
#include "mrpt_ext/importers/truth_heading.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

const RunFileName kRanges{"", "_TD.txt"}, kMotion{"", "_DR.txt"}, kBeacons{"", "_TL.txt"}, kTruth{"", "_GT.txt"};

TextTable read(const fs::path& path, const std::vector<std::string>& columns)
{
  return TextTable(path, {Delimiter::white_space, "#", columns});
}

LandmarkTable readBeacons(const fs::path& path)
{
  const TextTable table = read(path, {"beacon", "x", "y"});
  std::vector<Landmark> landmarks;
  std::set<int> seen;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const int id = table.integer(row, 0);
    if (id < 0 || !seen.insert(id).second)
      throw table.errorAt(row, "beacon " + table.text(row, 0) + " is negative or occurs twice");
    landmarks.push_back({id, {table.number(row, 1), table.number(row, 2), 0}, kPlazaCategory, {0, 0}});
  }
  return LandmarkTable(std::move(landmarks));
}

void addOdometry(Recording& recording, const fs::path& path)
{
  const TextTable table = read(path, {"time", "distance", "turn"});
  Pose2 pose;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double time = ascendingTime(table, row), distance = table.number(row, 1), turn = table.number(row, 2);
    if (std::abs(turn) > kPi) throw table.errorAt(row, "turn " + table.text(row, 2) + ", expected radians in +-pi");
    if (row > 0) pose = compose(pose, arcMotion(distance, turn, 1));
    recording.records.emplace_back(OdometryRecord{time, pose});
  }
}

/// The rows of ranges, which the loggers did not always write in order.
void addRanges(Recording& recording, const fs::path& path)
{
  const TextTable table = read(path, {"time", "antenna", "beacon", "range"});
  Reading prototype;
  prototype.sensor = kPlazaSensor;
  prototype.horizontal_range = true;
  std::size_t unknown = 0, unanswered = 0;
  std::set<int> antennas;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double time = table.number(row, 0);
    if (row > 0 && time < table.number(row - 1, 0))
      recording.notes.push_back(
          std::string("warning: ") +
          table.errorAt(row, "time goes back to " + table.text(row, 0) + ", rows were sorted").what());
    antennas.insert(table.integer(row, 1));
    const int id = table.integer(row, 2);
    const auto range = radioRange(table, row, 3, kPlazaMostRange);
    if (!range)
      ++unanswered;
    else if (!recording.map.indexOf(id))
      ++unknown;
    else
    {
      Reading reading = prototype;
      reading.time = time;
      reading.detections.push_back({id, kPlazaCategory, std::nullopt, *range, 0, kPlazaStdRange});
      recording.records.emplace_back(std::move(reading));
    }
  }
  noteCount(recording, table.size(), "rows of ranges");
  noteCount(recording, unanswered, "ranges of 0 dropped");
  noteCount(recording, unknown, "ranges to beacons without a position dropped");
  if (antennas.size() > 1) noteCount(recording, antennas.size(), "antennas, treated as one position");
}

void addTruth(Recording& recording, const fs::path& path)
{
  if (!fs::exists(path))
  {
    recording.notes.emplace_back("no truth file");
    return;
  }
  const TextTable table = read(path, {"time", "x", "y", "heading"});
  for (std::size_t row = 0; row < table.size(); ++row)
    recording.truth.push_back(
        {ascendingTime(table, row), {table.number(row, 1), table.number(row, 2), wrap(table.number(row, 3))}, true});
}
}  // namespace

Recording importPlaza(const fs::path& input)
{
  const RunFiles run = chooseRun(input, kRanges);
  Recording recording;
  recording.map = readBeacons(run.file(kBeacons));
  addOdometry(recording, run.file(kMotion));
  addRanges(recording, run.file(kRanges));
  addTruth(recording, run.file(kTruth));
  sortByTime(recording);
  correctTruthHeading(recording);
  return recording;
}
}  // namespace mrpt_ext
