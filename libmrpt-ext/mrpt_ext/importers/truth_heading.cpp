#include "mrpt_ext/importers/truth_heading.h"

#include <cmath>
#include <complex>

#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSegmentLength = 0.1;        // [m]
constexpr double kLongestPause = 1.0;         // [s] between two poses of one segment
constexpr double kMostTurn = degToRad(15);    // within one segment
constexpr double kLeastOffset = degToRad(5);  // below it is calibration, not a mistake
constexpr double kLeastConcentration = 0.9;
constexpr std::size_t kLeastSegments = 20;

Trajectory odometryOf(const Recording& recording)
{
  Trajectory odometry;
  for (const Record& record : recording.records)
    if (const auto* step = std::get_if<OdometryRecord>(&record)) odometry.push_back({step->time, step->pose, true});
  return odometry;
}
}  // namespace

std::optional<DrivingDirection> drivingDirection(const Trajectory& trajectory)
{
  std::complex<double> sum = 0;
  std::size_t segments = 0, begin = 0;
  for (std::size_t i = 1; i < trajectory.size(); ++i)
  {
    const TimedPose& from = trajectory[begin];
    const TimedPose& to = trajectory[i];
    const double turn = wrap(to.pose.phi - from.pose.phi);
    const bool usable = from.heading_known && to.heading_known && std::abs(turn) <= kMostTurn &&
                        to.time - trajectory[i - 1].time <= kLongestPause;
    const Vector2d motion = to.pose.position() - from.pose.position();
    if (usable && motion.norm() < kSegmentLength) continue;
    if (usable)
    {
      sum += std::polar(1.0, std::atan2(motion.y(), motion.x()) - from.pose.phi - turn / 2);
      ++segments;
    }
    begin = i;
  }
  if (segments < kLeastSegments) return std::nullopt;
  return DrivingDirection{std::arg(sum), std::abs(sum) / static_cast<double>(segments), segments};
}

std::optional<double> truthHeadingOffset(const Recording& recording)
{
  const auto in_truth = drivingDirection(recording.truth);
  if (!in_truth || in_truth->concentration < kLeastConcentration) return std::nullopt;
  const auto in_odometry = drivingDirection(odometryOf(recording)).value_or(DrivingDirection{0, 1, 0});
  if (in_odometry.concentration < kLeastConcentration) return std::nullopt;
  const double offset = wrap(in_truth->angle - in_odometry.angle);
  return std::abs(offset) > kLeastOffset ? std::optional(offset) : std::nullopt;
}

void correctTruthHeading(Recording& recording)
{
  const auto offset = truthHeadingOffset(recording);
  if (!offset) return;
  for (TimedPose& entry : recording.truth)
    if (entry.heading_known) entry.pose.phi = wrap(entry.pose.phi + *offset);
  recording.notes.push_back("warning: the truth heading was constantly off the direction of motion, " +
                            fixedText(radToDeg(*offset), 1) + " deg were added to it");
}
}  // namespace mrpt_ext
