#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/observation_count.h"
#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/observations/usable_detections.h"

namespace mrpt::obs
{
class CAction;
class CObservation;
class CSensoryFrame;
}  // namespace mrpt::obs

namespace mrpt::serialization
{
class CSerializable;
}  // namespace mrpt::serialization

namespace mrpt_ext
{
/// The clock of a log in action/sensory-frame form, whose steps are its sensory frames.
struct StepClock
{
  std::optional<double> step;  ///< [s] per sensory frame; absent: the stamps of the log hold
  std::string reason;          ///< one line for the user; empty when the stamps hold
};

/// Whether the laser scans of the sensor with this label are wanted; empty: of none.
using ScanFilter = std::function<bool(const std::string& label)>;

/// Turns the entries of a log into plain records, in the order of the log, and counts used and ignored observations.
///
/// Observation-only logs: CObservationOdometry (of one label), our observations, MRPT's CObservationBearingRange and
/// CObservationBeaconRanges, and CObservationIMU with an absolute yaw become records; other classes are ignored.
/// CObservation2DRangeScan becomes a record where the ScanFilter wants it.
/// An IMU does not log its standard deviation: std_heading is 0 (not declared).
///
/// Logs of action/sensory-frame pairs: increments are accumulated to a dead-reckoned pose. An action is the motion
/// from one sensory frame to the next, so its pose has the time of the frame after it. All observations in a frame have
/// one time, each frame a time of its own: the latest time in the frame, else that of the action before it; or the
/// number of the frame, where the StepClock counts frames. So one sensory frame is one Frame where the window is 0.
/// Pair i is step i; a frame before the first action belongs to no step.
class RawlogTranslator
{
 public:
  struct Output
  {
    Record record;
    std::optional<std::size_t> step;
  };

  explicit RawlogTranslator(StepClock clock = {}, ScanFilter scans = {})
      : clock_(std::move(clock)), scans_(std::move(scans))
  {
  }

  /// Records of one entry; nothing (not even an empty list) when such an object is no part of a log.
  [[nodiscard]] std::optional<std::vector<Output>> translate(const mrpt::serialization::CSerializable& entry);
  /// The rest at the end of the log: actions after the last frame.
  [[nodiscard]] std::vector<Output> finish();

  /// By class, without namespace.
  [[nodiscard]] const std::map<std::string, ObservationCount>& observations() const { return observations_; }
  /// "<class>: <reason>": detections, or whole observations.
  [[nodiscard]] const UnusableCounts& unusable() const { return unusable_; }
  /// Time [s] of each action/sensory-frame pair, by step; empty for an observation-only log. A pair without any time
  /// has that of the pair before it (0 for the first), and no records.
  [[nodiscard]] const std::vector<double>& stepTimes() const { return step_times_; }
  /// Time [s] of each sensory frame that has one.
  [[nodiscard]] const std::vector<double>& frameTimes() const { return frame_times_; }

 private:
  struct PendingAction
  {
    std::string class_name;
    std::optional<double> time;
  };

  void readAction(const mrpt::obs::CAction& action);
  void readFrame(const mrpt::obs::CSensoryFrame& frame);
  /// `frame_time`: for observations without a time of their own.
  void readObservation(const mrpt::obs::CObservation& observation, std::optional<double> frame_time);
  /// These return why nothing of the observation is used; empty when something is.
  std::string useObservation(const mrpt::obs::CObservation& observation, double time);
  std::string useOdometry(const mrpt::obs::CObservation& observation, double time);
  std::string useCompass(const mrpt::obs::CObservation& observation, double time);
  std::string useScan(const mrpt::obs::CObservation& observation, double time);
  std::string useLandmarks(const mrpt::obs::CObservation& observation, double time);
  std::string useReading(Reading reading, const std::string& class_name);

  void emit(Record record) { output_.push_back({std::move(record), step_}); }
  void count(const std::string& class_name, const std::string& why_ignored);

  StepClock clock_;
  ScanFilter scans_;
  std::vector<Output> output_;  // of the current entry
  std::optional<std::size_t> step_;
  std::map<std::string, ObservationCount> observations_;
  UnusableCounts unusable_;
  std::vector<double> step_times_;
  std::string odometry_source_;             // label, or kActions; only the first one counts
  std::optional<double> first_frame_time_;  // of a frame before any odometry
  std::size_t frames_ = 0;                  // sensory frames so far
  std::vector<double> frame_times_;         // of those that have one
  Pose2 dead_reckoned_;
  std::vector<PendingAction> pending_actions_;  // since the last frame
};

/// The classes of observations, without namespace, that can become records; laser scans where they are wanted.
[[nodiscard]] std::set<std::string> translatedClasses(const ScanFilter& scans = {});
}  // namespace mrpt_ext
