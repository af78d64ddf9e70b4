#include "mrpt_ext/relocalization/trajectory_steps.h"

#include <algorithm>

#include "mrpt_ext/filter/integrity/independent_detections.h"
#include "mrpt_ext/hypotheses/scans.h"
#include "mrpt_ext/relocalization/measurement_window.h"

namespace mrpt_ext
{
namespace
{
constexpr double kGate = 3.3;                // standard deviations
constexpr double kParallax = degToRad(2.0);  // that a landmark shifts within a look

double worldAngle(const Scan& place, const AnonymousDetection& d) { return *d.bearing + place.T_robot_sensor.phi; }

/// True when both may show one landmark.
bool isRepeated(const Scan& at_a, const AnonymousDetection& a, const Scan& at_b, const AnonymousDetection& b)
{
  if (a.category != b.category || a.bearing.has_value() != b.bearing.has_value()) return false;
  const double std = std::hypot(a.std_bearing, b.std_bearing);
  if (a.bearing && std::abs(wrap(worldAngle(at_a, a) - worldAngle(at_b, b))) > kGate * std + kParallax) return false;
  return !(a.range && b.range) || std::abs(*a.range - *b.range) <= kGate * std::hypot(a.std_range, b.std_range);
}

/// Each landmark once, where it was seen last; `places` oldest first.
std::vector<Scan> withoutRepeats(std::vector<Scan> places)
{
  std::reverse(places.begin(), places.end());
  std::vector<Scan> kept;
  for (Scan& rest : places)
  {
    std::erase_if(rest.detections,
                  [&](const AnonymousDetection& d)
                  {
                    return std::any_of(kept.begin(), kept.end(),
                                       [&](const Scan& k)
                                       {
                                         return std::any_of(k.detections.begin(), k.detections.end(),
                                                            [&](const auto& e) { return isRepeated(k, e, rest, d); });
                                       });
                  });
    if (!rest.detections.empty()) kept.push_back(std::move(rest));
  }
  std::reverse(kept.begin(), kept.end());
  return kept;
}

/// The way so far and one more piece.
void extend(TrajectoryStep& step, const Pose2& increment, const Matrix3d& noise)
{
  const GaussianPose extended = compound({step.increment, step.noise}, increment, noise);
  step.increment = extended.mean;
  step.noise = extended.covariance;
}
}  // namespace

std::vector<TrajectoryStep> trajectorySteps(std::span<const Frame> frames, const MotionModel& motion,
                                            const LandmarkTable& map, const LandmarkIndex& index, double look_duration)
{
  std::vector<TrajectoryStep> steps;
  DetectionDecorrelator fresh({}, motion, map);
  for (std::size_t begin = 0, end = 0; begin < frames.size(); begin = end)
  {
    TrajectoryStep step;
    MeasurementWindow look(2 * look_duration + 1, motion);
    for (end = begin; end < frames.size() && frames[end].time - frames[begin].time < look_duration; ++end)
    {
      const OdometryMotion believed = believedMotion(motion, frames[end].motion);
      extend(step, believed.increment, incrementCovariance(motion, frames[end].motion));
      fresh.move(frames[end].motion);
      Frame seen = frames[end];
      for (Reading& reading : seen.readings) reading = fresh.take(reading);
      look.add(seen);
    }
    step.seen = withoutRepeats(scansOf(look.readings(), map, index));
    steps.push_back(std::move(step));
  }
  return steps;
}
}  // namespace mrpt_ext
