#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/localizers/particle_filter_localizer.h"
#include "mrpt_ext/localizers/sliced_localizer.h"

namespace mrpt_ext
{
struct OnlineOptions
{
  ParticleFilterOptions filter;  ///< its region must be set: where the robot can be
  FrameOptions frames;           ///< sensors with their delays, window, corrections of the odometry
  double seed_window = 3;        ///< [s] of measurements that the first hypotheses come from
  std::uint64_t seed = 1;        ///< of the random numbers
  double lateness = 0;           ///< [s] a record may be this much older than the newest; estimates wait as long
  double odometry_wait = 1;      ///< [s] that an estimate waits for odometry which reaches its time
  /// [ms] of work, in counted operations, that estimates() does for every frame that it gets, or at once; 0: no limit.
  double step_budget_ms = kStepBudgetMs;
};

/// The options of a configured app; methods, evaluation and files play no part.
[[nodiscard]] OnlineOptions onlineOptions(const LocalizationConfig& config);

/// What became final with one frame (all detections within the window).
struct OnlineEstimate
{
  double time = 0;                   ///< [s] of the last detection of the frame
  std::optional<PoseEstimate> best;  ///< the best mode, as a row of steps.csv; absent before the start
  std::vector<Mode> modes;           ///< heaviest first
  Verdict verdict = Verdict::ambiguous;
  std::string reason;
  std::vector<BiasEstimate> biases;  ///< in the order of OnlineOptions::filter.biases
  std::size_t steps_late = 0;        ///< calls of estimates(), or frames, that followed its own; 0: in time
};

/// The particle filter on a robot: records go in while they are measured, estimates come out. A log that is fed to it
/// record by record gives the same estimates as `landmark-localization` gives.
///
///     OnlineLocalizer robot = OnlineLocalizer::fromIni("robot.ini", "map.csv");
///     robot.addOdometry(0.1, {0.05, 0, 0});
///     robot.addDetections(0.1, "camera", {{.id = 7, .bearing = 0.3, .std_bearing = 0.01}});
///     for (const OnlineEstimate& estimate : robot.estimates()) ...
///     const auto now = robot.poseAt(0.12);
///
/// Threads: every function may be called from any thread. The add functions and poseAt() never wait for the filter;
/// estimates(), finish(), reset() and snapshot() wait for each other. The work is done by who calls estimates(), a step
/// of it per call: what takes longer, as a start, goes on in the next calls, and its estimates come then
/// (localizers/sliced_localizer.h).
///
/// Memory depends on lateness, window, delays, and the longest time without detections, not on the time that it runs.
/// Times may be of any clock, but of one.
class OnlineLocalizer
{
 public:
  OnlineLocalizer(const OnlineOptions& options, const LandmarkTable& map);
  /// With the keys of `landmark-localization`; without `map` the one that the .ini names. Throws InputError.
  static OnlineLocalizer fromIni(const std::filesystem::path& ini, const std::filesystem::path& map = {});

  /// Dead-reckoned pose at time `t` [s], in a frame of its own; only differences matter. Poses older than the newest
  /// one are dropped and counted. Throws InputError (data), as the other add functions do, for values that cannot be
  /// measured.
  void addOdometry(double t, const Pose2& pose);
  /// Speed [m/s] and turn rate [rad/s, CCW] from time `t` on; instead of addOdometry(), not beside it.
  void addVelocity(double t, double v, double omega);
  /// Detections of one sensor at time `t`, and where it sits on the robot.
  void addDetections(double t, const std::string& sensor, std::vector<Detection> detections,
                     const Pose2& T_robot_sensor = {}, double sensor_height = 0);
  /// Any record of a log.
  void add(Record record);

  /// What became final since the last call, in the order of time.
  [[nodiscard]] std::vector<OnlineEstimate> estimates();
  /// True while frames wait for more work: who need not do anything else meanwhile calls estimates() again.
  [[nodiscard]] bool working() const;
  /// No record will follow: what is left.
  [[nodiscard]] std::vector<OnlineEstimate> finish();

  /// The newest estimate moved to a later time `t` by the odometry that has come so far, its noise included; as it is
  /// where the heading is unknown. Nothing while there is no estimate.
  [[nodiscard]] std::optional<PoseEstimate> poseAt(double t) const;

  /// From the first frame at or after time `t` on the filter starts anew, from this pose at time `t`, or from an
  /// unknown one.
  void reset(double t, const std::optional<GaussianPose>& pose = std::nullopt);

  /// From the next frame on the landmarks are these; an `ok` pose and the systematic errors are kept, another pose is
  /// unknown.
  void setMap(const LandmarkTable& map);

  /// What a robot that restarts needs to go on: the pose and the systematic errors, as a line of text. An estimate
  /// whose verdict is not `ok` is saved as an unknown pose.
  [[nodiscard]] std::string snapshot() const;
  /// Starts from a snapshot; the robot must not have been moved since. Throws InputError (data) for other text, or a
  /// snapshot with other systematic errors.
  void restore(const std::string& snapshot);

  /// Detections and odometry that could not be used, by sensor and reason, as of the last call of estimates().
  [[nodiscard]] UnusableDetections unusable() const;

 private:
  /// The filter starts anew.
  struct Restart
  {
    double time = 0;  ///< [s] of `pose`
    std::optional<GaussianPose> pose;
    std::vector<BiasEstimate> biases;  ///< empty: as configured
    bool measured = false;             ///< the pose is an estimate of a localizer with the same sensors
  };
  using Event = std::variant<Record, Restart, LandmarkTable>;

  void post(Event event);
  void take(const Event& event, std::vector<OnlineEstimate>& finished);
  void take(const Record& record);
  void take(const LandmarkTable& map);
  /// True when a frame was ready.
  bool processReady(std::vector<OnlineEstimate>& finished);
  void collect(std::vector<OnlineEstimate>& finished);
  /// ... on all that waits.
  void collectAll(std::vector<OnlineEstimate>& finished);
  [[nodiscard]] bool odometryReaches(double stamp) const;
  [[nodiscard]] Estimate process(const Frame& frame);
  [[nodiscard]] OnlineEstimate stated(const SlicedLocalizer::Finished& finished);
  void restart(const Restart& restart, double time);
  /// Pose and systematic errors as of the last estimate, for a filter that takes over.
  [[nodiscard]] Restart handover() const;

  OnlineOptions options_;
  LandmarkTable map_;

  // Of the filter
  mutable std::mutex work_;
  LogOverview overview_;
  FrameSynchronizer frames_;
  std::shared_ptr<const GlobalPoseSearch> search_;
  std::unique_ptr<ParticleFilterLocalizer> filter_;
  std::deque<Restart> restarts_;
  double newest_ = -std::numeric_limits<double>::infinity();  // [s] of the records taken
  std::uint64_t starts_ = 0;                                  // of the filter
  SlicedLocalizer steps_;                                     // last: uses the others

  // Of those who add and ask
  mutable std::mutex exchange_;
  std::vector<Event> inbox_;
  OdometryPath recent_;  // since the newest estimate
  std::optional<PoseEstimate> newest_estimate_;
  std::optional<OdometryRecord> last_odometry_;
  double forward_ = 0, angular_ = 0;  // [m/s], [rad/s] since last_odometry_
  std::size_t late_odometry_ = 0;
};
}  // namespace mrpt_ext
