#include "synthetic_run.h"

#include <cmath>
#include <functional>

namespace mrpt_ext::testing
{
namespace
{
constexpr double kStart = 1700000000;
constexpr double kFrameStep = 0.5;

Pose2 onTheOval(double t)
{
  const double a = 0.12 * t;
  return {5 + 3.6 * std::cos(a), 3.5 + 2.2 * std::sin(a), wrap(std::atan2(2.2 * std::cos(a), -3.6 * std::sin(a)))};
}

/// Resembles noise; the same on every machine to the digits compared.
double wobble(double t, double phase) { return std::sin(12.9898 * t + phase) * std::cos(4.1414 * t + 2.7 * phase); }

MethodTrajectory trajectory(const std::string& name, bool continuous, double step, double duration,
                            const std::function<PoseEstimate(double)>& at)
{
  MethodTrajectory result;
  result.name = name;
  result.continuous = continuous;
  for (int i = 0; i * step <= duration; ++i)
  {
    PoseEstimate point = at(i * step);
    point.time = kStart + i * step;
    result.points.push_back(point);
    result.step_milliseconds.push_back(0.2 + 0.1 * std::abs(wobble(i, 1)));
  }
  result.frames_offered = static_cast<std::size_t>(duration / kFrameStep) + 1;
  result.frames_answered = result.points.size();
  return result;
}

PoseEstimate noisy(double t, double sigma, double phase)
{
  PoseEstimate point;
  const Pose2 truth = onTheOval(t);
  point.pose.mean = {truth.x + sigma * wobble(t, phase), truth.y + sigma * wobble(t, phase + 1),
                     wrap(truth.phi + 0.3 * sigma * wobble(t, phase + 2))};
  point.pose.covariance = Vector3d(sigma * sigma, sigma * sigma, 0.1 * sigma * sigma).cwiseMax(1e-6).asDiagonal();
  return point;
}

PoseEstimate filterPoint(double t)
{
  PoseEstimate point = noisy(t, 0.1, 3);
  if (t < 8)
  {
    point.pose.mean = {10 - point.pose.mean.x, 7 - point.pose.mean.y, wrap(point.pose.mean.phi + kPi)};
    point.verdict = Verdict::ambiguous;
    point.modes = 2;
  }
  if (t > 70 && t < 74) point.verdict = Verdict::lost;
  point.best_weight = t < 8 ? 0.5 + 0.02 * t : 0.99;
  point.effective_samples = 0.55 + 0.4 * wobble(t, 5);
  return point;
}

/// Bearings to three identified landmarks, one with a range, and an anonymous bearing.
std::vector<DrawnDetection> detections(double t)
{
  std::vector<DrawnDetection> seen;
  const Pose2 truth = onTheOval(t), T_robot_sensor{0.1, 0, 0};
  for (int id = 1; id <= 3; ++id) seen.push_back({T_robot_sensor, id, 0.7 * id - truth.phi, {}, false});
  seen.front().range = 2.5;
  seen.push_back({T_robot_sensor, kNoId, 2.0, {}, false});
  return seen;
}

PoseEstimate driftingOdometry(double t)
{
  PoseEstimate point;
  const Pose2 moved = between(onTheOval(0), onTheOval(t));
  point.pose.mean = compose({0, 0, 0.003 * t}, moved);
  return point;
}
}  // namespace

std::vector<PlaybackStep> syntheticPlayback(const MethodTrajectory& filter, std::size_t steps, std::size_t particles)
{
  std::vector<PlaybackStep> playback;
  const std::size_t stride = std::max<std::size_t>(filter.points.size() / steps, 1);
  std::size_t i = 0;
  for (const PoseEstimate& point : filter.points)
  {
    if (i++ % stride != 0 || playback.size() >= steps) continue;
    const double t = point.time - kStart;
    PlaybackStep step{point.time, {}, {{point.pose, point.best_weight}}, detections(t)};
    if (point.modes > 1) step.modes.push_back({noisy(t, 0.1, 3).pose, 1 - point.best_weight});
    for (std::size_t k = 0; k < particles; ++k)
      step.particles.push_back({point.pose.mean.x + 0.1 * wobble(static_cast<double>(k), t),
                                point.pose.mean.y + 0.1 * wobble(static_cast<double>(k), t + 1), point.pose.mean.phi});
    playback.push_back(std::move(step));
  }
  return playback;
}

RunContext syntheticContext(double duration)
{
  RunContext context;
  context.version = "0.1.0";
  context.config_path = "ini/landmark-localization/room.ini";
  context.command_line = "landmark-localization room.ini --set 'Filter.note=<b>&\"x\"</b>' --seed 7";
  context.seed = 7;
  context.rawlog_path = "datasets/room/room.rawlog";
  context.rawlog_sha256 = std::string(64, 'a');
  context.rawlog_entries = 1234;
  context.start_time = kStart;
  context.duration_s = duration;
  context.observations = {{"CObservationLandmarkBearings", {240, 240, 0}},
                          {"CObservationOdometry", {1200, 1200, 0}},
                          {"CObservationImage", {12, 0, 12}}};
  std::vector<Landmark> landmarks;
  const double corners[][2] = {{0, 0}, {10, 0}, {10, 7}, {0, 7}, {5, 0.3}, {9.5, 3.5}, {5, 6.8}, {0.4, 3.2}};
  for (const auto& corner : corners)
    landmarks.push_back({static_cast<int>(landmarks.size()) + 1, {corner[0], corner[1], 0}, "pole", {0, 0}});
  context.map = LandmarkTable(std::move(landmarks));
  for (int i = 0; i * 0.1 <= duration; ++i) context.truth.push_back({kStart + i * 0.1, onTheOval(i * 0.1), true});
  for (int i = 0; i * kFrameStep <= duration; ++i)
    context.geometry.push_back({kStart + i * kFrameStep, static_cast<std::size_t>(1 + i % 8), 0.4 * (1 + i % 6), 2.0});
  for (const PoseEstimate& point : trajectory("odometry", true, kFrameStep, duration, driftingOdometry).points)
    context.odometry.push_back({point.time, point.pose.mean, true});
  context.inputs = {{"map", "datasets/room_map.csv", std::string(64, 'b')}};
  return context;
}

RunRecord syntheticRecord(const RunContext& context, int trial)
{
  const double duration = context.duration_s;
  RunRecord record;
  record.trial = trial;
  record.seed = 1000u + static_cast<unsigned>(trial);
  record.methods.push_back(trajectory("odometry", true, kFrameStep, duration, driftingOdometry));
  record.methods.push_back(
      trajectory("bearing_least_squares", false, 1, duration, [](double t) { return noisy(t, 0.9, 1); }));
  record.methods.push_back(
      trajectory("bearing_maximum_likelihood", false, 1, duration, [](double t) { return noisy(t, 0.3, 2); }));
  record.methods.push_back(
      trajectory("interpretation_tree", false, 4, duration, [](double t) { return noisy(t, 0.3, 7); }));
  record.methods.push_back(
      trajectory("oracle_interpretation_tree", false, 2, duration, [](double t) { return noisy(t, 0.05, 8); }));
  record.methods.back().oracle = true;
  record.methods.push_back(
      trajectory("extended_kalman_filter", true, kFrameStep, duration, [](double t) { return noisy(t, 0.2, 4); }));
  record.methods.push_back(trajectory("particle_filter", true, kFrameStep, duration, filterPoint));
  record.hypotheses = {{kStart, 0, {1, 2, 0.5}, 0.6, "interpretation_tree"},
                       {kStart, 1, {9, 5, -2.6}, 0.4, "particles"}};
  record.filter.particle_counts = {4000, 900, 500};
  record.filter.effective_sample_ratio_min = 0.08;
  record.filter.lost_steps = 7;
  record.filter.late_estimates = 5;
  record.filter.most_steps_late = 3;
  record.filter.reseedings = {{kStart + 71, "inlier ratio only 30 %"}, {kStart + 73, "inlier ratio only 20 %"}};
  GaussianPose here, there;
  here.mean = onTheOval(duration);
  here.covariance = (Matrix3d() << 0.09, 0.05, 0, 0.05, 0.06, 0, 0, 0, 0.01).finished();
  there.mean = {10 - here.mean.x, 7 - here.mean.y, wrap(here.mean.phi + kPi)};
  there.covariance = Vector3d(0.04, 0.01, 0.02).asDiagonal();
  record.filter.modes_at_end = {{here, 0.93}, {there, 0.07}};
  for (int id = 1; id <= 8; ++id) record.landmarks[std::to_string(id)] = {100, 95.5, 0.96, 0.05, 1.02};
  record.landmarks["3"] = {100, 31.0, 0.31, 0.9, 1.8};
  record.objects = {{kStart + 2, "ball", {4, 3}, Matrix2d::Identity() * 0.01, {1, 0.5}}};
  record.playback = syntheticPlayback(record.methods.back(), 250, 100);
  for (const PoseEstimate& point : record.methods.back().points)
    record.verdicts.add(point.time, point.verdict,
                        point.verdict == Verdict::lost        ? "inlier ratio only 30 %"
                        : point.verdict == Verdict::ambiguous ? "2 modes"
                                                              : "one mode");
  record.verdict = Verdict::ok;
  record.verdict_reason = "one mode holds 0.93 of the weight, the evidence is as expected";
  record.cpu_s = 3.2;
  record.wall_s = 1.7;
  record.peak_memory_mb = 85;
  return record;
}
}  // namespace mrpt_ext::testing
