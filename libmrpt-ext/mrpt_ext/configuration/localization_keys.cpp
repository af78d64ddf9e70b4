#include "mrpt_ext/configuration/localization_keys.h"

#include "mrpt_ext/configuration/bias_config.h"
#include "mrpt_ext/configuration/filter_keys.h"
#include "mrpt_ext/configuration/localization_choices.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/settings/key_section.h"

namespace mrpt_ext
{
namespace
{
KeyTable fileKeys()
{
  const LocalizationConfig config;
  return KeySection("LocalizationExperiment")
      .path("rawlog_file", "Log to process. The argument RAWLOG replaces it.")
      .forBeginners()
      .path("ground_truth_path_file", "True trajectory in the map frame. It is only used to compute errors.")
      .forBeginners()
      .choice("ground_truth_format", "tum", truthFormats(),
              "Format of the ground truth. A file named *.tum is always read as tum.")
      .numbers("ground_truth_origin", "m m deg", {0, 0, 0}, ranges::kAny,
               "x y phi_deg: pose of the ground truth's frame in the map. Only for mrpt-index.")
      .path("logOutput_dir", "Folder for the results. -o replaces it; without either: out/<name of the .ini>.")
      .integer("experimentRepetitions", "", config.repetitions, ranges::kCount,
               "Number of independent trials. --repeat and --trials replace it.")
      .integer("random_seed", "", config.seed, ranges::kNotNegative,
               "Seed of all random numbers: same seed, same results. --seed replaces it.");
}

KeyTable startKeys()
{
  const ParticleFilterOptions filter;
  return KeySection("LocalizationExperiment")
      .integer("particles_count", "", kUnset, ranges::kCount,
               "Number of particles. It wins over [PF_options] sampleSize; without either: 2000.")
      .forBeginners()
      .integer("verified_particles_count", "", filter.verified_particles, {50, 1e7},
               "Number of particles while the posterior is a Gaussian. That is: one verified pose whose Kalman update "
               "importance sampling confirms. At most particles_count.")
      .integer("initial_particles_count", "", filter.initial_particles, ranges::kCount,
               "Number of particles for global initialization. Reduced to particles_count afterwards.")
      .choice("init_PDF_mode", filter.initial_mode, initialModes(), "Distribution of the first particles.")
      .forBeginners()
      .number("init_PDF_min_x", "m", kUnset, ranges::kAny, "Box of possible positions. Default: the map with a margin.")
      .number("init_PDF_max_x", "m", kUnset, ranges::kAny, "See init_PDF_min_x.")
      .number("init_PDF_min_y", "m", kUnset, ranges::kAny, "See init_PDF_min_x.")
      .number("init_PDF_max_y", "m", kUnset, ranges::kAny, "See init_PDF_min_x.")
      .number("init_PDF_margin_m", "m", kUnset, ranges::kNotNegative,
              "Margin around the landmarks where no box is given. Default: 3, or as far as the log's detections "
              "allow, where all are identified.")
      .number("init_PDF_mean_x", "m", filter.initial_pose.mean.x, ranges::kAny, "Known start, for gaussian.")
      .number("init_PDF_mean_y", "m", filter.initial_pose.mean.y, ranges::kAny, "See init_PDF_mean_x.")
      .degrees("init_PDF_mean_phi_deg", "deg", filter.initial_pose.mean.phi, ranges::kAny, "See init_PDF_mean_x.")
      .number("init_PDF_std_xy", "m", kStartStdXy, ranges::kPositive,
              "Standard deviation of the known start, per axis.")
      .degrees("init_PDF_std_phi_deg", "deg", kStartStdPhi, ranges::kPositive,
               "Standard deviation of the known heading.");
}

KeyTable methodKeys()
{
  const LocalizationConfig config;
  return KeySection("LocalizationExperiment")
      .choice(
          "filter_engine", config.engine, filterEngines(),
          "Implementation of the particle filter. MRPT's starts uniformly instead of analytically, does not recover "
          "and ignores a compass.")
      .names("methods", "all", methodNames(), "Methods to run, separated by blanks or commas.")
      .number(
          "frame_window_s", "s", config.frames.window, ranges::kNotNegative,
          "Detections within this time form one frame. In a log of actions and sensory frames each of these is one.")
      .number("step_s", "s", config.step, ranges::kPositive,
              "Time that one step of a log of actions and sensory frames counts where its stamps are no clock. That is "
              "where they are missing, equal, going back, or too dense for the motion, as in simulated logs.")
      .number(
          "join_window_s", "s", config.join_window, ranges::kNotNegative,
          "Window of past detections for closed forms. Above 0 each of them runs a second time, as <method>_joined, "
          "on the detections of this many seconds, moved by odometry.")
      .number(
          "seed_window_s", "s", config.seed_window, ranges::kNotNegative,
          "Window of past detections for hypotheses. With anonymous detections the filter starts after this time, or "
          "as soon as a single hypothesis is left.")
      .number("lateness_s", "s", config.lateness, ranges::kNotNegative,
              "Live: a record may be this much older than the newest one. Estimates wait as long.")
      .number("odometry_wait_s", "s", config.odometry_wait, ranges::kNotNegative,
              "Live: an estimate waits this long for odometry that reaches its time, then does without.")
      .number(
          "step_budget_ms", "ms", config.step_budget_ms, ranges::kNotNegative,
          "Time that a step of the particle filter may take, in counted operations, whatever the machine. What takes "
          "longer goes on in the next steps: its estimate is the same, and comes later. 0: no limit.")
      .flag("auto_calibrate", config.auto_calibrate,
            "Run twice: the first pass tells delays, scales, offsets and noise. What is found is adopted where it "
            "predicts the second half of the log better; logs of more than a minute only. The truth is not used. "
            "Sensors of anonymous detections that declare no field of view have that of their bearings.")
      .flag("independent_frames", config.frames.independent,
            "Localize every frame on its own. No motion in between, no filter, closed forms only.")
      .choice("heading_source", config.running_fix.heading_source, headingSources(), "Heading for running_fix.")
      .text("objects", "", "",
            "Categories of detections that are no landmarks. Separated by blanks; their positions are written to "
            "objects.csv.")
      .number("converged_within_m", "m", config.limits.within_m, ranges::kPositive,
              "Position error below which the robot counts as localized.")
      .number("converged_within_deg", "deg", config.limits.within_deg, ranges::kPositive,
              "Heading error below which the robot counts as localized.")
      .number("max_convergence_s", "s", config.limits.max_convergence_s, ranges::kPositive,
              "Longest time to converge of a successful trial.")
      .flag("save_final_scene", config.final_scene, "Write final.3Dscene: map, particles and modes at the end.")
      .integer("save_scene_every", "", config.scene_every, ranges::kNotNegative,
               "Write scenes/NNNNNN.3Dscene of every N-th frame. For SceneViewer3D; 0 writes none.")
      .integer("max_detections", "", config.max_detections, ranges::kCount,
               "Most detections of a frame. A frame with more is an error: memory and time grow with them.")
      .integer("max_landmarks", "", config.max_landmarks, ranges::kCount,
               "Most landmarks of the map. A map with more is an error: memory and time grow with them.")
      .text(
          "landmark_shift_x_m", "m", "",
          "Corrections of landmarks' places in the map, along x. Pairs id:shift such as 3:-0.31 4:0.05, for those that "
          "were surveyed wrongly.")
      .text("landmark_shift_y_m", "m", "", "See landmark_shift_x_m.");
}

KeyTable motionKeys()
{
  const MotionModel motion;
  const OdometryCorrection odometry;
  return KeySection("MotionModel")
      .choice("type", motion.type, motionTypes(), "What odometry measures.")
      .number("std_xy_per_m", "m", motion.std_xy_per_m, ranges::kNotNegative,
              "Standard deviation of the position after one metre. Variances add up with the distance.")
      .forBeginners()
      .number("std_phi_deg_per_deg", "deg", motion.std_phi_per_deg, ranges::kNotNegative,
              "Standard deviation of the heading after a turn of 1 deg. Variances add up with the turn.")
      .degrees("std_phi_deg_per_m", "deg", motion.std_phi_per_m, ranges::kNotNegative,
               "Standard deviation of the heading after one metre. Variances add up with the distance.")
      .forBeginners()
      .number("std_xy_per_sqrt_s", "m", motion.std_xy_per_s, ranges::kNotNegative,
              "Standard deviation of the position after one second. Also at standstill; it grows with the square root "
              "of time.")
      .alias("std_xy_min")
      .degrees("std_phi_deg_per_sqrt_s", "deg", motion.std_phi_per_s, ranges::kNotNegative,
               "Standard deviation of the heading after one second. Also at standstill; it grows with the square root "
               "of time.")
      .alias("std_phi_min_deg")
      .number("odometry_delay_s", "s", odometry.delay, ranges::kAny,
              "Latency of the odometry, added to its time stamps.")
      .number("odometry_scale", "", odometry.scale, ranges::kPositive,
              "Factor on the measured distance (not on turns).")
      .number("odometry_distance_per_deg_m", "m", degToRad(odometry.distance_per_turn), ranges::kAny,
              "Distance that odometry misses per measured degree that the robot turns while it drives, to either side, "
              "before odometry_scale. Negative where it falls behind commanded velocities on arcs.")
      .number("odometry_rotation_scale", "", odometry.rotation_scale, ranges::kPositive, "Factor on measured turns.")
      .number("odometry_pivot_scale", "", odometry.pivot_scale, ranges::kPositive,
              "Factor on measured turns in place, beside odometry_rotation_scale: on records of less than 0.1 m per "
              "radian.")
      .degrees("odometry_yaw_deg", "deg", odometry.yaw, {-360, 360},
               "How far the x axis of odometry is turned on the robot, to the left. Where the robot drives straight "
               "ahead by odometry it goes that much to the left.")
      .degrees("odometry_turn_per_m_deg", "deg", odometry.turn_per_m, ranges::kAny,
               "Turn to the left per metre that odometry misses (veer).")
      .degrees("odometry_turn_per_s_deg", "deg/s", odometry.turn_per_s, ranges::kAny,
               "Turn to the left per second that odometry misses, also at standstill (drift of a gyroscope).");
}

KeyTable sensorKeys()
{
  const SensorConfig sensor;
  const ReflectorOptions reflectors;
  return KeySection("Sensor_<label>")
      .number("delay_s", "s", sensor.delay, ranges::kAny, "Latency of the sensor, subtracted from its time stamps.")
      .number(
          "delay_std_s", "s", sensor.delay_std, {0, 1},
          "Standard deviation of that latency. What readings have not told of it is part of the stated covariance "
          "while the robot moves; the estimate is not corrected. 0: nothing is assumed, only what the readings show "
          "is stated.")
      .number("scan_duration_s", "s", sensor.sweep.duration, ranges::kNotNegative,
              "Time from the first beam of a spinning scanner to the last, whose time is the stamp. Each detection is "
              "moved by odometry to the stamp. Stamps of the first beam: delay_s = -scan_duration_s. 0: all at once.")
      .choice("scan_direction", sensor.sweep.direction, sweepDirections(), "Which way it turns, seen from above.")
      .degrees("scan_start_deg", "deg", sensor.sweep.start, {-360, 360},
               "Bearing of the first beam. Not set: the edge of the field of view where the turn begins.")
      .degrees("std_bearing_deg", "deg", sensor.std_bearing, ranges::kPositive,
               "Standard deviation of bearings. Replaces the logged one.")
      .forBeginners()
      .number("std_range_m", "m", sensor.std_range, ranges::kPositive,
              "Standard deviation of ranges. Replaces the logged one.")
      .forBeginners()
      .number("std_range_per_m", "", sensor.std_range_per_m, ranges::kNotNegative,
              "Standard deviation per metre of range, added to it.")
      .degrees("std_heading_deg", "deg", sensor.std_heading, ranges::kPositive, "Standard deviation of a compass.")
      .degrees("bias_bearing_deg", "deg", sensor.bias_bearing, ranges::kAny,
               "Known bias: measured = scale * true + bias.")
      .number("scale_bearing", "", sensor.scale_bearing, ranges::kPositive,
              "See bias_bearing_deg. A focal length that is not exact scales bearings.")
      .number("bias_range_m", "m", sensor.bias_range, ranges::kAny, "Known bias: measured = scale * true + bias.")
      .number("scale_range", "", sensor.scale_range, ranges::kPositive, "See bias_range_m.")
      .text(
          "landmark_bias_range_m", "m", "",
          "Range bias of each landmark, on top of bias_range_m. Pairs id:bias such as 1:0.12 4:-0.05, for radios with "
          "a delay of their own; needs known identities.")
      .flag("range_along_axis", sensor.range_along_axis,
            "Logged ranges are depths along the axis at range_axis_deg. As of a camera that measures the size of a "
            "landmark in the image: they are divided by the cosine of the angle to it. Ranges without a bearing are "
            "kept.")
      .degrees("range_axis_deg", "deg", sensor.range_axis, {-180, 180},
               "Logged bearing of the axis that depths are along: other than 0 where a camera's optical axis is not "
               "where its bearings count from.")
      .degrees("field_of_view_deg", "deg", sensor.field_of_view, {0.001, 360}, "Full angle. Replaces the logged one.")
      .number("max_range_m", "m", sensor.max_range, ranges::kPositive, "Maximum range. Replaces the logged one.")
      .number("clutter_probability", "", sensor.clutter_probability, ranges::kShare,
              "Share of detections that are no landmark of the map.")
      .number("detection_probability", "", sensor.detection_probability, ranges::kShare,
              "Probability of detecting a landmark in view. If set together with field of view and range limit, missed "
              "detections lower a pose's likelihood.")
      .number(
          "lever_arm_std_m", "m", sensor.lever_arm_std, {0, 1},
          "Standard deviation of its stated position on the robot, along each axis. What readings and turns have "
          "not told of it is part of the stated covariance; the estimate is not corrected. Not set: 0.05 until turns "
          "tell how well such positions were stated. 0: nothing is assumed, only what the readings show is stated.")
      .degrees(
          "yaw_std_deg", "deg", sensor.yaw_std, {0, 90},
          "Standard deviation of its stated direction on the robot. No reading tells which way the robot's own axes "
          "point: it is part of the stated covariance of the heading. Not set: 0, until auto_calibrate adopts an "
          "offset of bearings.")
      .number("lever_arm_x_m", "m", sensor.lever_arm.x(), ranges::kAny,
              "How much further forward on the robot it is than the log says.")
      .number("lever_arm_y_m", "m", sensor.lever_arm.y(), ranges::kAny,
              "How much further left it is than the log says.")
      .choice("association", sensor.association, identityLevels(),
              "Which logged identities are used for data association.")
      .forBeginners()
      .choice("extract", "none",
              {{"none", {}, "nothing"}, {"reflectors", {}, "bright spots, as landmarks without names"}},
              "What is taken from laser scans. Reflectors need intensity_above.")
      .number("intensity_above", "", kUnset, ranges::kNotNegative,
              "Beams on reflectors are brighter, in units of the scanner.")
      .number(
          "reflector_diameter_m", "m", reflectors.diameter, ranges::kNotNegative,
          "Diameter of a post, width of a plate. Detections are its centre; wider bright surfaces are left out. 0: not "
          "known.")
      .choice("reflector_shape", reflectors.shape, reflectorShapes(), "Form of the reflectors.")
      .flag("ignore", sensor.ignore, "Ignore this sensor.");
}
}  // namespace

KeyTable localizationKeys()
{
  KeyTable table = fileKeys();
  return table.append(startKeys())
      .append(methodKeys())
      .append(mrptKeys())
      .append(motionKeys())
      .append(sensorKeys())
      .append(biasKeys())
      .append(filterKeys());
}
}  // namespace mrpt_ext
