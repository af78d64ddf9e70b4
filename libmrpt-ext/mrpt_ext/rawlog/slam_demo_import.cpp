#include "mrpt_ext/rawlog/slam_demo_import.h"

#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/rawlog/rawlog_source.h"
#include "mrpt_ext/rawlog/statistics_notes.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

/// The input of that index, else the file that MRPT puts beside the log.
fs::path companion(const std::vector<fs::path>& inputs, std::size_t index, const std::string& ending)
{
  if (inputs.size() > index) return inputs[index];
  fs::path path = inputs[0];
  return path.replace_filename(path.stem().string() + ending);
}

LandmarkTable readLandmarks(const fs::path& path, const std::vector<std::string>& columns)
{
  const TextTable table(path, {Delimiter::white_space, "%", columns});
  const std::size_t id = table.column("id"), x = table.column("x"), y = table.column("y"), z = table.column("z");
  std::vector<Landmark> landmarks;
  for (std::size_t row = 0; row < table.size(); ++row)
    landmarks.push_back(
        {.id = table.integer(row, id), .position = {table.number(row, x), table.number(row, y), table.number(row, z)}});
  return LandmarkTable(std::move(landmarks));
}

Trajectory readPath(const fs::path& path, const std::vector<double>& times)
{
  const TextTable table(path, {Delimiter::white_space, "%", {"x", "y", "z", "yaw", "pitch", "roll"}});
  if (table.size() != times.size())
    throw dataError(path.string() + ": " + std::to_string(table.size()) + " poses, but the log has " +
                    std::to_string(times.size()) + " sensory frames");
  Trajectory truth;
  for (std::size_t row = 0; row < table.size(); ++row)
    truth.push_back({times[row], {table.number(row, 0), table.number(row, 1), wrap(table.number(row, 3))}, true});
  return truth;
}

/// Records and notes of the log; returns the times of its sensory frames [s].
std::vector<double> addLog(Recording& recording, const fs::path& rawlog)
{
  RawlogSource source(rawlog);
  recording.records = readAll(source);
  if (!source.clockNote().empty()) recording.notes.push_back(source.clockNote());
  addStatistics(recording, source.statistics());
  if (source.frameTimes().empty())
    throw dataError(rawlog.string() + ": no sensory frames, expected a log of actions and sensory frames");
  return source.frameTimes();
}
}  // namespace

Recording importKfSlamDemo(const std::vector<fs::path>& inputs)
{
  Recording recording;
  const std::vector<double> times = addLog(recording, inputs[0]);
  recording.map = readLandmarks(companion(inputs, 1, "_ground_truth.txt"), {"x", "y", "z", "", "", "", "id"});
  const fs::path path = companion(inputs, 2, "_ground_truth_robot_path.txt");
  if (inputs.size() < 3 && !fs::exists(path))
    recording.notes.emplace_back("no truth file");
  else
    recording.truth = readPath(path, times);
  return recording;
}

Recording importRoSlamDemo(const std::vector<fs::path>& inputs)
{
  Recording recording;
  addLog(recording, inputs[0]);
  recording.map =
      readLandmarks(companion(inputs, 1, "_ground_truth.txt"), {"id", "x", "y", "z", "", "", "", "", "", "", "", ""});
  recording.notes.emplace_back("no truth file");
  return recording;
}
}  // namespace mrpt_ext
