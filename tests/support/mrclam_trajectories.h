#pragma once

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include "frame_sequence.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/importers/mrclam.h"
#include "mrpt_ext/relocalization/trajectory_search.h"
#include "mrpt_ext/relocalization/trajectory_steps.h"

/// MRCLAM data set 6 with anonymous landmarks: localization over growing trajectories.
namespace mrpt_ext::mrclam_trajectories
{
constexpr double kStepDuration = 1;  // [s]
constexpr double kBetweenTries = 4;  // [s]
constexpr double kLongest = 90;      // [s] duration of a trajectory
constexpr double kEnough = 0.95;     // probability of the best pose
constexpr double kRightPosition = 1.0, kRightHeading = degToRad(20.0);

inline void hideIdentities(Recording& recording)
{
  for (Record& record : recording.records)
    if (auto* reading = std::get_if<Reading>(&record))
      for (Detection& detection : reading->detections) detection.id = kNoId;
}

inline void keepBearingsOnly(Recording& recording)
{
  for (Record& record : recording.records)
    if (auto* reading = std::get_if<Reading>(&record))
      for (Detection& detection : reading->detections) detection.range.reset();
}

/// Results over the trajectories of one log.
struct Tally
{
  int starts = 0, within_30 = 0, within_60 = 0, enough = 0, first = 0, among = 0;
  double returned = 0, seconds = 0;
  std::vector<double> ms;  // of processor time, of every search
};

inline bool isRight(const Pose2& pose, const Pose2& truth)
{
  return (pose.position() - truth.position()).norm() <= kRightPosition &&
         std::abs(wrap(pose.phi - truth.phi)) <= kRightHeading;
}

/// Extends a trajectory from `start` until the search determines a pose, and compares that with the truth. Nothing is
/// counted if the truth is unknown then.
inline void evaluateTrajectory(const testing::FrameSequence& sequence, std::size_t start, const Recording& recording,
                               const GlobalPoseSearch& search, const LocalizationConfig& config, Tally& tally)
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
    const std::clock_t clock = std::clock();
    const TrajectorySearchResult found = localizeOverTrajectory(
        trajectorySteps(frames, config.filter.motion, recording.map, search.index(), kStepDuration), search,
        config.filter.region);
    tally.ms.push_back(1e3 * static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC);
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

inline Tally tallyTrajectories(const Recording& recording, double between_starts)
{
  const Settings settings =
      Settings::load(std::string(MRPT_EXT_SOURCE_DIR) + "/ini/landmark-localization/mrclam.ini", localizationKeys());
  const LocalizationConfig config = localizationConfig(settings, recording.map);
  const testing::FrameSequence sequence = testing::buildFrames(recording.records, recording.map, config.frames);
  const GlobalPoseSearch search(recording.map);
  Tally tally;
  double next = -1e9;
  for (std::size_t k = 0; k < sequence.frames.size(); ++k)
  {
    if (sequence.frames[k].time < next) continue;
    next = sequence.frames[k].time + between_starts;
    ++tally.starts;
    evaluateTrajectory(sequence, k, recording, search, config, tally);
  }
  return tally;
}
}  // namespace mrpt_ext::mrclam_trajectories
