#include "mrpt_ext/diagnosis/landmark_check.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext::test_landmark_check
{
namespace
{
const LandmarkTable kRoom({{.id = 1, .position = {0, 0, 0}},
                           {.id = 2, .position = {6, 0.5, 0}},
                           {.id = 3, .position = {5, 4, 0}},
                           {.id = 4, .position = {-1, 5, 0}},
                           {.id = 5, .position = {2, -3, 0}}});

/// Twenty frames that see all landmarks; `change` damages the detections.
template <typename Change>
LandmarkFaultFinding faultOf(const LandmarkTable& map, const Change& change)
{
  LandmarkCheck check(map);
  for (int k = 0; k < 20; ++k)
  {
    const Pose2 robot{1 + 0.1 * k, 1.5, 0.2 * k};
    Reading reading;
    for (const Landmark& landmark : kRoom.all())
    {
      Detection detection{.id = landmark.id, .std_bearing = 0.01, .std_range = 0.05};
      detection.bearing = predictBearing(robot, landmark.position.head<2>());
      detection.range = predictRange(robot, landmark.position.head<2>());
      change(detection);
      reading.detections.push_back(detection);
    }
    Frame frame;
    frame.readings.push_back(reading);
    check.add(frame);
  }
  return check.findFault();
}

void nothing(Detection&) {}
}  // namespace

TEST(LandmarkCheck, FramesThatFitTheMapLeaveTheMotion)
{
  EXPECT_EQ(faultOf(kRoom, nothing).fault, LandmarkFault::motion);
  EXPECT_EQ(faultOf(kRoom, [](Detection& d) { d.bearing = wrap(*d.bearing + 1); }).fault, LandmarkFault::motion)
      << "a turned sensor";
}

TEST(LandmarkCheck, FindsBearingsThatAreCountedClockwise)
{
  EXPECT_EQ(faultOf(kRoom, [](Detection& d) { d.bearing = -*d.bearing; }).fault, LandmarkFault::mirrored);
}

TEST(LandmarkCheck, FindsBearingsInRadians)
{
  EXPECT_EQ(faultOf(kRoom, [](Detection& d) { d.bearing = degToRad(*d.bearing); }).fault, LandmarkFault::radians);
  const auto bearings_alone = [](Detection& d)
  {
    d.bearing = degToRad(*d.bearing);
    d.range.reset();
  };
  EXPECT_EQ(faultOf(kRoom, bearings_alone).fault, LandmarkFault::radians)
      << "seen from far away all landmarks are straight ahead, too";
}

TEST(LandmarkCheck, NamesWhatToCheckWithoutAFrameThatTells)
{
  const std::string cause = LandmarkCheck(kRoom).cause();
  EXPECT_TRUE(cause.starts_with("check that the map is of this place")) << cause;
}

TEST(LandmarkCheck, FindsAMapInMillimetres)
{
  std::vector<Landmark> landmarks = kRoom.all();
  for (Landmark& landmark : landmarks) landmark.position *= 1000;
  const LandmarkFaultFinding found = faultOf(LandmarkTable(landmarks), nothing);
  EXPECT_EQ(found.fault, LandmarkFault::unit);
  EXPECT_EQ(found.factor, 0.001);
}

TEST(LandmarkCheck, AMapOfAnotherPlaceFitsInNoWay)
{
  EXPECT_EQ(faultOf(kRoom, [](Detection& d) { d.id = d.id % 5 + 1; }).fault, LandmarkFault::unknown);
}

TEST(LandmarkCheck, SpeaksUpOnlyIfMostLandmarksAreWrong)
{
  LandmarkCheck check(kRoom);
  Frame frame;
  frame.readings.emplace_back();
  for (const Landmark& landmark : kRoom.all())
    frame.readings[0].detections.push_back(
        {.id = landmark.id, .bearing = 0.1 * landmark.id, .range = 1, .std_bearing = 0.01, .std_range = 0.1});
  for (int k = 0; k < 20; ++k) check.add(frame);
  std::map<std::string, LandmarkRecord> landmarks;
  for (int id = 1; id <= 5; ++id) landmarks[std::to_string(id)] = {.seen = 100, .inlier_rate = id <= 2 ? 0.2 : 0.95};
  EXPECT_EQ(check.hint(landmarks), "");
  for (auto& [id, landmark] : landmarks) landmark.inlier_rate = 0.3;
  const std::string hint = check.hint(landmarks);
  EXPECT_TRUE(hint.starts_with("5 of 5 landmarks are often wrong")) << hint;
}
}  // namespace mrpt_ext::test_landmark_check
