#include "mrpt_ext/rawlog/uwb_demo_import.h"

#include "mrpt_ext/files/mrpt_index_truth.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/recording_notes.h"
#include "mrpt_ext/importers/truth_heading.h"
#include "mrpt_ext/rawlog/rawlog_source.h"
#include "mrpt_ext/rawlog/statistics_notes.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

// Empty when there is no such file.
fs::path truthBeside(const fs::path& rawlog)
{
  fs::path truth = rawlog;
  truth.replace_filename(rawlog.stem().string() + "_GT.txt");
  return fs::exists(truth) ? truth : fs::path();
}

Trajectory joinWithTimes(const std::map<int, Pose2>& poses, const std::vector<double>& times, const fs::path& path)
{
  if (!poses.empty() && static_cast<std::size_t>(poses.rbegin()->first) >= times.size())
    throw dataError(path.string() + ": truth up to step " + std::to_string(poses.rbegin()->first) +
                    ", but the log has only " + std::to_string(times.size()) + " steps");
  Trajectory truth;
  for (const auto& [step, pose] : poses)
  {
    const double time = times[static_cast<std::size_t>(step)];
    if (truth.empty() || time > truth.back().time) truth.push_back({time, pose, true});
  }
  return truth;
}
}  // namespace

Recording importUwbDemo(const fs::path& rawlog, const fs::path& truth, const Pose2& T_map_truth,
                        const LandmarkTable& beacons)
{
  RawlogSource source(rawlog);
  Recording recording;
  recording.map = beacons;
  recording.records = readAll(source);
  addStatistics(recording, source.statistics());
  if (source.stepTimes().empty())
    throw dataError(rawlog.string() + ": no action/sensory-frame pairs, expected a log of that form");

  const fs::path truth_path = truth.empty() ? truthBeside(rawlog) : truth;
  if (truth_path.empty())
  {
    recording.notes.emplace_back("no truth file");
    return recording;
  }
  const auto poses = readMrptIndexTruth(truth_path, T_map_truth);
  recording.truth = joinWithTimes(poses, source.stepTimes(), truth_path);
  noteCount(recording, poses.size() - recording.truth.size(), "truth poses without a time of their own dropped");
  correctTruthHeading(recording);
  return recording;
}
}  // namespace mrpt_ext
