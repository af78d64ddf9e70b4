#pragma once

#include <functional>

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext::testing
{
/// Logs that can be judged in the head: the robot drives along x with 1 m/s from the origin, starting at Unix time
/// 1000, so that at t seconds into the log it is at (t, 0) with heading 0.
inline constexpr double kLogStart = 1000;

inline Trajectory straightLine(double duration, double step)
{
  Trajectory line;
  const int count = static_cast<int>(duration / step + 0.5);
  for (int i = 0; i <= count; ++i) line.push_back({kLogStart + i * step, {i * step, 0, 0}, true});
  return line;
}

/// Truth at 10 Hz.
inline RunContext straightRun(double duration)
{
  RunContext context;
  context.start_time = kLogStart;
  context.duration_s = duration;
  context.truth = context.odometry = straightLine(duration, 0.1);
  return context;
}

/// A trajectory with one estimate per `step`, beside the true position by `error(t)` metres (t since the log's start).
inline MethodTrajectory trackWithError(const std::string& name, double from, double to, double step,
                                       const std::function<double(double)>& error)
{
  MethodTrajectory trajectory;
  trajectory.name = name;
  trajectory.continuous = true;
  const int count = static_cast<int>((to - from) / step + 0.5);
  for (int i = 0; i <= count; ++i)
  {
    const double t = from + i * step;
    PoseEstimate point;
    point.time = kLogStart + t;
    point.pose.mean = {t, error(t), 0};
    point.pose.covariance = Matrix3d::Identity() * 0.01;
    trajectory.points.push_back(point);
  }
  trajectory.frames_offered = trajectory.frames_answered = trajectory.points.size();
  return trajectory;
}

/// The trajectory with all its poses moved and turned.
inline MethodTrajectory movedBy(const Pose2& T, const MethodTrajectory& trajectory)
{
  MethodTrajectory moved = trajectory;
  moved.points.clear();
  for (PoseEstimate point : trajectory.points)
  {
    point.pose.mean = compose(T, point.pose.mean);
    moved.points.push_back(point);
  }
  return moved;
}

inline RunRecord recordOf(std::vector<MethodTrajectory> methods)
{
  RunRecord record;
  record.methods = std::move(methods);
  record.verdict = Verdict::ok;
  return record;
}
}  // namespace mrpt_ext::testing
