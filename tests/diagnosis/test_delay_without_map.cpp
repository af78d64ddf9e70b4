#include "mrpt_ext/diagnosis/delay_without_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_delay_without_map
{
namespace
{
constexpr double kTypicalRange = 4;                        // [m]
constexpr double kHalfView = degToRad(35.0), kStd = 0.01;  // [rad]
constexpr double kDuration = 200;                          // [s]

/// A robot that turns to and fro, `rate` [rad/s] at most, while it drives.
Pose2 robotAt(double t, double rate)
{
  return {0.1 * t, 0.5 * std::sin(0.1 * t), rate * (std::sin(0.9 * t) / 0.9 + 0.5 * std::sin(2.1 * t) / 2.1)};
}

OdometryPath odometryOf(double delay, double rate)
{
  std::vector<OdometryRecord> records;
  for (double t = -2; t < kDuration + 2; t += 0.05) records.push_back({t - delay, robotAt(t, rate)});
  return {records, {}};
}

/// A camera at 4 Hz among points, anonymous unless `identified`.
std::vector<Reading> readingsOf(double rate, bool identified, std::uint64_t seed)
{
  RandomStream random(seed);
  std::vector<Vector2d> points;
  for (int k = 0; k < 40; ++k) points.emplace_back(random.uniform(-6, 26), random.uniform(-6, 6));
  std::vector<Reading> readings;
  for (double t = 0; t < kDuration; t += 0.25)
  {
    Reading reading{.time = t, .sensor = "camera"};
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const Vector2d ray = transform(inverse(robotAt(t, rate)), points[k]);
      const double bearing = std::atan2(ray.y(), ray.x());
      if (std::abs(bearing) > kHalfView || ray.norm() > 6 || ray.norm() < 0.5 || random.uniform() < 0.3) continue;
      reading.detections.push_back({.id = identified ? static_cast<int>(k) + 1 : kNoId,
                                    .bearing = bearing + kStd * random.gaussian(),
                                    .std_bearing = kStd});
    }
    readings.push_back(reading);
  }
  return readings;
}

std::optional<RelativeDelay> found(const std::vector<Reading>& readings, const OdometryPath& odometry)
{
  return delayWithoutMap(readings, odometry, kTypicalRange);
}
}  // namespace

TEST(DelayWithoutMap, IsToldByWhatTurnsAcrossTheView)
{
  for (const bool identified : {false, true})
    for (const double delay : {-0.2, 0.0, 0.22, 0.6})
    {
      const auto told = found(readingsOf(0.5, identified, 7), odometryOf(delay, 0.5));
      ASSERT_TRUE(told) << delay;
      EXPECT_NEAR(told->delay, delay, 0.02) << delay;
      EXPECT_LT(told->std, 0.02);
    }
}

TEST(DelayWithoutMap, IsUnknownToARobotThatHardlyTurns)
{
  EXPECT_FALSE(found(readingsOf(0.002, false, 7), odometryOf(0.22, 0.002)));
}

TEST(DelayWithoutMap, NeedsReadingsThatFollowEachOther)
{
  std::vector<Reading> readings = readingsOf(0.5, false, 7);
  EXPECT_FALSE(found({}, odometryOf(0.22, 0.5)));
  readings.resize(60);
  EXPECT_FALSE(found(readings, odometryOf(0.22, 0.5)));
  std::vector<Reading> rare;
  for (std::size_t k = 0; k < 800; k += 8) rare.push_back(readingsOf(0.5, false, 7)[k]);
  EXPECT_FALSE(found(rare, odometryOf(0.22, 0.5)));
}
}  // namespace mrpt_ext::test_delay_without_map
