#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/identity_level.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/scan_sweep.h"
#include "mrpt_ext/simulation/barrier_planner.h"
#include "mrpt_ext/simulation/map_generator.h"
#include "mrpt_ext/simulation/path_planner.h"

namespace mrpt_ext
{
/// Errors of dead reckoning. Standard deviations are per unit of distance, rotation or time; variances add up, so the
/// errors do not depend on the rate of odometry.
struct OdometryNoise
{
  double rate_hz = 10;                ///< 0: the robot has no odometry
  double std_xy_per_m = 0.02;         ///< [m] after one metre, along and across alike
  double std_phi_deg_per_deg = 0.1;   ///< [deg] after turning one degree
  double std_phi_deg_per_m = 0.5;     ///< [deg] after one metre
  double std_xy_per_sqrt_s = 0;       ///< [m] after one second, also at standstill
  double std_phi_deg_per_sqrt_s = 0;  ///< [deg] after one second, also at standstill
  double scale_error = 0;             ///< measured / true distance - 1
  double rotation_scale_error = 0;    ///< measured / true rotation - 1
  double arc_scale_error = 0;   ///< the same for turns while driving, in addition; turns in place are not affected
  double veer = 0;              ///< [rad/m] to the left that odometry does not measure
  double drift = 0;             ///< [rad/s] that the heading turns in the log, also at standstill
  double slips_per_minute = 0;  ///< expected number
  double std_slip = 0;          ///< [m] of a displacement that odometry misses
  double std_slip_heading = 0;  ///< [rad] of the turn that it misses
};

/// Odometry and mounting that nobody calibrated: each error is drawn anew per random seed, up to these sizes.
struct ErrorSpread
{
  double drift = 0;          ///< [rad/s] heading drift of either sign
  double arc_turn_loss = 0;  ///< on arcs the robot turns less than measured by up to this share
  double noise_factor = 1;   ///< odometry noise is up to this many times the stated one
  double slips_per_minute = 0;
  double delay = 0;                               ///< [s] of every sensor
  double lever_arm = 0;                           ///< [m] that a sensor is off its stated place, along each axis
  double distance_scale = 0, rotation_scale = 0;  ///< measured / true - 1, either sign
  double veer = 0;                                ///< [rad/m] either sign
  double bearing_offset = 0;                      ///< [rad] of every sensor, either sign
  double range_offset = 0, range_scale = 0;       ///< [m], measured / true - 1, of every sensor, either sign
};

enum class SensorKind
{
  bearings,
  ranges,
  range_bearing,
  running_fix,  ///< ranges, logged in pairs with the motion between them
  compass
};

struct SimulatedSensor
{
  std::string label;
  SensorKind kind = SensorKind::bearings;
  double rate_hz = 5;
  double phase_s = 0;               ///< time of the first reading after the start
  double delay_s = 0;               ///< of the stamp, after the measurement
  ScanSweep sweep;                  ///< of a spinning scanner: the stamp is the time of the last beam
  Pose2 T_robot_sensor;             ///< as logged; yaw = direction of the forward axis
  Vector2d lever_arm{0, 0};         ///< [m] true minus logged position on the robot, in robot axes
  double height = 0;                ///< [m] above the floor
  bool horizontal_range = false;    ///< ranges in the floor plane instead of slant ranges
  double field_of_view = kTwoPi;    ///< [rad] full angle around the forward axis
  std::optional<double> max_range;  ///< [m] horizontal
  double min_range = 0;             ///< [m] horizontal

  double std_bearing = degToRad(1.0), bias_bearing = 0;  ///< [rad]
  double std_range = 0;                                  ///< [m]
  double std_range_per_m = 0;              ///< [m] after one metre, linear in the range; added to std_range in variance
  double baseline_focal = 0;               ///< [m px] with std_disparity: range noise of a stereo pair
  double std_disparity = 0;                ///< [px]
  double bias_range = 0, scale_range = 1;  ///< measured = scale * true + bias + noise
  double std_heading = degToRad(5.0), bias_heading = 0;  ///< [rad] of a compass

  IdentityLevel identity = IdentityLevel::known;
  double wrong_identity_probability = 0;  ///< share of landmarks reported as another one (or another category)
  double detection_probability = 1;
  double clutter_per_reading = 0;     ///< expected number of false detections
  std::optional<int> max_detections;  ///< a random choice when more are seen
  bool sees_objects = true;

  double fix_distance = 0.1;  ///< [m] distance between the two ranges of a running fix
  bool fix_bearing = false;   ///< the second range of a running fix comes with a bearing
};

/// A detectable object that is no landmark, at rest or on a path of its own.
struct SimulatedObject
{
  std::string category;
  double z = 0;  ///< [m]
  PathPlan path{.kind = PathKind::standstill};
  double radius = 0;  ///< [m] it hides what is behind it; 0: nothing
};

/// At `time` the robot is moved to `pose`, unnoticed by its odometry; it then continues its path from there.
struct Kidnapping
{
  double time = 0;  ///< [s] after the start
  Pose2 pose;
};

/// Input of the simulator.
struct Scenario
{
  double start_time = 1000;  ///< [s] stamp of the first record
  double duration = 60;      ///< [s]
  double truth_rate_hz = 10;
  std::uint64_t random_seed = 1;
  MapPlan map;
  PathPlan path;
  OdometryNoise odometry;
  ErrorSpread spread;
  std::vector<SimulatedSensor> sensors;
  std::vector<SimulatedObject> objects;
  BarrierPlan barriers;
  std::vector<Kidnapping> kidnappings;  ///< ordered by time
};
}  // namespace mrpt_ext
