#include <gtest/gtest.h>

#include "../support/synthetic_field.h"
#include "mrpt_ext/vision/stereo/stereo_goal.h"

namespace mrpt_ext::test_floor_junctions
{
namespace
{
using testing::FieldPicture;
using testing::Marking;

/// Markings from a point in the given directions, turned by `turn` [rad].
FieldPicture star(const Eigen::Vector2d& position, const std::vector<double>& directions_deg, double turn = 0)
{
  FieldPicture picture;
  for (const double direction : directions_deg)
  {
    const double angle = degToRad(direction) + turn;
    picture.markings.push_back({position, position + 0.12 * Eigen::Vector2d(std::cos(angle), std::sin(angle))});
  }
  return picture;
}

std::vector<LineLandmark> landmarksOf(const FieldPicture& picture, int seed = 1)
{
  StereoGoalSettings settings;
  settings.camera = picture.camera;
  settings.with_corners = false;
  const auto pair = testing::paint(picture, seed);
  return viewStereoGoal(pair.left, pair.right, settings).landmarks;
}

void expectOnly(const FieldPicture& picture, JunctionKind kind, const Eigen::Vector2d& position)
{
  const auto landmarks = landmarksOf(picture);
  ASSERT_EQ(landmarks.size(), 1u) << nameOf(kind) << " at " << position.transpose();
  const LineLandmark& seen = landmarks.front();
  EXPECT_EQ(nameOf(seen.kind), std::string(nameOf(kind)));
  EXPECT_LT(std::abs(seen.measured.range - position.norm()), 3.5 * seen.measured.std_range);
  EXPECT_LT(std::abs(seen.measured.bearing - std::atan2(position.y(), position.x())), 3.5 * seen.measured.std_bearing);
}
}  // namespace

TEST(FloorJunctions, AreCrossingsTeesAndCorners)
{
  const Eigen::Vector2d position(0.28, 0.02);
  for (const double turn : {degToRad(15), degToRad(40), degToRad(65)})
  {
    expectOnly(star(position, {0, 90, 180, 270}, turn), JunctionKind::crossing, position);
    expectOnly(star(position, {90, 180, 270}, turn), JunctionKind::tee, position);
    expectOnly(star(position, {180, 270}, turn), JunctionKind::corner, position);
  }
}

TEST(FloorJunctions, OfAnArcWithALineAreCrossings)
{
  FieldPicture picture;
  const Eigen::Vector2d position(0.3, -0.02), centre(0.3, 0.23);
  for (int i = 0; i < 90; ++i)
  {
    const auto at = [&](int k)
    { return Eigen::Vector2d(centre + 0.25 * Eigen::Vector2d(std::cos(k * kTwoPi / 90), std::sin(k * kTwoPi / 90))); };
    picture.markings.push_back({at(i), at(i + 1)});
  }
  picture.markings.push_back({{0.25, 0.3}, {0.33, -0.212}});
  const auto landmarks = landmarksOf(picture);
  ASSERT_FALSE(landmarks.empty());
  const auto nearest =
      std::min_element(landmarks.begin(), landmarks.end(),
                       [&](const auto& a, const auto& b)
                       { return (a.measured.position - position).norm() < (b.measured.position - position).norm(); });
  EXPECT_EQ(nearest->kind, JunctionKind::crossing);
  EXPECT_LT((nearest->measured.position - position).norm(), 0.015);
}

TEST(FloorJunctions, OfAMarkingWithAWallAreTees)
{
  FieldPicture picture;
  picture.wall = 0.4;
  picture.markings.push_back({{0.2, 0.07}, {0.4, 0.03}});
  expectOnly(picture, JunctionKind::tee, {0.4, 0.03});
}

TEST(FloorJunctions, AreNoneAlongAStraightLineAndOnAnEmptyFloor)
{
  FieldPicture picture;
  EXPECT_TRUE(landmarksOf(picture).empty());
  picture.markings.push_back({{0.2, -0.3}, {0.4, 0.3}});
  EXPECT_TRUE(landmarksOf(picture).empty());
}

TEST(FloorJunctions, AreNotMadeOfWideStripes)
{
  FieldPicture picture = star({0.28, 0.02}, {15, 105, 195, 285});
  picture.line_width = 0.02;
  EXPECT_TRUE(landmarksOf(picture).empty());
}
}  // namespace mrpt_ext::test_floor_junctions
