#include "mrpt_ext/relocalization/trajectory_relocalizer.h"

#include <gtest/gtest.h>

#include "../hypotheses/exact_scene.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_trajectory_relocalizer
{
namespace
{
WorkBudget unlimited;
const PoseRegion kRegion{{-1, -1}, {9, 7}};
constexpr double kStd = degToRad(1.0);

LandmarkTable room()
{
  RandomStream random(11);
  std::vector<Landmark> landmarks(10);
  for (int k = 0; k < 10; ++k)
    landmarks[static_cast<std::size_t>(k)] = {.id = k, .position = {random.uniform(0, 8), random.uniform(0, 6), 0}};
  return LandmarkTable(std::move(landmarks));
}

/// A drive round the middle of the room: two landmarks a second, by bearing.
class Drive
{
 public:
  explicit Drive(bool identified = false) : identified_(identified) {}

  Frame next()
  {
    const Pose2 step = k_ > 0 ? Pose2{0.2, 0, 0.12} : Pose2{};
    robot_ = compose(robot_, step);
    Reading reading =
        seenFrom(robot_, map_, {k_ % 10, (k_ + 3) % 10}, {.identified = identified_, .std_bearing = kStd});
    for (Detection& d : reading.detections) d.bearing = wrap(*d.bearing + kStd * random_.gaussian());
    Frame frame{
        .time = static_cast<double>(k_), .motion = {step, 0.2, 0.12, k_ > 0 ? 1.0 : 0.0}, .readings = {reading}};
    ++k_;
    return frame;
  }
  [[nodiscard]] const Pose2& robot() const { return robot_; }
  [[nodiscard]] const LandmarkTable& map() const { return map_; }

 private:
  LandmarkTable map_ = room();
  RandomStream random_{5};
  Pose2 robot_{5, 1.5, 0.2};
  std::size_t k_ = 0;
  bool identified_;
};

TrajectoryRelocalizer relocalizerOf(const Drive& drive)
{
  return {drive.map(),
          std::make_shared<const GlobalPoseSearch>(drive.map()),
          kRegion,
          {.std_phi_per_deg = 0.1, .std_phi_per_m = 0.02, .std_phi_per_s = 0.005}};
}

ModeSet modesAt(const Pose2& pose) { return {{{{pose, Vector3d(0.01, 0.01, 0.001).asDiagonal()}, 1}}, {}}; }
}  // namespace

TEST(TrajectoryRelocalizer, FindsThePoseByTheWholeTrajectory)
{
  Drive drive;
  TrajectoryRelocalizer relocalizer = relocalizerOf(drive);
  for (int k = 0; k < 30; ++k) relocalizer.add(drive.next());
  EXPECT_TRUE(relocalizer.isApplicable());
  const HypothesisSet found = relocalizer.search({}, unlimited);
  ASSERT_FALSE(found.empty());
  EXPECT_GT(found.front().weight, 0.8);
  EXPECT_LT(distance(found.front().pose.mean, drive.robot()), 0.3);
  EXPECT_LT(turned(found.front().pose.mean, drive.robot()), degToRad(8));
}

TEST(TrajectoryRelocalizer, CurrentModesCompete)
{
  Drive drive;
  TrajectoryRelocalizer relocalizer = relocalizerOf(drive);
  for (int k = 0; k < 29; ++k) relocalizer.add(drive.next());
  const Pose2 before = drive.robot();
  relocalizer.add(drive.next());
  const HypothesisSet found = relocalizer.search(modesAt(compose({0.1, 0, 0}, before)), unlimited);
  ASSERT_FALSE(found.empty());
  EXPECT_LT(distance(found.front().pose.mean, drive.robot()), 0.3);
}

TEST(TrajectoryRelocalizer, TheIntervalDoublesWithEverySearchUntilItIsReset)
{
  Drive drive;
  TrajectoryRelocalizer relocalizer = relocalizerOf(drive);
  std::vector<int> searched;
  for (int k = 0; k < 60; ++k)
  {
    relocalizer.add(drive.next());
    if (k >= 9 && !relocalizer.search({}, unlimited).empty()) searched.push_back(k);
  }
  EXPECT_EQ(searched, (std::vector<int>{9, 19, 39}));  // at once, then after 10, 20, 40 s
  relocalizer.resetInterval();
  relocalizer.add(drive.next());
  EXPECT_FALSE(relocalizer.search({}, unlimited).empty());
}

TEST(TrajectoryRelocalizer, IsNotApplicableToIdentifiedDetections)
{
  Drive anonymous, identified(true);
  TrajectoryRelocalizer relocalizer = relocalizerOf(anonymous);
  EXPECT_FALSE(relocalizer.isApplicable());
  EXPECT_TRUE(relocalizer.search({}, unlimited).empty());
  relocalizer.add(anonymous.next());
  EXPECT_TRUE(relocalizer.isApplicable());
  relocalizer.add(identified.next());
  EXPECT_FALSE(relocalizer.isApplicable());
}
}  // namespace mrpt_ext::test_trajectory_relocalizer
