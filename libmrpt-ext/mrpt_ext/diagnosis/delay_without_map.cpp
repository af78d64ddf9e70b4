#include "mrpt_ext/diagnosis/delay_without_map.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace mrpt_ext
{
namespace
{
constexpr double kEarliest = -0.5, kSpacing = 0.05;  // [s]
constexpr int kTriedDelays = 31;
constexpr double kLongestPair = 1;  // [s] between two readings that see the same
constexpr double kNew = 0.3;        // share of bearings of what was not seen before
constexpr Eigen::Index kBlocks = 20, kLeastPerBlock = 5;
constexpr double kWorstStd = 0.1;        // [s]
constexpr std::size_t kMostPairs = 900;  // of a bearing with one before it, in two readings

using DelayScores = Eigen::Array<double, kTriedDelays, 1>;  // log-likelihoods, by delay

double delayOf(double index) { return kEarliest + kSpacing * index; }

/// How much a bearing at this range [m] changes by a motion without a turn, for a sensor that moves with the robot.
double parallaxOf(double bearing, double range, const Pose2& motion, const Pose2& T_robot_sensor)
{
  const double direction = bearing + T_robot_sensor.phi;
  return (std::sin(direction) * motion.x - std::cos(direction) * motion.y) / range;
}

/// Of a reading given the one before it.
DelayScores scoresOf(const Reading& before, const Reading& now, const OdometryPath& odometry, double typical_range)
{
  const std::size_t stride = 1 + before.detections.size() * now.detections.size() / kMostPairs;
  DelayScores scores;
  for (int k = 0; k < kTriedDelays; ++k)
  {
    const double delay = delayOf(k);
    const OdometryMotion motion = odometry.between(before.time - delay, now.time - delay);
    const double parallax = motion.path_length / typical_range;
    double sum = 0;
    for (std::size_t i = 0; i < now.detections.size(); i += stride)
    {
      const Detection& d = now.detections[i];
      if (!d.bearing) continue;
      double density = 0, count = 0;
      for (const Detection& b : before.detections)
      {
        if (!b.bearing || b.id != d.id || b.category != d.category) continue;
        const double variance = square(d.std_bearing) + square(b.std_bearing) + square(parallax);
        const double expected = *b.bearing +
                                parallaxOf(*b.bearing, typical_range, motion.increment, now.T_robot_sensor) -
                                motion.increment.phi;
        const double error = wrap(*d.bearing - expected);
        density += std::exp(-0.5 * square(error) / variance) / std::sqrt(kTwoPi * variance);
        ++count;
      }
      if (count > 0) sum += std::log(kNew / kTwoPi + (1 - kNew) * density / count);
    }
    scores[k] = sum;
  }
  return scores;
}

/// Delay of the maximum, by a parabola through it; nothing at an end.
std::optional<double> peakOf(const DelayScores& scores)
{
  Eigen::Index best = 0;
  scores.maxCoeff(&best);
  if (best == 0 || best + 1 == kTriedDelays) return std::nullopt;
  const double left = scores[best - 1], right = scores[best + 1], curvature = left - 2 * scores[best] + right;
  const double shift = curvature < 0 ? 0.5 * (left - right) / curvature : 0;
  return delayOf(static_cast<double>(best) + shift);
}

/// The peak of all pairs, with its deviation by leaving out one block of time after the other.
std::optional<RelativeDelay> jackknifed(const std::vector<DelayScores>& pairs)
{
  const auto count = static_cast<Eigen::Index>(pairs.size());
  if (count < kBlocks * kLeastPerBlock) return std::nullopt;
  Eigen::Array<double, kTriedDelays, kBlocks> blocks = Eigen::Array<double, kTriedDelays, kBlocks>::Zero();
  for (Eigen::Index i = 0; i < count; ++i) blocks.col(i * kBlocks / count) += pairs[static_cast<std::size_t>(i)];
  const DelayScores all = blocks.rowwise().sum();
  const std::optional<double> peak = peakOf(all);
  if (!peak) return std::nullopt;
  double squares = 0;
  for (Eigen::Index block = 0; block < kBlocks; ++block)
  {
    const std::optional<double> without = peakOf(all - blocks.col(block));
    if (!without) return std::nullopt;
    squares += square(*without - *peak);
  }
  // What lies between two of the tried delays is not told better than where it is uniform.
  return RelativeDelay{*peak, std::sqrt(squares * (kBlocks - 1) / kBlocks + square(kSpacing) / 12)};
}
}  // namespace

std::optional<RelativeDelay> delayWithoutMap(const std::vector<Reading>& readings, const OdometryPath& odometry,
                                             double typical_range)
{
  std::map<std::string, const Reading*> last;  // by sensor
  std::vector<DelayScores> pairs;
  for (const Reading& reading : readings)
  {
    if (reading.detections.empty()) continue;
    const Reading*& before = last[reading.sensor];
    if (before && reading.time > before->time && reading.time - before->time < kLongestPair)
      pairs.push_back(scoresOf(*before, reading, odometry, typical_range));
    before = &reading;
  }
  const std::optional<RelativeDelay> found = jackknifed(pairs);
  return found && found->std < kWorstStd ? found : std::nullopt;
}
}  // namespace mrpt_ext
