// MRPT's own recording, as Debian's mrpt-common installs it, against its text view in the shared data.
#include <cstdlib>
#include <map>

#include "mrpt_ext/files/text_table.h"
#include "rawlog_samples.h"

namespace mrpt_ext::test_rawlog_uwb_demo
{
namespace
{
const std::filesystem::path kDemo = "/usr/share/mrpt/datasets/uwb_ro-localization_demo.rawlog";

std::filesystem::path textView()
{
  const char* folder = std::getenv("LANDMARK_DATA_DIR");
  return (folder ? std::filesystem::path(folder) : std::filesystem::path(MRPT_EXT_SOURCE_DIR) / "../shared/data") /
         "mrpt_uwb";
}

class RawlogUwbDemo : public RawlogTest
{
 protected:
  void SetUp() override
  {
    RawlogTest::SetUp();
    if (!std::filesystem::exists(kDemo)) GTEST_SKIP() << kDemo << " is not installed";
  }
};
}  // namespace

TEST_F(RawlogUwbDemo, IsReadCompletely)
{
  const ReadResult result = readLog(kDemo);
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.statistics.entries, 686U);
  const auto& observations = result.statistics.observations;
  EXPECT_EQ(observations.at("CActionRobotMovement2D").total, 343U);
  EXPECT_EQ(observations.at("CActionRobotMovement2D").ignored, 1U);  // the last one has neither time nor frame
  EXPECT_EQ(observations.at("CObservation2DRangeScan").ignored, 343U);
  EXPECT_EQ(observations.at("CObservationBeaconRanges").total, 339U);
  EXPECT_NEAR(result.statistics.duration(), 363.15, 0.01);
  double latest = 0;
  for (const Record& record : result.records)
  {
    EXPECT_GE(timeOf(record), latest);
    latest = timeOf(record);
    const auto* reading = std::get_if<Reading>(&record);
    EXPECT_TRUE(!reading || reading->sensor == "beacons");
  }
}

TEST_F(RawlogUwbDemo, MatchesItsTextView)
{
  if (!std::filesystem::exists(textView())) GTEST_SKIP() << "no text view in " << textView();
  std::map<std::pair<int, int>, std::pair<double, double>> expected;  // {step, beacon} -> {time, range}
  const TextTable table(textView() / "ranges.csv", {});
  for (std::size_t row = 0; row < table.size(); ++row)
    if (table.number(row, table.column("range_m")) > 0)
      expected[{table.integer(row, table.column("step")), table.integer(row, table.column("beacon"))}] = {
          table.number(row, table.column("t_unix")), table.number(row, table.column("range_m"))};
  RawlogSource source(kDemo);
  std::size_t compared = 0;
  while (const auto record = source.next())
  {
    const auto* reading = std::get_if<Reading>(&*record);
    if (!reading || !source.step()) continue;
    EXPECT_NEAR(reading->T_robot_sensor.x, 0.16, 1e-6);
    EXPECT_NEAR(reading->sensor_height, 1.12, 1e-6);
    for (const Detection& d : reading->detections)
    {
      const auto [time, range] = expected.at({static_cast<int>(*source.step()), d.id});
      EXPECT_NEAR(reading->time, time, 6e-4);
      EXPECT_NEAR(*d.range, range, 6e-5);
      ++compared;
    }
  }
  EXPECT_EQ(compared, expected.size());
  EXPECT_EQ(source.stepTimes().size(), 342U);
}

TEST_F(RawlogUwbDemo, OdometryIncrementsMatchTheTextView)
{
  if (!std::filesystem::exists(textView())) GTEST_SKIP() << "no text view in " << textView();
  const TextTable table(textView() / "odometry.csv", {});
  RawlogSource source(kDemo);
  Pose2 before;
  std::size_t compared = 0;
  while (const auto record = source.next())
  {
    const auto* odometry = std::get_if<OdometryRecord>(&*record);
    if (!odometry || !source.step()) continue;
    const Pose2 increment = between(before, odometry->pose);
    EXPECT_NEAR(increment.x, table.number(*source.step(), table.column("dx_m")), 6e-4);
    EXPECT_NEAR(increment.y, table.number(*source.step(), table.column("dy_m")), 6e-4);
    EXPECT_NEAR(increment.phi, degToRad(table.number(*source.step(), table.column("dphi_deg"))), degToRad(6e-3));
    before = odometry->pose;
    ++compared;
  }
  EXPECT_EQ(compared, table.size());
}
}  // namespace mrpt_ext::test_rawlog_uwb_demo
