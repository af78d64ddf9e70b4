#include "mrpt_ext/relocalization/trajectory_steps.h"

#include <algorithm>

#include "mrpt_ext/filter/integrity/independent_detections.h"
#include "mrpt_ext/hypotheses/scans.h"
#include "mrpt_ext/relocalization/measurement_window.h"

namespace mrpt_ext
{
namespace
{
constexpr double kPairGate = 3.3;            // standard deviations
constexpr double kParallax = degToRad(2.0);  // of a landmark within a step

double bearingInRobot(const Scan& scan, const AnonymousDetection& d) { return *d.bearing + scan.T_robot_sensor.phi; }

/// True if both may show the same landmark.
bool isRepeated(const Scan& scan_a, const AnonymousDetection& a, const Scan& scan_b, const AnonymousDetection& b)
{
  if (a.category != b.category || a.bearing.has_value() != b.bearing.has_value()) return false;
  const double std = std::hypot(a.std_bearing, b.std_bearing);
  if (a.bearing && std::abs(wrap(bearingInRobot(scan_a, a) - bearingInRobot(scan_b, b))) > kPairGate * std + kParallax)
    return false;
  return !(a.range && b.range) || std::abs(*a.range - *b.range) <= kPairGate * std::hypot(a.std_range, b.std_range);
}

bool isRepeatedIn(const std::vector<Scan>& later, const Scan& scan, const AnonymousDetection& detection)
{
  const auto repeats = [&](const Scan& other)
  {
    return std::any_of(other.detections.begin(), other.detections.end(),
                       [&](const AnonymousDetection& d) { return isRepeated(other, d, scan, detection); });
  };
  return std::any_of(later.begin(), later.end(), repeats);
}

/// Keeps the last detection of each landmark; `scans` oldest first.
std::vector<Scan> withoutRepeats(std::vector<Scan> scans)
{
  std::reverse(scans.begin(), scans.end());
  std::vector<Scan> kept;
  for (Scan& scan : scans)
  {
    std::erase_if(scan.detections, [&](const AnonymousDetection& d) { return isRepeatedIn(kept, scan, d); });
    if (!scan.detections.empty()) kept.push_back(std::move(scan));
  }
  std::reverse(kept.begin(), kept.end());
  return kept;
}

/// Appends one more increment of odometry.
void extend(TrajectoryStep& step, const Pose2& increment, const Matrix3d& noise)
{
  const GaussianPose extended = compound({step.increment, step.noise}, increment, noise);
  step.increment = extended.mean;
  step.noise = extended.covariance;
}
}  // namespace

std::vector<TrajectoryStep> trajectorySteps(std::span<const Frame> frames, const MotionModel& motion,
                                            const LandmarkTable& map, const LandmarkIndex& index, double step_duration)
{
  std::vector<TrajectoryStep> steps;
  DetectionDecorrelator decorrelator(motion, map);
  for (std::size_t begin = 0, end = 0; begin < frames.size(); begin = end)
  {
    TrajectoryStep step;
    MeasurementWindow window(2 * step_duration + 1, motion);
    for (end = begin; end < frames.size() && frames[end].time - frames[begin].time < step_duration; ++end)
    {
      extend(step, nominalMotion(motion, frames[end].motion).increment,
             incrementCovariance(motion, frames[end].motion));
      decorrelator.move(frames[end].motion);
      Frame frame = frames[end];
      for (Reading& reading : frame.readings) reading = decorrelator.independent(reading);
      window.add(frame);
    }
    step.scans = withoutRepeats(scansOf(window.readings(), map, index));
    steps.push_back(std::move(step));
  }
  return steps;
}
}  // namespace mrpt_ext
