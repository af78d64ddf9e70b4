#include "mrpt_ext/importers/import_options.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/recording_notes.h"
#include "sample_data.h"

namespace mrpt_ext::test_import_options
{
using testing::hasNote;
using testing::recordsOf;

namespace
{
Reading readingOf(double time, const std::string& sensor, std::vector<Detection> detections)
{
  Reading reading;
  reading.time = time;
  reading.sensor = sensor;
  reading.detections = std::move(detections);
  return reading;
}

Recording smallRecording()
{
  Recording recording;
  recording.records = {
      OdometryRecord{0, {}},
      readingOf(1, "a", {{3, "pole", 0.1, 2.0, 0.01, 0.1}, {4, "", 0.2, std::nullopt, 0.01, 0}}),
      readingOf(2, "b", {{3, "pole", std::nullopt, 5.0, 0, 0.1}}),
  };
  recording.map = LandmarkTable({{3, {1, 1, 0}, "pole", {0, 0}}});
  return recording;
}
}  // namespace

TEST(HideIdentity, RemovesIdentityByLevel)
{
  Recording recording = smallRecording();
  hideIdentity(recording, IdentityLevel::known);
  EXPECT_EQ(recordsOf<Reading>(recording)[0].detections[0].id, 3);
  hideIdentity(recording, IdentityLevel::category);
  EXPECT_EQ(recordsOf<Reading>(recording)[0].detections[0].id, kNoId);
  EXPECT_EQ(recordsOf<Reading>(recording)[0].detections[0].category, "pole");
  hideIdentity(recording, IdentityLevel::anonymous);
  EXPECT_EQ(recordsOf<Reading>(recording)[0].detections[0].category, "");
  EXPECT_EQ(recording.map[0].id, 3);
  EXPECT_THROW(hideIdentity(recording, IdentityLevel::category), InputError);
}

TEST(KeepMeasurements, DropsAndCountsEmptyReadings)
{
  Recording bearings = smallRecording();
  keepMeasurements(bearings, MeasurementSelection::bearing);
  ASSERT_EQ(bearings.records.size(), 2u);
  EXPECT_FALSE(recordsOf<Reading>(bearings)[0].detections[0].range);
  EXPECT_TRUE(hasNote(bearings, "only bearings kept; 1 detections without one dropped, 1 readings left empty dropped"));

  Recording ranges = smallRecording();
  keepMeasurements(ranges, MeasurementSelection::range);
  ASSERT_EQ(recordsOf<Reading>(ranges).size(), 2u);
  ASSERT_EQ(recordsOf<Reading>(ranges)[0].detections.size(), 1u);
  EXPECT_FALSE(recordsOf<Reading>(ranges)[0].detections[0].bearing);
  EXPECT_THROW(keepMeasurements(ranges, MeasurementSelection::bearing), InputError);
}

TEST(DescribeRecording, CountsRepeatedIds)
{
  Recording recording = smallRecording();
  recording.records.push_back(readingOf(3, "c", {{3, "", 0.1, 2.0, 0.01, 0.1}, {3, "", 0.2, 2.0, 0.01, 0.1}}));
  const auto lines = describe(recording);
  EXPECT_NE(std::find(lines.begin(), lines.end(), "sensor c: 1 detections repeat an id of the same reading"),
            lines.end());
}

TEST(DescribeRecording, CountsCategoriesThatNoLandmarkHas)
{
  Recording recording = smallRecording();
  recording.records.push_back(
      readingOf(3, "c", {{kNoId, "pole", 0.1, 2.0, 0.01, 0.1}, {kNoId, "pillar", 0.2, 2.0, 0.01, 0.1}}));
  const auto lines = describe(recording);
  EXPECT_NE(std::find(lines.begin(), lines.end(), "sensor c: 1 detections have a category that no landmark has"),
            lines.end());
}

TEST(DescribeRecording, CountsRatesGapsAndUnknownIds)
{
  const auto lines = describe(smallRecording());
  const std::vector<std::string> expected = {"odometry: 1 records",
                                             "sensor a: 1 readings with 2 detections (2 bearings, 1 ranges)",
                                             "sensor a: at a reading the newest odometry is 1.000 s old (median), "
                                             "1.000 s at most; 1 reading after the last odometry",
                                             "sensor a: 1 detections have an id that is not in the map",
                                             "sensor b: 1 readings with 1 detections (0 bearings, 1 ranges)",
                                             "sensor b: at a reading the newest odometry is 2.000 s old (median), "
                                             "2.000 s at most; 1 reading after the last odometry",
                                             "truth: 0 poses",
                                             "map: 1 landmark"};
  EXPECT_EQ(lines, expected);
  Recording recording;
  for (const double time : {10.0, 11.0, 11.5, 14.0}) recording.records.emplace_back(OdometryRecord{time, {}});
  EXPECT_EQ(describe(recording)[0], "odometry: 4 records, 4.0 s, 0.75 per s, longest gap 2.50 s");
}
}  // namespace mrpt_ext::test_import_options
