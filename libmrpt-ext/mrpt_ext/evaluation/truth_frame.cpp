#include "mrpt_ext/evaluation/truth_frame.h"

#include <algorithm>

#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kLeastEstimates = 10;
constexpr double kNearlyAll = 0.9;  // of the squared error

std::vector<JudgedEstimate> believed(std::vector<JudgedEstimate> judged)
{
  std::erase_if(judged, [](const JudgedEstimate& j) { return j.estimate.verdict != Verdict::ok; });
  return judged;
}

Vector2d estimated(const JudgedEstimate& j) { return j.estimate.pose.mean.position(); }
Vector2d truth(const JudgedEstimate& j) { return j.truth.pose.position(); }

template <typename Moved>
double meanSquare(const std::vector<JudgedEstimate>& judged, const Moved& moved)
{
  double sum = 0;
  for (const JudgedEstimate& j : judged) sum += (truth(j) - moved(j)).squaredNorm();
  return sum / static_cast<double>(judged.size());
}

/// Least squares of truth = T estimate (Umeyama 1991 without scale, in the plane).
Pose2 offsetOfMap(const std::vector<JudgedEstimate>& judged)
{
  Vector2d from = Vector2d::Zero(), to = Vector2d::Zero();
  for (const JudgedEstimate& j : judged)
  {
    from += estimated(j) / static_cast<double>(judged.size());
    to += truth(j) / static_cast<double>(judged.size());
  }
  double along = 0, across = 0;
  for (const JudgedEstimate& j : judged)
  {
    const Vector2d a = estimated(j) - from, b = truth(j) - to;
    along += a.dot(b);
    across += a.x() * b.y() - a.y() * b.x();
  }
  const double turn = std::atan2(across, along);
  const Vector2d shift = to - rotation(turn) * from;
  return {shift.x(), shift.y(), turn};
}

/// Least squares of truth = estimate T.
Pose2 offsetOnRobot(const std::vector<JudgedEstimate>& judged)
{
  Vector2d sum = Vector2d::Zero();
  for (const JudgedEstimate& j : judged) sum += rotation(-j.estimate.pose.mean.phi) * (truth(j) - estimated(j));
  const Vector2d mean = sum / static_cast<double>(judged.size());
  return {mean.x(), mean.y(), 0};
}

std::string at(const Pose2& T) { return "x " + fixedText(T.x, 2) + " m, y " + fixedText(T.y, 2) + " m"; }
}  // namespace

TruthOffsetFinding findTruthOffset(const std::vector<JudgedEstimate>& judged)
{
  const std::vector<JudgedEstimate> used = believed(judged);
  if (used.size() < kLeastEstimates) return {};
  const double error = meanSquare(used, estimated);
  const Pose2 map = offsetOfMap(used), robot = offsetOnRobot(used);
  const double of_map = meanSquare(used, [&](const JudgedEstimate& j) { return transform(map, estimated(j)); });
  const double on_robot =
      meanSquare(used, [&](const JudgedEstimate& j) { return transform(j.estimate.pose.mean, robot.position()); });
  const double left = std::min(of_map, on_robot);
  if (!(left < (1 - kNearlyAll) * error)) return {};
  return of_map <= on_robot ? TruthOffsetFinding{TruthOffset::map, map, std::sqrt(of_map)}
                            : TruthOffsetFinding{TruthOffset::robot, robot, std::sqrt(on_robot)};
}

std::string truthOffsetHint(const TruthOffsetFinding& finding)
{
  const std::string rest = " (" + fixedText(finding.residual, 3) + " m RMSE are left): ";
  switch (finding.kind)
  {
    case TruthOffset::map:
      return "truth: it is the estimates turned by " + fixedText(radToDeg(finding.T.phi), 1) + " deg and moved by " +
             at(finding.T) + rest + "is it in the frame of the map?";
    case TruthOffset::robot:
      return "truth: it is of a point at " + at(finding.T) + " on the robot of the estimates" + rest +
             "check where the sensors sit (sensors.csv), and which point of the robot the truth is of";
    case TruthOffset::none:
      break;
  }
  return {};
}
}  // namespace mrpt_ext
