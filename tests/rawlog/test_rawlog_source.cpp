#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationBeaconRanges.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRange.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <limits>

#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/rawlog/rawlog_file_check.h"
#include "rawlog_samples.h"

namespace mrpt_ext::test_rawlog_source
{
namespace
{
using mrpt::serialization::CSerializable;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kNoTime = -1e9;

mrpt::system::TTimeStamp stampOf(double time) { return time == kNoTime ? INVALID_TIMESTAMP : timestampOf(time); }

CSerializable::Ptr action(double time, const Pose2& increment)
{
  mrpt::obs::CActionRobotMovement2D move;
  move.timestamp = stampOf(time);
  move.computeFromOdometry({increment.x, increment.y, increment.phi}, {});
  auto actions = mrpt::obs::CActionCollection::Create();
  actions->insert(move);
  return actions;
}

mrpt::obs::CObservationBeaconRanges::Ptr beacons(double time, const std::vector<float>& ranges)
{
  auto observation = mrpt::obs::CObservationBeaconRanges::Create();
  observation->timestamp = stampOf(time);
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    observation->sensedData.emplace_back();
    observation->sensedData.back().beaconID = static_cast<int>(i);
    observation->sensedData.back().sensedDistance = ranges[i];
  }
  return observation;
}

mrpt::obs::CObservation::Ptr sonar(double time)
{
  auto observation = mrpt::obs::CObservationRange::Create();
  observation->timestamp = stampOf(time);
  return observation;
}

CSerializable::Ptr frame(const std::vector<mrpt::obs::CObservation::Ptr>& observations)
{
  auto sensory_frame = mrpt::obs::CSensoryFrame::Create();
  for (const auto& observation : observations) sensory_frame->insert(observation);
  return sensory_frame;
}

mrpt::obs::CObservationOdometry::Ptr odometry(double time, double x, const std::string& label = "odometry")
{
  auto observation = mrpt::obs::CObservationOdometry::Create();
  observation->timestamp = stampOf(time);
  observation->sensorLabel = label;
  observation->odometry.x(x);
  return observation;
}

class RawlogSourceTest : public RawlogTest
{
 protected:
  [[nodiscard]] ReadResult read(const std::vector<CSerializable::Ptr>& objects) const
  {
    writeObjects(inFolder("log.rawlog"), objects);
    return readLog(inFolder("log.rawlog"));
  }
};
}  // namespace

TEST_F(RawlogSourceTest, PairsGiveDeadReckoningAtTheTimeOfTheirFrame)
{
  writeObjects(inFolder("log.rawlog"),
               {frame({sonar(9.9), beacons(kNoTime, {1})}), action(10, {1, 0, kPi / 2}),
                frame({sonar(10.5), beacons(kNoTime, {2, 3})}), action(11, {1, 0, 0}), frame({beacons(11.25, {4})}),
                action(12, {0, 1, 0}), frame({beacons(kNoTime, {5})})});
  RawlogSource source(inFolder("log.rawlog"));
  std::vector<std::pair<double, std::optional<std::size_t>>> odometry_at, readings_at;
  Pose2 last;
  while (const auto record = source.next())
  {
    auto& list = std::holds_alternative<OdometryRecord>(*record) ? odometry_at : readings_at;
    list.emplace_back(timeOf(*record), source.step());
    if (const auto* o = std::get_if<OdometryRecord>(&*record)) last = o->pose;
  }
  using Times = decltype(odometry_at);
  // The first frame is before any action: its pose is the origin, it belongs to no step.
  EXPECT_EQ(odometry_at, (Times{{9.9, std::nullopt}, {10.5, 0}, {11.25, 1}, {12, 2}}));
  EXPECT_EQ(readings_at, (Times{{9.9, std::nullopt}, {10.5, 0}, {11.25, 1}, {12, 2}}));
  EXPECT_EQ(source.stepTimes(), (std::vector<double>{10.5, 11.25, 12}));
  EXPECT_NEAR(last.x, 0, 1e-9);  // (1, 0) turned left, then 1 ahead, then 1 to the left
  EXPECT_NEAR(last.y, 1, 1e-9);
  EXPECT_NEAR(last.phi, kPi / 2, 1e-9);
  EXPECT_EQ(source.statistics().observations.at("CObservationRange").ignored, 2U);
  EXPECT_EQ(source.statistics().observations.at("CActionRobotMovement2D").used, 3U);
}

TEST_F(RawlogSourceTest, ReadingsWithoutAnyTimeAreCountedNotGuessed)
{
  const ReadResult result =
      read({beacons(kNoTime, {1}), odometry(kNoTime, 1), odometry(1, 1), action(kNoTime, {1, 0, 0})});
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.records.size(), 1U);
  EXPECT_EQ(result.statistics.unusable.at("CObservationBeaconRanges: no time stamp"), 1U);
  EXPECT_EQ(result.statistics.unusable.at("CObservationOdometry: no time stamp"), 1U);
}

TEST_F(RawlogSourceTest, UnusableDetectionsAreCountedWithTheirReason)
{
  const ReadResult result = read(
      {beacons(1, {2, 0, -1, static_cast<float>(kNan)}), beacons(2, {0}), beacons(3, {}), odometry(4, kNan), sonar(5)});
  ASSERT_EQ(result.records.size(), 1U);
  EXPECT_EQ(std::get<Reading>(result.records[0]).detections.size(), 1U);
  const UnusableCounts expected = {{"CObservationBeaconRanges: range not positive", 3},
                                   {"CObservationBeaconRanges: range not finite", 1},
                                   {"CObservationBeaconRanges: no usable detection", 1},
                                   {"CObservationBeaconRanges: no detections", 1},
                                   {"CObservationOdometry: not finite", 1},
                                   {"CObservationRange: not about landmarks or motion", 1}};
  EXPECT_EQ(result.statistics.unusable, expected);
  EXPECT_EQ(result.statistics.observations.at("CObservationBeaconRanges").total, 3U);
  EXPECT_EQ(result.statistics.observations.at("CObservationBeaconRanges").used, 1U);
  EXPECT_EQ(result.statistics.observations.at("CObservationBeaconRanges").ignored, 2U);
}

TEST_F(RawlogSourceTest, EmptyLabelsGetAStableName)
{
  EXPECT_EQ(std::get<Reading>(read({beacons(1, {2})}).records.at(0)).sensor, "beacons");
}

TEST_F(RawlogSourceTest, SmallDisorderIsSorted)
{
  const ReadResult result = read({odometry(1.0, 1), odometry(1.4, 2), beacons(1.2, {3}), beacons(1.4, {4}),
                                  odometry(3, 3), odometry(2.5, 4), odometry(2.2, 5), odometry(5, 6)});
  ASSERT_EQ(result.error, "");
  std::vector<double> times;
  for (const Record& record : result.records) times.push_back(timeOf(record));
  EXPECT_EQ(times, (std::vector<double>{1.0, 1.2, 1.4, 1.4, 2.2, 2.5, 3, 5}));
}

TEST_F(RawlogSourceTest, OdometryComesBeforeWhatWasMeasuredAtTheSameTime)
{
  const ReadResult result = read({beacons(1, {3}), odometry(1, 1)});
  EXPECT_TRUE(std::holds_alternative<OdometryRecord>(result.records.at(0)));
}

TEST_F(RawlogSourceTest, LargeDisorderIsAnError)
{
  const ReadResult result = read({odometry(10, 1), odometry(12, 2), odometry(4, 3)});
  EXPECT_NE(result.error.find("record 2: its time 4.000 s is 8.000 s before"), std::string::npos) << result.error;
}

TEST_F(RawlogSourceTest, OnlyOneSourceOfOdometryIsFollowed)
{
  const ReadResult result =
      read({odometry(1, 1, "wheels"), odometry(1.1, 100, "visual"), odometry(2, 2, "wheels"), action(2.1, {1, 0, 0})});
  EXPECT_EQ(result.records.size(), 2U);
  EXPECT_EQ(result.statistics.unusable.at("CObservationOdometry: a second source of odometry"), 1U);
  EXPECT_EQ(result.statistics.unusable.at("CActionRobotMovement2D: a second source of odometry"), 1U);
}

TEST_F(RawlogSourceTest, CompassIsAnAbsoluteYawLessTheMounting)
{
  auto imu = mrpt::obs::CObservationIMU::Create();
  imu->timestamp = timestampOf(1);
  imu->sensorPose = mrpt::poses::CPose3D(0, 0, 0, 0.5, 0, 0);
  imu->set(mrpt::obs::IMU_YAW, -3.0);
  auto gyro = mrpt::obs::CObservationIMU::Create();
  gyro->timestamp = timestampOf(2);
  gyro->set(mrpt::obs::IMU_YAW_VEL, 0.1);
  const ReadResult result = read({imu, gyro});
  ASSERT_EQ(result.records.size(), 1U);
  EXPECT_NEAR(std::get<CompassRecord>(result.records[0]).heading, 2 * kPi - 3.5, 1e-12);
  EXPECT_EQ(std::get<CompassRecord>(result.records[0]).sensor, "compass");
  EXPECT_EQ(result.statistics.unusable.at("CObservationIMU: no absolute yaw"), 1U);
}

TEST_F(RawlogSourceTest, ConsecutiveActionsAddUp)
{
  const ReadResult result = read({action(1, {1, 0, 0}), action(2, {1, 0, 0}), frame({sonar(3)}), action(4, {1, 0, 0})});
  ASSERT_EQ(result.records.size(), 2U);
  EXPECT_EQ(std::get<OdometryRecord>(result.records[0]).pose.x, 2);
  EXPECT_EQ(timeOf(result.records[1]), 4);  // no frame after it: its own time
  EXPECT_EQ(std::get<OdometryRecord>(result.records[1]).pose.x, 3);
}

// Known answer: FIPS 180-4 example "abc".
TEST_F(RawlogSourceTest, Sha256IsThatOfTheFile)
{
  writeBytes(inFolder("abc"), "abc");
  EXPECT_EQ(checkRawlogFile(inFolder("abc")).sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}
}  // namespace mrpt_ext::test_rawlog_source
