#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/arc_motion.h"
#include "mrpt_ext/geometry/random.h"
#include "scratch_folder.h"
#include "whole_runs.h"

// A person with three CSV files gets a report in two commands.
namespace mrpt_ext::test_csv_to_report
{
namespace
{
namespace fs = std::filesystem;

constexpr double kSpeed = 0.4, kTurn = degToRad(12), kStep = 0.1, kDuration = 30;  // m/s, rad/s, s, s
constexpr Pose2 kStart{3, 1, 0.2};
const std::vector<Vector2d> kLandmarks{{0, 0}, {6, 0.5}, {5.5, 5}, {0.5, 4}, {3, 5.5}};

/// The robot drives a circle; a camera sees bearing and range of two landmarks twice a second, in turn.
void writeCsvFiles(const testing::ScratchFolder& folder)
{
  std::ostringstream landmarks, odometry, detections;
  landmarks << "id,x,y,z,category\n";
  for (std::size_t i = 0; i < kLandmarks.size(); ++i)
    landmarks << i + 1 << ',' << kLandmarks[i].x() << ',' << kLandmarks[i].y() << ",0,pole\n";
  odometry << "t,v,omega_deg_s\n";
  detections << "t,sensor,id,category,bearing_deg,range_m,std_bearing_deg,std_range_m\n";
  RandomStream random(7, 0);
  Pose2 pose = kStart;
  const int steps = static_cast<int>(std::lround(kDuration / kStep));
  for (int k = 0; k <= steps; ++k)
  {
    odometry << k * kStep << ',' << kSpeed + 0.01 * random.gaussian() << ','
             << radToDeg(kTurn) + 0.5 * random.gaussian() << '\n';
    if (k % 5 == 0)
      for (const int offset : {0, 2})
      {
        const auto i = static_cast<std::size_t>(k / 5 + offset) % kLandmarks.size();
        const Vector2d way = kLandmarks[i] - pose.position();
        detections << k * kStep << ",camera," << i + 1 << ",,"
                   << radToDeg(wrap(std::atan2(way.y(), way.x()) - pose.phi)) + random.gaussian() << ','
                   << way.norm() + 0.05 * random.gaussian() << ",1,0.05\n";
      }
    if (k < steps) pose = compose(pose, arcMotion(kSpeed, kTurn, kStep));
  }
  folder.write("landmarks.csv", landmarks.str());
  folder.write("odometry.csv", odometry.str());
  folder.write("detections.csv", detections.str());
}

Pose2 truthAt(double time) { return compose(kStart, arcMotion(kSpeed, kTurn, time)); }
}  // namespace

TEST(CsvToReport, TakesTwoCommands)
{
  const testing::ScratchFolder data, work;
  writeCsvFiles(data);
  // The configuration looks for the log beside itself, in ../../out/csv.
  const fs::path config = work.path() / "ini" / "landmark-localization" / "csv.ini";
  fs::create_directories(config.parent_path());
  fs::copy(testing::shipped("landmark-localization", "csv"), config);
  const fs::path log = work.path() / "out" / "csv" / "csv.rawlog", run = work.path() / "out" / "run";
  fs::create_directories(log.parent_path());

  const auto import = testing::convert({"csv", data.path(), "-o", log});
  ASSERT_EQ(import.exit_code, 0) << import.err;
  EXPECT_NE(import.out.find("sensor camera: 61 readings with 122 detections"), std::string::npos) << import.out;
  const auto localized = testing::localize({config, "-o", run});
  ASSERT_EQ(localized.exit_code, 0) << localized.err;

  EXPECT_NE(readTextFile(run / "report.html").find("particle_filter"), std::string::npos);
  const auto steps = testing::stepsOf(run);
  ASSERT_EQ(steps.size(), 61U);
  for (const testing::StepRow& step : steps)
  {
    if (step.time < 5) continue;
    const Pose2 truth = truthAt(step.time);
    EXPECT_LT(std::hypot(step.x - truth.x, step.y - truth.y), 0.25) << step.time;
    EXPECT_LT(std::abs(wrap(step.phi - truth.phi)), degToRad(5)) << step.time;
  }
}
}  // namespace mrpt_ext::test_csv_to_report
