#include "mrpt_ext/calibration/measurement_times.h"

#include <algorithm>
#include <map>

#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSameTime = 1e-6;  // [s]

/// Noise of odometry between any two times, from that between the poses of a recording.
class OdometryNoiseByTime
{
 public:
  OdometryNoiseByTime(const CalibrationProblem& problem, const OdometryPath& path) : problem_(problem), path_(path) {}

  /// Nothing where poses are not tied.
  [[nodiscard]] std::optional<PerMotionNoise<Matrix3d>> between(double from, double to) const
  {
    PerMotionNoise<GaussianPose> sums;
    for (double time = from; time < to;)
    {
      const std::size_t k = linkAt(time);
      if (k >= problem_.poses.size() || !problem_.poses[k].since_previous) return std::nullopt;
      const double end = k + 1 < problem_.poses.size() ? std::min(to, problem_.poses[k].time) : to;
      const double share = (end - time) / (problem_.poses[k].time - problem_.poses[k - 1].time);
      const Pose2 increment = path_.between(time, end).increment;
      for (std::size_t n = 0; n < motion_noises; ++n)
        sums[n] = compound(sums[n], increment, share * (*problem_.poses[k].since_previous)[n]);
      time = end;
    }
    return PerMotionNoise<Matrix3d>{sums[position_noise].covariance, sums[heading_noise].covariance};
  }

 private:
  /// The pose at the end of the link that contains what follows `time`; before the first link that link, and so on.
  [[nodiscard]] std::size_t linkAt(double time) const
  {
    const auto after = std::upper_bound(problem_.poses.begin(), problem_.poses.end(), time,
                                        [](double t, const TrajectoryPose& pose) { return t < pose.time; });
    const auto k = static_cast<std::size_t>(after - problem_.poses.begin());
    return std::clamp<std::size_t>(k, 1, std::max<std::size_t>(problem_.poses.size(), 2) - 1);
  }

  const CalibrationProblem& problem_;
  const OdometryPath& path_;
};

/// A pose at a stamp as one sensor saw it.
struct MeasuredPose
{
  double time = 0;
  std::size_t stamp = 0;              // number of the pose at the stamp
  std::optional<std::size_t> sensor;  // none: a pose without readings
};

std::vector<MeasuredPose> measuredPoses(const CalibrationProblem& problem, const std::vector<double>& delays)
{
  std::vector<MeasuredPose> measured;
  std::size_t next = 0;
  for (std::size_t k = 0; k < problem.poses.size(); ++k)
  {
    std::vector<bool> sees(problem.sensors, false);
    const std::size_t first = next;
    for (; next < problem.readings.size() && problem.readings[next].pose == k; ++next)
      sees[problem.readings[next].sensor] = true;
    const double stamp = problem.poses[k].time;
    if (next == first) measured.push_back({stamp, k, std::nullopt});
    for (std::size_t s = 0; s < sees.size(); ++s)
      if (sees[s]) measured.push_back({stamp - delays[s], k, s});
  }
  std::stable_sort(measured.begin(), measured.end(),
                   [](const MeasuredPose& a, const MeasuredPose& b) { return a.time < b.time; });
  return measured;
}
}  // namespace

MeasuredRecording atMeasurementTimes(const CalibrationProblem& problem, const std::vector<double>& delays)
{
  MeasuredRecording result{problem, {}};
  CalibrationProblem& moved = result.problem;
  moved.poses.clear();
  moved.known_delays = delays;
  const OdometryPath path(problem.odometry, {});
  const OdometryNoiseByTime noise(problem, path);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;  // of the poses, by stamp and sensor
  for (const MeasuredPose& measured : measuredPoses(problem, delays))
  {
    const bool is_new = moved.poses.empty() || measured.time - moved.poses.back().time > kSameTime;
    if (is_new)
    {
      const Pose2 back = between(path.at(problem.poses[measured.stamp].time), path.at(measured.time));
      TrajectoryPose pose{measured.time, compose(problem.poses[measured.stamp].pose, back), {}};
      if (!moved.poses.empty()) pose.since_previous = noise.between(moved.poses.back().time, measured.time);
      moved.poses.push_back(pose);
    }
    if (measured.sensor) numbers[{measured.stamp, *measured.sensor}] = moved.poses.size() - 1;
  }
  for (CalibrationReading& r : moved.readings) r.pose = numbers.at({r.pose, r.sensor});
  for (std::size_t i = 0; i < moved.readings.size(); ++i) result.readings.push_back(i);
  const auto earlier = [&](std::size_t a, std::size_t b) { return moved.readings[a].pose < moved.readings[b].pose; };
  std::stable_sort(result.readings.begin(), result.readings.end(), earlier);
  std::vector<CalibrationReading> ordered;
  for (const std::size_t i : result.readings) ordered.push_back(moved.readings[i]);
  moved.readings = std::move(ordered);
  return result;
}
}  // namespace mrpt_ext
