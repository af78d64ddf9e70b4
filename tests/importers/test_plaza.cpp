#include "mrpt_ext/importers/plaza.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/geometry/input_error.h"
#include "sample_data.h"

namespace mrpt_ext::test_plaza
{
using testing::DamagedCopy;
using testing::hasNote;
using testing::recordsOf;

TEST(Plaza, RowsOfMotionBecomeArcsFromTheFirstRowOn)
{
  const auto odometry = recordsOf<OdometryRecord>(importPlaza(testing::sampleFolder("plaza")));
  ASSERT_EQ(odometry.size(), 4u);
  EXPECT_EQ(odometry[0].pose.vector(), Vector3d(0, 0, 0)) << "its motion was before the log";
  EXPECT_NEAR(odometry[1].pose.x, 0.2, 1e-12);
  EXPECT_NEAR(odometry[2].pose.x, 0.4, 1e-12);
  EXPECT_NEAR(odometry[2].pose.y, 0.2, 1e-12);
  EXPECT_NEAR(odometry[3].pose.phi, kPi / 2, 1e-12);
}

TEST(Plaza, RangesAreOrderedByTimeAndNothingIsLostSilently)
{
  const Recording recording = importPlaza(testing::sampleFolder("plaza"));
  const auto readings = recordsOf<Reading>(recording);
  ASSERT_EQ(readings.size(), 3u);
  EXPECT_EQ(readings[1].time, 100.30);
  EXPECT_EQ(readings[1].detections.at(0).id, 1);
  EXPECT_EQ(readings[1].detections.at(0).range, 3.5);
  EXPECT_FALSE(readings[1].detections.at(0).bearing);
  EXPECT_TRUE(readings[1].horizontal_range);
  EXPECT_EQ(readings[2].time, 100.35);
  EXPECT_TRUE(hasNote(recording, "warning: "));
  EXPECT_TRUE(hasNote(recording, "Lawn_TD.txt:4: time goes back to 100.30, rows were sorted"));
  EXPECT_TRUE(hasNote(recording, "5 rows of ranges"));
  EXPECT_TRUE(hasNote(recording, "1 ranges of 0 dropped"));
  EXPECT_TRUE(hasNote(recording, "1 ranges to beacons without a position dropped"));
  EXPECT_EQ(recording.map.size(), 3u);
  ASSERT_EQ(recording.truth.size(), 3u);
  EXPECT_NEAR(recording.truth[2].pose.phi, kPi / 2, 1e-12);
}

TEST(Plaza, TheRunMustBeGivenWhereTheFolderHasSeveral)
{
  const DamagedCopy copy("plaza");
  EXPECT_EQ(recordsOf<Reading>(importPlaza(copy.path() / "Lawn")).size(), 3u);
  EXPECT_EQ(recordsOf<Reading>(importPlaza(copy.path() / "Lawn_TD.txt")).size(), 3u);
  copy.replace("Yard_TD.txt", "");
  EXPECT_INPUT_ERROR((void)importPlaza(copy.path()), "holds several runs, expected one of");
  EXPECT_INPUT_ERROR((void)importPlaza(copy.path() / "Field"), "Field: no such folder or run");
  copy.remove("Yard_TD.txt");
  copy.remove("Lawn_TD.txt");
  EXPECT_INPUT_ERROR((void)importPlaza(copy.path()), "no file <run>_TD.txt in this folder");
}

TEST(Plaza, DamagedFilesAreNamedWithTheirLine)
{
  const DamagedCopy copy("plaza");
  const auto import = [&] { (void)importPlaza(copy.path()); };
  copy.replace("Lawn_TD.txt", "100.1 2 6 7.5\n100.3 2 6\n");
  EXPECT_INPUT_ERROR(import(), "Lawn_TD.txt:2: 3 fields, expected 4 (time,antenna,beacon,range)");
  copy.replace("Lawn_TD.txt", "100.1 2 6 7500\n");
  EXPECT_INPUT_ERROR(import(), "Lawn_TD.txt:1: range 7500, expected metres within 0 ... 500");
  copy.replace("Lawn_TD.txt", "100.1 2 6 -7.5\n");
  EXPECT_INPUT_ERROR(import(), "Lawn_TD.txt:1: range -7.5, expected metres");
  copy.replace("Lawn_TD.txt", "100.1 2 6.5 7.5\n");
  EXPECT_INPUT_ERROR(import(), "Lawn_TD.txt:1: '6.5' is not an integer, expected beacon");
  copy.replace("Lawn_DR.txt", "100.2 0.1 0\n100.1 0.1 0\n");
  EXPECT_INPUT_ERROR(import(), "Lawn_DR.txt:2: time 100.1 is before the row above");
  copy.replace("Lawn_DR.txt", "100.1 0.1 0\n100.1 0.1 0\n");
  EXPECT_INPUT_ERROR(import(), "Lawn_DR.txt:2: time 100.1 occurs twice");
  copy.replace("Lawn_DR.txt", "100.1 0.1 45\n");
  EXPECT_INPUT_ERROR(import(), "Lawn_DR.txt:1: turn 45, expected radians");
  copy.replace("Lawn_TL.txt", "1 0 0\n1 10 0\n");
  EXPECT_INPUT_ERROR(import(), "Lawn_TL.txt:2: beacon 1 is negative or occurs twice");
  copy.remove("Lawn_TL.txt");
  EXPECT_INPUT_ERROR(import(), "Lawn_TL.txt: no such file");
}

// The published scatter: 2.79 m mean error, 1.15 m standard deviation, and that the error grows with the distance.
TEST(PlazaRecordings, RangesFitTheTruth)
{
  const auto folder = testing::recordingsFolder("plaza");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << ", set LANDMARK_DATA_DIR";
  const Recording recording = importPlaza(folder / "Plaza1");
  EXPECT_FALSE(hasNote(recording, "truth heading was constantly off"));
  double sum = 0, squares = 0;
  std::size_t count = 0, next = 0;
  for (const Reading& reading : recordsOf<Reading>(recording))
  {
    while (next + 1 < recording.truth.size() && recording.truth[next].time < reading.time) ++next;
    const Detection& detection = reading.detections.at(0);
    const Vector3d beacon = recording.map[recording.map.indexOf(detection.id).value()].position;
    const double error = *detection.range - (recording.truth[next].pose.position() - beacon.head<2>()).norm();
    sum += error;
    squares += square(error);
    ++count;
  }
  const double mean = sum / static_cast<double>(count);
  EXPECT_EQ(count, 3529u);
  EXPECT_NEAR(mean, 2.79, 0.05);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(count) - square(mean)), kPlazaStdRange, 0.05);
}
}  // namespace mrpt_ext::test_plaza
