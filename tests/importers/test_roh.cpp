#include "mrpt_ext/importers/roh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/geometry/input_error.h"
#include "sample_data.h"

namespace mrpt_ext::test_roh
{
using testing::DamagedCopy;
using testing::hasNote;
using testing::recordsOf;

TEST(Roh, EveryRowIsAReadingWithItsOwnStampAndPosition)
{
  const Recording recording = importRoh(testing::sampleFolder("roh"));
  const auto readings = recordsOf<Reading>(recording);
  ASSERT_EQ(readings.size(), 3u);
  ASSERT_EQ(recording.truth.size(), 3u);
  for (std::size_t i = 0; i < readings.size(); ++i)
  {
    EXPECT_EQ(readings[i].time, static_cast<double>(i + 1));
    EXPECT_EQ(recording.truth[i].time, readings[i].time);
    EXPECT_FALSE(recording.truth[i].heading_known);
    ASSERT_EQ(readings[i].detections.size(), 4u);
    EXPECT_FALSE(readings[i].detections[0].range);
  }
  EXPECT_EQ(readings[0].detections[1].id, 2);
  EXPECT_NEAR(*readings[0].detections[1].bearing, degToRad(-108.2), 1e-12);
  EXPECT_EQ(recording.truth[1].pose.position(), Vector2d(1.5, 1.5));
  EXPECT_EQ(recording.truth[2].pose.position(), Vector2d(3, 3));
  EXPECT_EQ(recording.map[3].position, Vector3d(0, 6, 0));
  EXPECT_TRUE(hasNote(recording, "2 positions"));
}

TEST(Roh, DamagedFilesAreNamedWithTheirLine)
{
  const DamagedCopy copy("roh");
  const auto import = [&] { (void)importRoh(copy.path()); };
  copy.replace("(X3.0,Y3.0).csv", "135,-135,-45\n");
  EXPECT_INPUT_ERROR(import(), "(X3.0,Y3.0).csv:1: 3 fields, expected 4");
  copy.replace("(X3.0,Y3.0).csv", "135,-135,,45\n");
  EXPECT_INPUT_ERROR(import(), "(X3.0,Y3.0).csv:1: '' is not a number, expected bearing_3");
  copy.replace("(X3.0,Y3.0).csv", "135,-135,-45,45\n135,-135,-45,400\n");
  EXPECT_INPUT_ERROR(import(), "(X3.0,Y3.0).csv:2: bearing 400, expected degrees within +-360");
  copy.remove("landmark.csv");
  EXPECT_INPUT_ERROR(import(), "landmark.csv: no such file");
  copy.remove("(X3.0,Y3.0).csv");
  copy.remove("(X1.5,Y1.5).csv");
  EXPECT_INPUT_ERROR(import(), "no file named like (X1.5,Y4.5).csv");
}

// At the true position the four bearings agree about the heading as well as the known scatter allows.
TEST(RohRecordings, BearingsFitTheTruePositions)
{
  const auto folder = testing::recordingsFolder("roh_angulation");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << ", set LANDMARK_DATA_DIR";
  const Recording recording = importRoh(folder);
  const auto readings = recordsOf<Reading>(recording);
  ASSERT_EQ(readings.size(), 1200u);
  double squares = 0;
  for (std::size_t i = 0; i < readings.size(); ++i)
  {
    Vector2d heading(0, 0);
    std::vector<double> headings;
    for (const Detection& detection : readings[i].detections)
    {
      const Vector2d d = recording.map[recording.map.indexOf(detection.id).value()].position.head<2>() -
                         recording.truth[i].pose.position();
      headings.push_back(std::atan2(d.y(), d.x()) - *detection.bearing);
      heading += Vector2d(std::cos(headings.back()), std::sin(headings.back()));
    }
    for (const double one : headings) squares += square(wrap(one - std::atan2(heading.y(), heading.x())));
  }
  EXPECT_NEAR(radToDeg(std::sqrt(squares / 4800)), 1.96, 0.02);
}
}  // namespace mrpt_ext::test_roh
