#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/evaluation/adopted_calibration.h"
#include "mrpt_ext/evaluation/frame_geometry.h"
#include "mrpt_ext/evaluation/verdict_history.h"
#include "mrpt_ext/files/disk_backed_sequence.h"
#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/observation_count.h"
#include "mrpt_ext/geometry/pose_estimate.h"
#include "mrpt_ext/geometry/trajectory.h"

namespace mrpt_ext
{
/// All estimates of one method in one trial.
struct MethodTrajectory
{
  std::string name;         ///< key in summary.json, file name part of trajectory_<name>.tum
  bool continuous = false;  ///< tracks the pose between frames (odometry, EKF, filter); closed forms do not
  bool oracle = false;      ///< chooses among its candidates with the truth
  DiskBackedSequence<PoseEstimate> points;
  std::size_t frames_offered = 0;    ///< frames with any detection
  std::size_t frames_answered = 0;   ///< ... with an estimate
  std::size_t frames_ambiguous = 0;  ///< ... with candidates of equal rank: no row
  std::vector<double> step_milliseconds;
};

/// A row of hypotheses.csv.
struct HypothesisRow
{
  double time = 0;
  int rank = 0;  ///< 0 is the best
  Pose2 pose;
  double weight = 0;
  std::string source;

  template <class Self, class Archive>
  static void archive(Self& row, Archive& fields)
  {
    fields(row.time, row.rank, row.pose, row.weight, row.source);
  }
};

/// A mode of the filter's posterior.
struct ModeSummary
{
  GaussianPose pose;
  double weight = 0;
};

/// Hypotheses were injected, because the detections did not agree with the modes.
struct Reseeding
{
  double time = 0;     ///< [s]
  std::string reason;  ///< the filter's judgement one frame before
};

/// Diagnostics of the filter.
struct FilterRecord
{
  std::vector<std::size_t> particle_counts;  ///< one per frame
  std::optional<double> effective_sample_ratio_min;
  std::size_t lost_steps = 0;  ///< frames with verdict lost
  std::vector<Reseeding> reseedings;
  std::size_t stopped_searches = 0;  ///< steps whose search for the pose was ended by its work budget
  std::size_t detections_left_out = 0;
  std::size_t late_estimates = 0;   ///< finished in a later step than that of their frame (step_budget_ms)
  std::size_t most_steps_late = 0;  ///< of an estimate
  std::vector<ModeSummary> modes_at_end;
};

/// Estimate of a bias after one frame (a row of biases.csv).
struct BiasRow
{
  double time = 0;
  std::string name;  ///< "stereo.range_scale", "bearing_offset_deg"
  double mean = 0, std = 0;

  template <class Self, class Archive>
  static void archive(Self& row, Archive& fields)
  {
    fields(row.time, row.name, row.mean, row.std);
  }
};

/// Statistics of a landmark under the posterior of the filter.
struct LandmarkRecord
{
  std::size_t seen = 0;      ///< detections that may be of it
  double associated = 0;     ///< expected number of detections of it
  double inlier_rate = 1;    ///< learned reliability, in [0, 1]
  double residual_mean = 0;  ///< of the inliers, in units of their standard deviation
  double residual_std = 0;
};

/// A detected object that is no landmark, in the map frame (a row of objects.csv).
struct ObjectRow
{
  double time = 0;
  std::string label;
  Vector2d position{0, 0};  ///< [m] map frame
  Matrix2d covariance = Matrix2d::Zero();
  Vector2d position_robot{0, 0};  ///< [m] robot frame

  template <class Self, class Archive>
  static void archive(Self& row, Archive& fields)
  {
    fields(row.time, row.label, row.position, row.covariance, row.position_robot);
  }
};

/// A detection as it is drawn, by a sensor at `T_robot_sensor`.
struct DrawnDetection
{
  Pose2 T_robot_sensor;
  int id = kNoId;
  std::optional<double> bearing;  ///< [rad] CCW from the sensor's forward axis
  std::optional<double> range;    ///< [m] in the plane where the height of the landmark is known
  bool fix = false;               ///< second range of a running fix: without a heading, a ring around the landmark
};

/// What playback and live view show of one frame.
struct PlaybackStep
{
  double time = 0;               ///< [s]
  std::vector<Pose2> particles;  ///< drawn by weight, all of equal weight
  std::vector<ModeSummary> modes;
  std::vector<DrawnDetection> detections;
};

/// Output of one trial before it is scored. What grows with the log is in disk-backed sequences.
struct RunRecord
{
  int trial = 0;
  std::uint64_t seed = 0;
  std::vector<MethodTrajectory> methods;
  DiskBackedSequence<HypothesisRow> hypotheses;
  FilterRecord filter;
  DiskBackedSequence<BiasRow> biases;               ///< ordered by time
  std::map<std::string, LandmarkRecord> landmarks;  ///< by id as text
  DiskBackedSequence<ObjectRow> objects;
  std::vector<PlaybackStep> playback;  ///< of evenly spaced frames; may be empty
  std::vector<std::string> hints;      ///< what is likely wrong, one line each, with the command that helps
  VerdictHistory verdicts;             ///< of the judged method
  Verdict verdict = Verdict::lost;
  std::string verdict_reason;
  bool interrupted = false;
  double cpu_s = 0, wall_s = 0, peak_memory_mb = 0;
};

/// A file that a run read.
struct InputFile
{
  std::string role;  ///< "configuration" (the .ini), "map", "truth"
  std::string path, sha256;
};

/// What all trials of a run have in common.
struct RunContext
{
  std::string version, config_path, command_line;
  std::uint64_t seed = 0;  ///< random seed of the run; every trial derives its own from it
  std::string rawlog_path, rawlog_sha256;
  std::size_t rawlog_entries = 0;
  double start_time = 0, duration_s = 0;
  std::vector<InputFile> inputs;                  ///< other than the log
  std::string settings_sha256;                    ///< of config_resolved.ini: the .ini with all options and defaults
  std::string built_with;                         ///< versions of the compiler and of the libraries
  std::optional<AdoptedCalibration> calibration;  ///< what it took over from its log; absent: it runs as configured
  std::map<std::string, ObservationCount> observations;
  LandmarkTable map;
  Trajectory truth;  ///< empty: no errors
  bool truth_is_sparse = false;
  Trajectory odometry;  ///< dead-reckoned, in its own frame: predicts continuous methods to the scoring stamps
  DiskBackedSequence<FrameGeometry> geometry;  ///< of every frame with a detection, ordered by time
  bool objects_wanted = false;  ///< the configuration names `objects`: objects.csv is written even without detections
};
}  // namespace mrpt_ext
