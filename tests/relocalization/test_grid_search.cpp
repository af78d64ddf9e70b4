#include "mrpt_ext/relocalization/grid_search.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_grid_search
{
namespace
{
WorkBudget unlimited;
constexpr double kStd = degToRad(1.0);
const PoseRegion kRoom{{-1, -1}, {9, 7}};

std::vector<Vector2d> landmarksOf(std::uint64_t seed)
{
  RandomStream random(seed);
  std::vector<Vector2d> landmarks(12);
  for (Vector2d& landmark : landmarks) landmark = {random.uniform(0, 8), random.uniform(0, 6)};
  return landmarks;
}

/// Bearings to six landmarks from two positions half a metre apart, with noise.
std::vector<WindowBearing> seenFrom(const Pose2& robot, const std::vector<Vector2d>& landmarks, RandomStream& random)
{
  std::vector<WindowBearing> seen;
  for (const Pose2& sensor : {Pose2{0, 0, 0}, Pose2{-0.5, 0.1, 0.4}})
    for (std::size_t k = 0; k < 6; ++k)
      seen.push_back({sensor, wrap(predictBearing(robot, landmarks[k], sensor) + kStd * random.gaussian()), kStd});
  return seen;
}

/// Within two cells in each coordinate.
bool covers(const GaussianPose& cell, const Pose2& pose)
{
  return std::abs(pose.x - cell.mean.x) < 2 * kGridCell && std::abs(pose.y - cell.mean.y) < 2 * kGridCell &&
         std::abs(wrap(pose.phi - cell.mean.phi)) < 2 * kGridTurn;
}

bool anyCovers(const std::vector<GaussianPose>& cells, std::size_t first, const Pose2& pose)
{
  return std::any_of(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(std::min(first, cells.size())),
                     [&](const GaussianPose& cell) { return covers(cell, pose); });
}

/// Number of rooms, of thirty, where the true pose is among the `first` maxima with so many outliers in twelve
/// bearings.
int roomsFound(std::uint64_t seed, std::size_t outliers, std::size_t first)
{
  RandomStream random(seed);
  int found = 0;
  for (std::uint64_t trial = 0; trial < 30; ++trial)
  {
    const std::vector<Vector2d> landmarks = landmarksOf(trial);
    const Pose2 robot{random.uniform(1, 7), random.uniform(1, 5), random.uniform(-kPi, kPi)};
    std::vector<WindowBearing> seen = seenFrom(robot, landmarks, random);
    for (std::size_t k = 0; k < outliers; ++k) seen[5 * k].bearing = random.uniform(-kPi, kPi);
    const auto cells = gridMaxima(seen, LandmarkIndex(landmarks), kRoom, unlimited);
    EXPECT_LE(cells.size(), kMostGridMaxima);
    found += anyCovers(cells, first, robot);
  }
  return found;
}
}  // namespace

TEST(GridMaxima, TheTruePoseIsAmongTheBestMaxima) { EXPECT_GE(roomsFound(4, 0, 20), 29); }

TEST(GridMaxima, OutliersDoNotHideIt) { EXPECT_GE(roomsFound(5, 2, 40), 28); }

TEST(GridMaxima, OnlyHeadingsOfTheRegionAreSearched)
{
  RandomStream random(6);
  const std::vector<Vector2d> landmarks = landmarksOf(1);
  PoseRegion region = kRoom;
  region.phi_low = 0.5;
  region.phi_span = 1;
  const auto cells = gridMaxima(seenFrom({3, 3, 1}, landmarks, random), LandmarkIndex(landmarks), region, unlimited);
  EXPECT_TRUE(anyCovers(cells, 10, {3, 3, 1}));
  for (const GaussianPose& cell : cells) EXPECT_TRUE(region.contains(cell.mean));
}

TEST(GridMaxima, ABearingShowsLandmarksOfItsCategoryOnly)
{
  std::vector<Landmark> posts{{.id = 1, .position = {4, 3, 0}, .category = "post"},
                              {.id = 2, .position = {0, 0, 0}, .category = "corner"}};
  const LandmarkTable table(posts);
  const LandmarkIndex index(table);
  RandomStream random(7);
  const Pose2 robot{2, 3, 0};
  std::vector<WindowBearing> seen;
  for (const Pose2& sensor : {Pose2{0, 0, 0}, Pose2{0, -1, 0}, Pose2{0, 1, 0}})
    seen.push_back({sensor, predictBearing(robot, {4, 3}, sensor), kStd, index.categoryOf("post")});
  const auto cells = gridMaxima(seen, index, kRoom, unlimited);
  ASSERT_FALSE(cells.empty());
  for (std::size_t k = 0; k < std::min<std::size_t>(5, cells.size()); ++k)  // two metres from the post, facing it
    EXPECT_NEAR((cells[k].mean.position() - Vector2d(4, 3)).norm(), 2, 0.7) << k;
}

TEST(GridMaxima, NothingWithoutBearingsOrInATooLargeRegion)
{
  RandomStream random(8);
  const std::vector<Vector2d> landmarks = landmarksOf(1);
  const LandmarkIndex index(landmarks);
  EXPECT_TRUE(gridMaxima({}, index, kRoom, unlimited).empty());
  const auto seen = seenFrom({3, 3, 1}, landmarks, random);
  EXPECT_TRUE(gridMaxima(seen, index, {{0, 0}, {1000, 1000}}, unlimited).empty());
}
}  // namespace mrpt_ext::test_grid_search
