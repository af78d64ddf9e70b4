#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/arc_motion.h"
#include "mrpt_ext/geometry/random.h"
#include "scratch_folder.h"
#include "whole_runs.h"

// A car with a laser scanner among reflective posts: from raw scans, speed and steering to a report in two commands.
namespace mrpt_ext::test_scans_to_report
{
namespace
{
namespace fs = std::filesystem;

constexpr double kWheelbase = 2, kWheelOffset = 0.5, kSpeed = 1, kSteering = 0.2;  // m, m, m/s, rad
constexpr double kStep = 0.1, kDuration = 20, kDiameter = 0.06;                    // s, s, m
constexpr Pose2 kStart{8, 3, 0.4}, kLaser{1.5, 0.2, 0.1};
constexpr int kBeams = 361;
const std::vector<Vector2d> kPosts{{0, 0}, {14, 1}, {17, 9}, {3, 13}, {11, 16}, {-2, 7}, {8, -3}};

double curvature() { return std::tan(kSteering) / kWheelbase; }

/// Pose of the scanner on the map.
Pose2 laserAt(double time) { return compose(compose(kStart, arcMotion(kSpeed, kSpeed * curvature(), time)), kLaser); }

std::string scanRow(double time, RandomStream& random)
{
  std::ostringstream ranges, intensities;
  for (int beam = 0; beam < kBeams; ++beam)
  {
    const double angle = degToRad(0.5 * beam - 90);
    const Vector2d way(std::cos(angle), std::sin(angle));
    double range = 0, intensity = 10;
    for (const Vector2d& post : kPosts)
    {
      const Vector2d centre = transform(inverse(laserAt(time)), post);
      const double along = way.dot(centre), across = way.x() * centre.y() - way.y() * centre.x();
      if (along < 0 || std::abs(across) > kDiameter / 2) continue;
      range = along - std::sqrt(square(kDiameter / 2) - square(across)) + 0.02 * random.gaussian();
      intensity = 1000;
    }
    ranges << ',' << range;
    intensities << ',' << intensity;
  }
  std::ostringstream row;
  row << time << ranges.str() << intensities.str() << '\n';
  return row.str();
}

void writeFiles(const testing::ScratchFolder& folder)
{
  std::ostringstream landmarks, odometry, scans, truth;
  landmarks << "id,x,y,z,category\n";
  for (const Vector2d& post : kPosts) landmarks << ',' << post.x() << ',' << post.y() << ",0,post\n";
  odometry << "t,speed_m_s,steering_rad\n";
  scans << 't';
  for (const char letter : {'r', 'i'})
    for (int beam = 0; beam < kBeams; ++beam) scans << ',' << letter << beam;
  scans << '\n';
  RandomStream random(5, 0);
  for (int k = 0; k * kStep <= kDuration; ++k)
  {
    const double time = k * kStep;
    const double wheel = kSpeed * (1 - curvature() * kWheelOffset);
    odometry << time << ',' << wheel + 0.02 * random.gaussian() << ',' << kSteering + 0.01 * random.gaussian() << '\n';
    const Pose2 laser = laserAt(time);
    truth << time << ' ' << laser.x << ' ' << laser.y << " 0 0 0 0 0\n";
    if (k % 2 == 0) scans << scanRow(time, random);
  }
  folder.write("landmarks.csv", landmarks.str());
  folder.write("odometry.csv", odometry.str());
  folder.write("scans.csv", scans.str());
  folder.write("ground_truth.tum", truth.str());
  folder.write("sensors.csv", "sensor,x,y,z,yaw_deg,first_bearing_deg,last_bearing_deg\nlaser,1.5,0.2,0.4," +
                                  std::to_string(radToDeg(kLaser.phi)) + ",-90,90\n");
}
}  // namespace

TEST(ScansToReport, TakesTwoCommands)
{
  const testing::ScratchFolder data, work;
  writeFiles(data);
  const testing::LogFiles log = testing::logFiles(work.path(), "log");
  const auto import = testing::convert({"csv", data.path(), "--wheelbase", std::to_string(kWheelbase), "--wheel-offset",
                                        std::to_string(kWheelOffset), "--base", "laser", "-o", log.rawlog});
  ASSERT_EQ(import.exit_code, 0) << import.err;
  EXPECT_NE(import.out.find("laser scans laser: 101, "), std::string::npos) << import.out;
  const auto summary = testing::summaryOf(testing::localized(
      work.path(), "reflectors",  // ini/landmark-localization/reflectors.ini
      testing::joined(log.arguments(),
                      {"--set", "Sensor_laser.intensity_above=500", "--set", "Sensor_laser.std_range_m=0.03", "--set",
                       "Sensor_laser.std_bearing_deg=0.2"})));
  EXPECT_EQ(summary.at("success_rate"), 1.0) << summary.at("verdict_reason");
  EXPECT_EQ(summary.at("verdict"), "ok") << summary.at("verdict_reason");
  EXPECT_LE(testing::positionRmse(summary), 0.05);
  EXPECT_EQ(summary.at("observations").at("CObservation2DRangeScan").at("used"), 101);
}

TEST(ScansToReport, WithoutExtractNothingCanBeScored)
{
  const testing::ScratchFolder data, work;
  writeFiles(data);
  const testing::LogFiles log = testing::logFiles(work.path(), "log");
  ASSERT_EQ(testing::convert({"csv", data.path(), "--wheelbase", "2", "-o", log.rawlog}).exit_code, 0);
  const auto outcome = testing::localize(
      testing::joined({testing::shipped("landmark-localization", "reflectors"), log.rawlog.string()},
                      {"--map", log.map.string(), "--set", "Sensor_laser.extract=none", "-o", work.path() / "run"}));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("of sensor 'laser', whose section has no extract = reflectors"), std::string::npos)
      << outcome.err;
}
}  // namespace mrpt_ext::test_scans_to_report
