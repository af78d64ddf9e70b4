#include <chrono>
#include <filesystem>
#include <iomanip>

#include "mrpt_ext/hypotheses/travel_search.h"
#include "mrpt_ext/importers/mrclam.h"
#include "mrpt_ext/localizers/travel_looks.h"
#include "mrpt_ext/pipeline/localization_config.h"
#include "mrpt_ext/pipeline/localization_keys.h"
#include "shared_data.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr double kBetweenStarts = 15;  // [s]
constexpr double kLook = 1;            // [s]
constexpr double kBetweenTries = 4;    // [s] of the window's growth
constexpr double kLongest = 90;        // [s] windows give up
constexpr double kEnough = 0.95;       // probability of the likeliest pose
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
  int starts = 0, within_30 = 0, within_60 = 0, enough = 0, first = 0, among = 0;
  double returned = 0, seconds = 0;
  std::vector<double> ms;  // of every search
};

bool isRight(const Pose2& pose, const Pose2& truth)
{
  return (pose.position() - truth.position()).norm() <= kRightPosition &&
         std::abs(wrap(pose.phi - truth.phi)) <= kRightHeading;
}

/// Grows a window from `start` until the search is sure of a pose, and judges its answer. Nothing is counted where the
/// truth is not known then.
void judgeWindow(const FrameSequence& sequence, std::size_t start, const Recording& recording,
                 const LostRobotSearch& search, const LocalizationConfig& config, Tally& tally)
{
  const double begin = sequence.frames[start].time;
  double next_try = begin;
  std::vector<Frame> frames;
  for (std::size_t k = start; k < sequence.frames.size() && sequence.frames[k].time - begin <= kLongest; ++k)
  {
    frames.push_back(sequence.frames[k]);
    if (k == start) frames.front().motion = {};
    const double now = frames.back().time;
    if (now < next_try) continue;
    next_try = now + kBetweenTries;
    const auto clock = std::chrono::steady_clock::now();
    const TravelSearch found = searchAlongWay(
        travelLooks(frames, config.filter.motion, recording.map, search.index(), kLook), search, config.filter.region);
    tally.ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - clock).count());
    if (found.hypotheses.empty() || found.hypotheses.front().weight <= kEnough) continue;
    const auto truth = interpolate(recording.truth, now, 0.5);
    if (!truth) continue;
    ++tally.enough;
    tally.within_30 += now - begin <= 30;
    tally.within_60 += now - begin <= 60;
    tally.first += isRight(found.hypotheses.front().pose.mean, truth->pose);
    tally.among += std::any_of(found.hypotheses.begin(), found.hypotheses.end(),
                               [&](const PoseHypothesis& h) { return isRight(h.pose.mean, truth->pose); });
    tally.returned += static_cast<double>(found.hypotheses.size());
    tally.seconds += now - begin;
    return;
  }
}

Tally tallyOf(const Recording& recording)
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

void print(std::ostream& out, int robot, const char* what, Tally t)
{
  const double n = std::max(1, t.enough), starts = std::max(1, t.starts);
  std::sort(t.ms.begin(), t.ms.end());
  const auto quantile = [&](double share)
  { return t.ms.empty() ? 0.0 : t.ms[static_cast<std::size_t>(share * static_cast<double>(t.ms.size() - 1))]; };
  out << "| " << robot << " | " << what << " | " << t.starts << " | " << std::fixed << std::setprecision(1)
      << 100 * t.within_30 / starts << " % | " << 100 * t.within_60 / starts << " % | " << 100 * t.enough / starts
      << " % | " << 100 * t.first / n << " % (" << t.first << " of " << t.enough << ") | " << 100 * t.among / n
      << " % | " << t.returned / n << " | " << t.seconds / n << " s | " << quantile(0.5) << " / " << quantile(0.95)
      << " |" << std::endl;
}

void run(std::ostream& out)
{
  const auto folder = sharedData("mrclam/MRCLAM_Dataset6");
  if (!folder)
  {
    out << "skipped: MRCLAM data set 6 is not there (LANDMARK_DATA_DIR)\n";
    return;
  }
  out << "From a start every " << kBetweenStarts << " s, the window grows by " << kBetweenTries
      << " s until it holds enough information: the stated probability\nof the likeliest pose is above " << kEnough
      << ", or " << kLongest << " s have passed. Right: within " << kRightPosition << " m and "
      << radToDeg(kRightHeading) << " deg of the motion capture.\n\n"
      << "| robot | measured | starts | enough information within 30 s | 60 s | " << kLongest
      << " s | of these right pose first | among the returned | returned | mean window | one search, median / 95 % "
         "[ms] "
         "|\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const bool ranges : {true, false})
    for (const int robot : mrclamRobots(*folder))
    {
      Recording recording = importMrclam(*folder, robot);
      hideIdentities(recording);
      if (!ranges) keepBearingsOnly(recording);
      print(out, robot, ranges ? "range and bearing" : "bearing", tallyOf(recording));
      out.flush();
    }
}

const RegisterStudy kStudy("mrclam_windows",
                           "MRCLAM 6 without identities: is the true pose first, once a window of travel is "
                           "informative enough?",
                           run);
}  // namespace
}  // namespace mrpt_ext
