#include <mrpt/obs/CRawlog.h>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"
#include "rawlog_samples.h"

namespace mrpt_ext::test_rawlog_round_trip
{
namespace
{
void expectSame(const OdometryRecord& a, const OdometryRecord& b)
{
  EXPECT_NEAR((a.pose.vector() - b.pose.vector()).norm(), 0, 1e-12);
}

void expectSame(const CompassRecord& a, const CompassRecord& b)
{
  EXPECT_EQ(a.sensor, b.sensor);
  EXPECT_NEAR(wrap(a.heading - b.heading), 0, 1e-12);
}

void expectSame(const Reading& a, const Reading& b)
{
  EXPECT_EQ(a.sensor, b.sensor);
  EXPECT_NEAR((a.T_robot_sensor.vector() - b.T_robot_sensor.vector()).norm(), 0, 1e-12);
  EXPECT_EQ(a.sensor_height, b.sensor_height);
  EXPECT_EQ(a.horizontal_range, b.horizontal_range);
  EXPECT_EQ(a.model.has_field_of_view, b.model.has_field_of_view);
  EXPECT_EQ(a.model.field_of_view, b.model.field_of_view);
  EXPECT_EQ(a.model.max_range, b.model.max_range);
  ASSERT_EQ(a.detections.size(), b.detections.size());
  for (std::size_t i = 0; i < a.detections.size(); ++i)
  {
    EXPECT_EQ(a.detections[i].id, b.detections[i].id);
    EXPECT_EQ(a.detections[i].category, b.detections[i].category);
    EXPECT_EQ(a.detections[i].bearing, b.detections[i].bearing);
    EXPECT_EQ(a.detections[i].range, b.detections[i].range);
    EXPECT_EQ(a.detections[i].std_bearing, b.detections[i].std_bearing);
    EXPECT_EQ(a.detections[i].std_range, b.detections[i].std_range);
  }
}

void expectSame(const RunningFixReading& a, const RunningFixReading& b)
{
  EXPECT_EQ(a.sensor, b.sensor);
  EXPECT_EQ(a.first_time, b.first_time);
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.first_range, b.first_range);
  EXPECT_EQ(a.second_std, b.second_std);
  EXPECT_NEAR((a.displacement.vector() - b.displacement.vector()).norm(), 0, 1e-12);
  EXPECT_EQ(a.displacement_covariance, b.displacement_covariance);
}

void expectSame(const RangeScan& a, const RangeScan& b)
{
  EXPECT_EQ(a.sensor, b.sensor);
  ASSERT_EQ(a.ranges.size(), b.ranges.size());
  for (std::size_t beam = 0; beam < a.ranges.size(); ++beam)
    EXPECT_NEAR(wrap(a.T_robot_sensor.phi + bearingOf(a, beam) - b.T_robot_sensor.phi - bearingOf(b, beam)), 0, 1e-6);
  EXPECT_EQ(a.ranges, b.ranges);
  EXPECT_EQ(a.intensities, b.intensities);
  EXPECT_NEAR(a.std_range, b.std_range, 1e-8);
}

RangeScan sampleScan(double first_bearing, double step)
{
  RangeScan scan;
  scan.time = 1;
  scan.sensor = "laser";
  scan.T_robot_sensor = {0.5, -0.25, 1};
  scan.sensor_height = 0.3;
  scan.first_bearing = first_bearing;
  scan.bearing_step = step;
  scan.std_range = 0.03;
  scan.ranges = {1.5F, 0, 200, 4};
  scan.intensities = {10, 0, 32768, 5};
  return scan;
}

class RawlogRoundTrip : public RawlogTest
{
};
}  // namespace

TEST_F(RawlogRoundTrip, EveryRecordComesBackInOrder)
{
  const Recording recording = sampleRecording(5);
  const auto path = inFolder("log.rawlog");
  writeRawlog(path, recording);
  const ReadResult result = readLog(path);
  ASSERT_EQ(result.error, "");
  ASSERT_EQ(result.records.size(), recording.records.size());
  for (std::size_t i = 0; i < recording.records.size(); ++i)
  {
    SCOPED_TRACE(i);
    EXPECT_EQ(timeOf(result.records[i]), timeOf(recording.records[i]));
    ASSERT_EQ(result.records[i].index(), recording.records[i].index());
    std::visit([&](const auto& b) { expectSame(std::get<std::decay_t<decltype(b)>>(result.records[i]), b); },
               recording.records[i]);
  }
}

TEST_F(RawlogRoundTrip, LaserScansComeBackWhereTheyAreWanted)
{
  const auto path = inFolder("log.rawlog");
  for (const RangeScan& scan : {sampleScan(-0.5, 0.2), sampleScan(0.5, -0.2)})
  {
    writeRawlog(path, {.records = {scan}, .map = {}, .truth = {}, .notes = {}});
    RawlogSource source(path, 1, [](const std::string& label) { return label == "laser"; });
    const auto records = readAll(source);
    ASSERT_EQ(records.size(), 1U);
    expectSame(std::get<RangeScan>(records[0]), scan);
    EXPECT_EQ(source.statistics().observations.at("CObservation2DRangeScan").used, 1U);
  }
  RawlogSource others(path, 1, [](const std::string& label) { return label == "rear"; });
  EXPECT_TRUE(readAll(others).empty());
  EXPECT_EQ(others.statistics().observations.at("CObservation2DRangeScan").ignored, 1U);
  RawlogSource none(path);
  EXPECT_TRUE(readAll(none).empty());
}

TEST_F(RawlogRoundTrip, StatisticsSayWhatWasThere)
{
  const auto path = inFolder("log.rawlog");
  writeRawlog(path, sampleRecording(5));
  const RawlogStatistics statistics = readLog(path).statistics;
  EXPECT_EQ(statistics.entries, 70U);
  EXPECT_EQ(statistics.observations.at("CObservationOdometry").used, 50U);
  EXPECT_EQ(statistics.observations.at("CObservationLandmarkBearings").used, 5U);
  EXPECT_EQ(statistics.observations.at("CObservationStereoRanges").total, 5U);
  EXPECT_EQ(statistics.observations.at("CObservationRunningFix").ignored, 0U);
  EXPECT_EQ(statistics.observations.at("CObservationIMU").used, 5U);
  EXPECT_TRUE(statistics.unusable.empty());
  EXPECT_NEAR(statistics.duration(), 4.9, 1e-9);
}

TEST_F(RawlogRoundTrip, TheSameRecordingGivesTheSameBytes)
{
  writeRawlog(inFolder("a.rawlog"), sampleRecording(3));
  writeRawlog(inFolder("b.rawlog"), sampleRecording(3));
  EXPECT_EQ(decompress(readBytes(inFolder("a.rawlog"))), decompress(readBytes(inFolder("b.rawlog"))));
  EXPECT_EQ(RawlogSource(inFolder("a.rawlog")).sha256(), RawlogSource(inFolder("b.rawlog")).sha256());
}

TEST_F(RawlogRoundTrip, MrptReadsItToo)
{
  const auto path = inFolder("log.rawlog");
  writeRawlog(path, sampleRecording(5));
  mrpt::obs::CRawlog rawlog;
  ASSERT_TRUE(rawlog.loadFromRawLogFile(path.string()));
  EXPECT_EQ(rawlog.size(), 70U);
  EXPECT_EQ(rawlog.getCommentText(), "entries=70");
}

TEST_F(RawlogRoundTrip, AnEmptyRecordingIsAnEmptyLog)
{
  writeRawlog(inFolder("log.rawlog"), Recording{});
  const ReadResult result = readLog(inFolder("log.rawlog"));
  EXPECT_EQ(result.error, "");
  EXPECT_TRUE(result.records.empty());
}

TEST_F(RawlogRoundTrip, ReadingsOfOneSensorBecomeOneClass)
{
  Recording recording;
  for (const double time : {1.0, 2.0})
  {
    Reading reading{.time = time, .sensor = "stereo"};
    reading.detections = {{.bearing = 0.5, .std_bearing = 0.1}};
    if (time > 1) reading.detections[0].range = 2;
    recording.records.emplace_back(reading);
  }
  writeRawlog(inFolder("log.rawlog"), recording);
  const ReadResult result = readLog(inFolder("log.rawlog"));
  EXPECT_EQ(result.statistics.observations.at("CObservationStereoRanges").used, 2U);
  EXPECT_FALSE(std::get<Reading>(result.records.at(0)).detections.at(0).range.has_value());
}

TEST_F(RawlogRoundTrip, RefusesWhatCannotBeALog)
{
  const auto path = inFolder("log.rawlog");
  Recording backwards = sampleRecording(1);
  std::swap(backwards.records.front(), backwards.records.back());
  EXPECT_THROW(writeRawlog(path, backwards), InputError);
  Recording timeless;
  timeless.records.emplace_back(OdometryRecord{.time = std::nan("")});
  EXPECT_THROW(writeRawlog(path, timeless), InputError);
  Recording anonymous;
  anonymous.records.emplace_back(Reading{.time = 1});
  EXPECT_THROW(writeRawlog(path, anonymous), InputError);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(RawlogRoundTrip, LeavesNothingBehindWhereItCannotWrite)
{
  writeBytes(inFolder("file"), "not a folder");
  EXPECT_THROW(writeRawlog(inFolder("file") / "log.rawlog", sampleRecording(1)), InputError);
  std::filesystem::create_directory(inFolder("taken.rawlog"));
  writeBytes(inFolder("taken.rawlog") / "inside", "x");
  EXPECT_THROW(writeRawlog(inFolder("taken.rawlog"), sampleRecording(1)), InputError);
  std::size_t left = 0;
  for (const auto& entry : std::filesystem::directory_iterator(inFolder("")))
    left += entry.path().filename() != "file" && entry.path().filename() != "taken.rawlog" ? 1 : 0;
  EXPECT_EQ(left, 0U);
}
}  // namespace mrpt_ext::test_rawlog_round_trip
