#pragma once

#include <vector>

#include "mrpt_ext/calibration/calibration_problem.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::testing
{
/// A simulated recording with known systematic errors.
struct DrivePlan
{
  double duration = 120, rate = 5;  // [s], poses per second
  double speed = 0.4, weave = 0.6;  // [m/s], [rad/s] largest turn rate
  bool bearings = true, ranges = true;
  int landmarks_seen = 3;     // per reading, in turn
  double field_of_view = 10;  // [rad] around ahead
  bool depths = false;        // ranges are distances along the axis of the sensor
  std::vector<Vector2d> landmarks{{-4, -3}, {4, -3.5}, {5, 3}, {-3, 4}, {0.5, 5}};
  double std_bearing = degToRad(0.7), std_range = 0.05;
  double outliers = 0.03;  // share
  double hidden = 0;  // share of the ranges at x > 0 that are late by 0.25 to 1.5 m, landmark by landmark in bursts
  double std_distance_per_root_s = 0.01, std_turn_per_root_s = 0.01;
  double delay = 0, bearing_offset = 0, bearing_scale = 0, range_offset = 0, range_scale = 0;
  double range_axis = 0;                 // [rad] logged bearing of the axis of depths
  std::vector<double> landmark_offsets;  // [m] of ranges, by landmark, on top of the others; empty: none
  double height = 0;                     // [m] between sensor and landmarks; the readings do not state it
  Vector2d lever_arm{0, 0};              // [m] true minus stated
  double distance_scale = 0, rotation_scale = 0, veer = 0, drift = 0;
  double distance_per_turn = 0;  // [m/rad]
  bool evenly = false;           // on a circle, at one speed
  bool rests = false;            // for ten seconds of every thirty
  bool pivots = false;           // it turns once in place while it rests
  double pivot_scale = 0;
};

/// True pose at `time`.
inline Pose2 driveAt(const DrivePlan& plan, double time)
{
  constexpr double kCycle = 30, kDrives = 20;  // [s]
  double turned = 0;
  if (plan.rests)
  {
    const double cycles = std::floor(time / kCycle), since = time - cycles * kCycle;
    if (plan.pivots) turned = kTwoPi * std::max(0.0, since - kDrives) / (kCycle - kDrives);
    time = cycles * kDrives + std::min(since, kDrives);
  }
  if (plan.evenly)
  {
    const double radius = 2.5, angle = plan.speed / radius * time;
    return {radius * std::cos(angle), radius * std::sin(angle), wrap(angle + kPi / 2)};
  }
  // A figure of eight, driven at changing speed; the heading is that of the motion.
  const double size = 2.5, omega = plan.speed / size;
  const double s = omega * time + 0.35 * std::sin(plan.weave * time);
  const double x = size * std::sin(s), y = size * std::sin(s) * std::cos(s);
  return {x, y, wrap(std::atan2(std::cos(2 * s), std::cos(s)) + turned)};
}

/// How late the next range to a landmark is that was `late` [m] before: bursts of twenty readings.
inline double lateness(const DrivePlan& plan, const Pose2& robot, double& late, RandomStream& random)
{
  constexpr double kEnds = 0.05;
  if (late > 0 && random.chance(kEnds)) late = 0;
  if (late == 0 && robot.x > 0 && random.chance(kEnds * plan.hidden / (1 - plan.hidden)))
    late = random.uniform(0.25, 1.5);
  return late;
}

/// Readings are stamped `delay` late; odometry underestimates motion by its scale errors.
inline CalibrationProblem recordedDrive(const DrivePlan& plan, RandomStream& random)
{
  CalibrationProblem problem;
  problem.sensors = 1;
  constexpr double kOdometryRate = 20, kBefore = 2;  // [Hz], [s]
  Pose2 reckoned, before = driveAt(plan, -kBefore);
  problem.odometry.push_back({-kBefore, reckoned});
  for (int k = 1; k <= (plan.duration + 2 * kBefore) * kOdometryRate; ++k)
  {
    const double time = k / kOdometryRate - kBefore, root = std::sqrt(1 / kOdometryRate);
    const Pose2 now = driveAt(plan, time), step = between(before, now);
    const double distance_noise = plan.std_distance_per_root_s * root, turn_noise = plan.std_turn_per_root_s * root;
    const double length = step.position().norm();
    const double along = step.x + distance_noise * random.gaussian(),
                 across = step.y + distance_noise * random.gaussian();
    const double turn = (step.phi - plan.veer * length - plan.drift / kOdometryRate + turn_noise * random.gaussian()) /
                        (1 + plan.rotation_scale + (length < 1e-9 ? plan.pivot_scale : 0));
    const double shorter = length > 0 ? plan.distance_per_turn * std::abs(turn) / length : 0;
    reckoned = compose(reckoned, {along / (1 + plan.distance_scale) - shorter * step.x,
                                  across / (1 + plan.distance_scale) - shorter * step.y, turn});
    problem.odometry.push_back({time, reckoned});
    before = now;
  }
  std::size_t next_landmark = 0;
  std::vector<double> late(plan.landmarks.size(), 0);  // [m]
  for (int k = 0; k < plan.duration * plan.rate; ++k)
  {
    const double time = k / plan.rate;
    const Pose2 guess = driveAt(plan, time), seen_from = driveAt(plan, time - plan.delay);
    const Pose2 T_robot_sensor{plan.lever_arm.x(), plan.lever_arm.y(), 0};
    TrajectoryPose pose{time,
                        {guess.x + 0.1 * random.gaussian(), guess.y + 0.1 * random.gaussian(),
                         wrap(guess.phi + 0.05 * random.gaussian())},
                        {}};
    if (k > 0)
    {
      const double distance = square(plan.std_distance_per_root_s), turn = square(plan.std_turn_per_root_s);
      pose.since_previous = {Matrix3d(Vector3d(distance, distance, 0).asDiagonal()) / plan.rate,
                             Matrix3d(Vector3d(0, 0, turn).asDiagonal()) / plan.rate};
    }
    problem.poses.push_back(pose);
    for (int i = 0; i < plan.landmarks_seen; ++i)
    {
      const std::size_t number = next_landmark++ % plan.landmarks.size();
      CalibrationReading r{
          .pose = problem.poses.size() - 1, .landmark = plan.landmarks[number], .landmark_number = number};
      const double bearing = predictBearing(seen_from, r.landmark, T_robot_sensor);
      if (std::abs(bearing) > plan.field_of_view / 2) continue;
      const double seen = (1 + plan.bearing_scale) * bearing + plan.bearing_offset;
      const bool wrong = random.chance(plan.outliers);
      if (plan.bearings)
      {
        r.std = plan.std_bearing;
        r.value = wrap(seen + r.std * random.gaussian() + (wrong ? random.uniform(0.2, 2) : 0));
        problem.readings.push_back(r);
        r.off_axis = r.value;
      }
      if (!plan.ranges) continue;
      r.is_range = true;
      r.std = plan.std_range;
      const double slant = std::hypot(predictRange(seen_from, r.landmark, T_robot_sensor), plan.height);
      r.value = (1 + plan.range_scale) * slant * (plan.depths ? std::cos(seen - plan.range_axis) : 1) +
                plan.range_offset + (plan.landmark_offsets.empty() ? 0 : plan.landmark_offsets[number]) +
                r.std * random.gaussian() + (wrong ? random.uniform(0.5, 3) : 0);
      if (plan.hidden > 0) r.value += lateness(plan, guess, late[number], random);
      problem.readings.push_back(r);
    }
  }
  return problem;
}

/// A camera that measures depths along an axis beside that of its bearings, with a focal length that is not exact.
inline DrivePlan cameraDrive()
{
  DrivePlan plan;
  plan.duration = 240;
  plan.landmarks_seen = 5;
  plan.field_of_view = degToRad(90.0);
  plan.depths = true;
  plan.bearing_scale = 0.04;
  plan.range_axis = degToRad(-2.3);
  return plan;
}

/// Its readings as the ranges that the logged bearings make of them, along an axis straight ahead.
inline CalibrationProblem asRanges(CalibrationProblem problem)
{
  for (CalibrationReading& r : problem.readings)
    if (r.off_axis) r.value /= std::cos(*r.off_axis);
  std::erase_if(problem.readings, [](const CalibrationReading& r)
                { return r.off_axis ? std::cos(*r.off_axis) < 0.3 : !r.is_range && std::cos(r.value) < 0.3; });
  return problem;
}
}  // namespace mrpt_ext::testing
