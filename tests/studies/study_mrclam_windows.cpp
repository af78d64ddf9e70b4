#include <filesystem>
#include <iomanip>

#include "mrpt_ext/hypotheses/interpret_readings.h"
#include "mrpt_ext/importers/mrclam.h"
#include "mrpt_ext/localizers/frame_joiner.h"
#include "mrpt_ext/pipeline/localization_config.h"
#include "mrpt_ext/pipeline/localization_keys.h"
#include "shared_data.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr double kBetweenStarts = 30;  // [s]
constexpr double kBetweenLooks = 1;    // [s] looks in between tell the same again
constexpr double kBetweenTries = 4;    // [s] of the window's growth
constexpr double kLongest = 90;        // [s] windows give up
constexpr double kRightPosition = 1.0, kRightHeading = degToRad(20.0);

void hideIdentities(Recording& recording)
{
  for (Record& record : recording.records)
    if (auto* reading = std::get_if<Reading>(&record))
      for (Detection& detection : reading->detections) detection.id = kNoId;
}

void keepBearingsOnly(Recording& recording)
{
  for (Record& record : recording.records)
    if (auto* reading = std::get_if<Reading>(&record))
      for (Detection& detection : reading->detections) detection.range.reset();
}

/// How the windows of one log ended.
struct Tally
{
  int starts = 0, enough = 0, first = 0, among = 0;
  double returned = 0, seconds = 0;
};

bool isRight(const Pose2& pose, const Pose2& truth)
{
  return (pose.position() - truth.position()).norm() <= kRightPosition &&
         std::abs(wrap(pose.phi - truth.phi)) <= kRightHeading;
}

/// Grows a window from `start` until the search says that chance explains nothing of the kind, and judges its answer.
void judgeWindow(const FrameSequence& sequence, std::size_t start, const Recording& recording,
                 const LostRobotSearch& search, const LocalizationConfig& config, Tally& tally)
{
  FrameJoiner joiner(2 * kLongest, config.filter.motion);
  const double begin = sequence.frames[start].time;
  double next_try = begin, next_look = begin;
  for (std::size_t k = start; k < sequence.frames.size() && sequence.frames[k].time - begin <= kLongest; ++k)
  {
    Frame frame = sequence.frames[k];
    if (k == start) frame.motion = {};
    if (frame.time < next_look)
      frame.readings.clear();
    else
      next_look = frame.time + kBetweenLooks;
    joiner.add(frame);
    if (frame.time < next_try) continue;
    next_try = frame.time + kBetweenTries;
    const ReadingInterpretation found =
        interpretReadings(joiner.readings(), recording.map, search, config.filter.region);
    if (!found.unique) continue;
    const auto truth = interpolate(recording.truth, frame.time, 0.5);
    if (!truth) return;
    ++tally.enough;
    tally.first += isRight(found.hypotheses.front().pose.mean, truth->pose);
    tally.among += std::any_of(found.hypotheses.begin(), found.hypotheses.end(),
                               [&](const PoseHypothesis& h) { return isRight(h.pose.mean, truth->pose); });
    tally.returned += static_cast<double>(found.hypotheses.size());
    tally.seconds += frame.time - begin;
    return;
  }
}

Tally tallyOf(Recording recording)
{
  const Settings settings =
      Settings::load(std::string(MRPT_EXT_SOURCE_DIR) + "/ini/landmark-localization/mrclam.ini", localizationKeys());
  const LocalizationConfig config = localizationConfig(settings, recording.map);
  const FrameSequence sequence = buildFrames(recording.records, recording.map, config.frames);
  const LostRobotSearch search(recording.map);
  Tally tally;
  double next = -1e9;
  for (std::size_t k = 0; k < sequence.frames.size(); ++k)
  {
    if (sequence.frames[k].time < next) continue;
    next = sequence.frames[k].time + kBetweenStarts;
    ++tally.starts;
    judgeWindow(sequence, k, recording, search, config, tally);
  }
  return tally;
}

void print(std::ostream& out, int robot, const char* what, const Tally& t)
{
  const double n = std::max(1, t.enough);
  out << "| " << robot << " | " << what << " | " << t.starts << " | " << t.enough << " | " << std::fixed
      << std::setprecision(1) << 100 * t.first / n << " % | " << 100 * t.among / n << " % | " << t.returned / n << " | "
      << t.seconds / n << " s |\n";
}

void run(std::ostream& out)
{
  const auto folder = sharedData("mrclam/MRCLAM_Dataset6");
  if (!folder)
  {
    out << "skipped: MRCLAM data set 6 is not there (LANDMARK_DATA_DIR)\n";
    return;
  }
  out << "From a start every " << kBetweenStarts << " s, the window grows until the search calls one pose unique: its "
      << "probability is above 0.95\nand chance would make fewer than 0.05 wrong poses that explain as much. Right: "
      << "within " << kRightPosition << " m and " << radToDeg(kRightHeading) << " deg of the motion capture.\n\n"
      << "| robot | measured | starts | enough information within " << kLongest
      << " s | right pose first | among the returned | returned | mean window |\n|---|---|---|---|---|---|---|---|\n";
  for (const bool ranges : {true, false})
    for (const int robot : mrclamRobots(*folder))
    {
      Recording recording = importMrclam(*folder, robot);
      hideIdentities(recording);
      if (!ranges) keepBearingsOnly(recording);
      print(out, robot, ranges ? "range and bearing" : "bearing", tallyOf(std::move(recording)));
      out.flush();
    }
}

const RegisterStudy kStudy("mrclam_windows",
                           "MRCLAM 6 without identities: is the true pose first, once a window of travel is "
                           "informative enough?",
                           run);
}  // namespace
}  // namespace mrpt_ext
