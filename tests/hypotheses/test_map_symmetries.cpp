#include "mrpt_ext/hypotheses/map_symmetries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_map_symmetries
{
namespace
{
constexpr double kPlaced = 0.03;  // [m] how well the maps are surveyed

Landmark at(double x, double y, const std::string& category = {})
{
  return {.position = {x, y, 0}, .category = category};
}

/// Drawn in the order of the braces, whatever the compiler.
Landmark between(const Vector2d& low, const Vector2d& high, RandomStream& random)
{
  return {.position = {random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()), 0}};
}

LandmarkTable surveyed(std::vector<Landmark> landmarks, RandomStream& random)
{
  for (Landmark& landmark : landmarks)
    landmark.position += Vector3d{kPlaced * random.gaussian(), kPlaced * random.gaussian(), 0};
  return LandmarkTable(std::move(landmarks));
}

std::vector<Landmark> scattered(std::size_t count, double side, RandomStream& random)
{
  std::vector<Landmark> landmarks;
  for (std::size_t k = 0; k < count; ++k) landmarks.push_back(between({0, 0}, {side, side}, random));
  return landmarks;
}

/// Every landmark of one half has a counterpart, turned by half a turn about the origin.
std::vector<Landmark> soccerField()
{
  std::vector<Landmark> field;
  for (const double s : {1.0, -1.0})
    for (const Landmark& half : {at(4.5, 0.8, "goalpost"), at(4.5, -0.8, "goalpost"), at(3.2, 0, "penalty"),
                                 at(4.5, 3, "corner"), at(4.5, -3, "corner"), at(0, 3, "tee"), at(0, 0.75, "cross")})
      field.push_back(at(s * half.position.x(), s * half.position.y(), half.category));
  return field;
}
}  // namespace

TEST(MapSymmetries, AFieldLooksTheSameFromItsOtherHalf)
{
  RandomStream random(1);
  for (int k = 0; k < 20; ++k)
  {
    const auto found = mapSymmetries(surveyed(soccerField(), random));
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().matched, 14u);
    EXPECT_LE(found.size() > 1 ? found[1].matched : 0u, 10u) << "posts for corners, and the like";
    EXPECT_NEAR(std::abs(found.front().motion.phi), kPi, 0.02);
    EXPECT_LT(found.front().motion.position().norm(), 0.1);
  }
}

TEST(MapSymmetries, WhatHasNoCounterpartIsWhereTheOtherHalfWouldSeeIt)
{
  RandomStream random(2);
  std::vector<Landmark> landmarks = soccerField();
  landmarks.push_back(at(-5.5, 1.5, "banner"));
  const LandmarkTable map = surveyed(landmarks, random);
  const auto found = mapSymmetries(map);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().matched, 14u);
  const LandmarkTable& image = found.front().image;
  ASSERT_EQ(image.size(), map.size());
  for (std::size_t k = 0; k < 14; ++k)
    EXPECT_EQ(image[k].position.head<2>(), map[(k + 7) % 14].position.head<2>()) << "exactly";
  const Vector2d there = transform(inverse(found.front().motion), map[14].position.head<2>());
  EXPECT_LT((image[14].position.head<2>() - there).norm(), 1e-12);
  EXPECT_GT((image[14].position.head<2>() - map[14].position.head<2>()).norm(), 10);
}

TEST(MapSymmetries, CategoriesStayWithTheirLandmarks)
{
  RandomStream random(3);
  std::vector<Landmark> landmarks = soccerField();
  for (std::size_t k = 0; k < 7; ++k) landmarks[k].category += " left";
  const auto found = mapSymmetries(surveyed(landmarks, random));
  ASSERT_FALSE(found.empty());
  for (std::size_t k = 0; k < 14; ++k) EXPECT_EQ(found.front().image[k].category, landmarks[k].category);
}

TEST(MapSymmetries, RowsGridsAndRings)
{
  RandomStream random(4);
  std::vector<Landmark> row, ring, grid;
  for (int k = 0; k < 10; ++k) row.push_back(at(3.0 * k, 0));
  for (int k = 0; k < 8; ++k)
    ring.push_back(at(5 * std::cos(k * std::numbers::pi / 4), 5 * std::sin(k * std::numbers::pi / 4)));
  for (int k = 0; k < 100; ++k) grid.push_back(at(4.0 * (k % 10), 4.0 * (k / 10)));
  // Shifts by one to five landmarks to either side, and half turns about eleven points.
  const auto of_row = mapSymmetries(surveyed(row, random));
  EXPECT_EQ(of_row.size(), kMostSymmetries);
  EXPECT_EQ(of_row.front().matched, 10u);
  EXPECT_EQ(of_row[1].matched, 9u);
  EXPECT_EQ(mapSymmetries(surveyed(ring, random)).size(), 7u);
  const auto of_grid = mapSymmetries(surveyed(grid, random));
  EXPECT_EQ(of_grid.size(), kMostSymmetries);
  EXPECT_EQ(of_grid[2].matched, 100u) << "three turns";
  EXPECT_EQ(of_grid[3].matched, 90u) << "a shift by one";
}

// Turned about the landmarks on the right, by little, the left ones are brought elsewhere and the right ones are not.
TEST(MapSymmetries, LandmarksThatStayWhereTheyAreAreNotMatched)
{
  std::vector<Landmark> landmarks{at(0, 0), at(0, 1.5), at(3, 4)};
  RandomStream random(6);
  for (int k = 0; k < 12; ++k) landmarks.push_back(between({60, 0}, {63, 3}, random));
  EXPECT_TRUE(mapSymmetries(LandmarkTable(landmarks)).empty());
}

TEST(MapSymmetries, ScatteredLandmarksSeldomHaveSome)
{
  int with = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
  {
    RandomStream random(seed);
    with += mapSymmetries(LandmarkTable(scattered(15, 10, random))).empty() ? 0 : 1;
    EXPECT_TRUE(mapSymmetries(LandmarkTable(scattered(100, 30, random))).empty()) << "seed " << seed;
  }
  EXPECT_LE(with, 8) << "by chance";
}

TEST(MapSymmetries, HalfOfALargeMapIsEnough)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    RandomStream random(seed);
    std::vector<Landmark> landmarks = scattered(100, 20, random), others = scattered(180, 30, random);
    for (std::size_t k = 1; k < landmarks.size(); ++k)  // no two that could be confused
      for (std::size_t j = 0; j < k; ++j)
        if ((landmarks[k].position - landmarks[j].position).norm() < 0.6)
          landmarks[k--] = scattered(1, 20, random)[0], j = k;

    const Pose2 motion{40, 10, 1};
    for (std::size_t k = 0; k < 100; ++k)
    {
      const Vector2d there = transform(motion, landmarks[k].position.head<2>());
      landmarks.push_back(at(there.x(), there.y()));
    }
    EXPECT_EQ(mapSymmetries(surveyed(landmarks, random)).size(), 2u) << "there and back, seed " << seed;
    for (const Landmark& other : others) landmarks.push_back(at(other.position.x(), other.position.y() - 100));
    EXPECT_TRUE(mapSymmetries(surveyed(landmarks, random)).empty()) << "less than half, seed " << seed;
  }
}

// Two rooms of six landmarks each, and some in the hall: from one to the other six of seventeen are matched.
TEST(MapSymmetries, ACopyOfARoomAndTheRestOfTheMap)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    RandomStream random(seed);
    std::vector<Landmark> landmarks = scattered(6, 7, random);
    for (std::size_t k = 0; k < 6; ++k)
      landmarks.push_back(at(landmarks[k].position.x() + 10, landmarks[k].position.y()));
    for (int k = 0; k < 5; ++k) landmarks.push_back(between({0, 9}, {20, 11}, random));
    const auto found = mapSymmetries(surveyed(landmarks, random));
    // A landmark of the hall can make another one beside it, turned by a few degrees.
    for (const double x : {10.0, -10.0})
      EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                              [&](const MapSymmetry& symmetry)
                              { return symmetry.matched >= 6 && std::abs(symmetry.motion.x - x) < 0.2; }))
          << "there and back, seed " << seed;
  }
}

TEST(MapSymmetries, FewOrFarTooManyLandmarks)
{
  RandomStream random(5);
  EXPECT_TRUE(mapSymmetries(LandmarkTable()).empty());
  EXPECT_TRUE(mapSymmetries(LandmarkTable({at(1, 2)})).empty());
  EXPECT_TRUE(mapSymmetries(LandmarkTable({at(1, 2), at(1, 2)})).empty()) << "two at one place";
  const auto of_two = mapSymmetries(LandmarkTable({at(1, 2), at(4, 2)}));
  ASSERT_EQ(of_two.size(), 1u);
  EXPECT_LT((transform(of_two.front().motion, {2.5, 2}) - Vector2d(2.5, 2)).norm(), 1e-9);
  EXPECT_TRUE(mapSymmetries(LandmarkTable(scattered(kMostForSymmetries + 1, 100, random))).empty());
}
}  // namespace mrpt_ext::test_map_symmetries
