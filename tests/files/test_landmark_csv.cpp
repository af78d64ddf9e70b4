#include "mrpt_ext/files/landmark_csv.h"

#include <gtest/gtest.h>

#include "error_message.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_landmark_csv
{
using testing::messageOf;
using testing::ScratchFolder;

TEST(LandmarkCsv, ColumnsAreFoundByName)
{
  const ScratchFolder folder;
  const LandmarkTable map =
      readLandmarkCsv(folder.write("map.csv", "category,y,x,id,std_y,std_x\npole,2,1,7,0.2,0.1\n,4,3,,,\n"));
  ASSERT_EQ(map.size(), 2u);
  EXPECT_EQ(map[0].id, 7);
  EXPECT_EQ(map[0].position, Vector3d(1, 2, 0));
  EXPECT_EQ(map[0].category, "pole");
  EXPECT_EQ(map[0].stddev, Vector2d(0.1, 0.2));
  EXPECT_EQ(map[1].id, kNoId);
  EXPECT_EQ(map[1].stddev, Vector2d(0, 0));
}

TEST(LandmarkCsv, WhatIsWrittenIsReadBackExactly)
{
  const ScratchFolder folder;
  const LandmarkTable map({{3, {0.1, -1.0 / 3, 2}, "edge", {0.00004570, 0}}, {kNoId, {1e-12, 5, 0}, "", {0, 0}}});
  writeLandmarkCsv(folder.path() / "map.csv", map);
  const LandmarkTable read = readLandmarkCsv(folder.path() / "map.csv");
  ASSERT_EQ(read.size(), map.size());
  for (std::size_t i = 0; i < map.size(); ++i)
  {
    EXPECT_EQ(read[i].id, map[i].id);
    EXPECT_EQ(read[i].position, map[i].position);
    EXPECT_EQ(read[i].category, map[i].category);
    EXPECT_EQ(read[i].stddev, map[i].stddev);
  }
}

TEST(LandmarkCsv, WithoutIdsAllLandmarksAreAnonymous)
{
  const ScratchFolder folder;
  const LandmarkTable read = readLandmarkCsv(folder.write("map.csv", "x,y\n4,0\n0,3\n"));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].id, kNoId);
  EXPECT_EQ(read[1].position, Vector3d(0, 3, 0));
}

TEST(LandmarkCsv, MistakesAreNamedWithTheirLine)
{
  const ScratchFolder folder;
  const auto read = [&](const std::string& content)
  { return messageOf<InputError>([&] { (void)readLandmarkCsv(folder.write("map.csv", content)); }); };
  EXPECT_NE(read("id,x,y\n1,0,0\n1,2,2\n").find("map.csv:3: landmark id 1 occurs twice"), std::string::npos);
  EXPECT_NE(read("id,x,y\n-4,0,0\n").find("map.csv:2: landmark id -4 is negative"), std::string::npos);
  EXPECT_NE(read("id,x,y\nA,0,0\n").find("map.csv:2: 'A' is not an integer"), std::string::npos);
  EXPECT_NE(read("x,y,yaw_deg\n0,0,400\n").find("map.csv:2: yaw_deg is out of range"), std::string::npos);
  EXPECT_NE(read("x,y,yaw_deg,std_yaw_deg\n0,0,4,-1\n").find("map.csv:2: std_yaw_deg is negative"), std::string::npos);
  EXPECT_NE(read("id,x\n1,0\n").find("map.csv:1: no column 'y'"), std::string::npos);
  EXPECT_NE(read("id,x,y,colour\n").find("map.csv:1: unknown column 'colour'"), std::string::npos);
  EXPECT_NE(read("id,x,y\n1,0,\n").find("map.csv:2: '' is not a number, expected y"), std::string::npos);
  EXPECT_NE(read("id,x,y,std_x\n1,0,0,-1\n").find("map.csv:2: std_x is negative"), std::string::npos);
}

TEST(LandmarkCsv, CategoryThatWouldBreakTheFileIsRejected)
{
  const ScratchFolder folder;
  EXPECT_THROW(writeLandmarkCsv(folder.path() / "map.csv", LandmarkTable({{1, {0, 0, 0}, "a,b", {0, 0}}})), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "map.csv"));
}

TEST(LandmarkCsv, DirectionsAreKept)
{
  const ScratchFolder folder;
  const LandmarkTable map =
      readLandmarkCsv(folder.write("map.csv", "id,x,y,yaw_deg,std_yaw_deg\n1,0,0,-90,2\n2,1,1,,\n3,2,2,33.3,\n"));
  EXPECT_NEAR(*map[0].yaw, -kPi / 2, 1e-12);
  EXPECT_NEAR(map[0].std_yaw, degToRad(2), 1e-12);
  EXPECT_FALSE(map[1].yaw);
  writeLandmarkCsv(folder.path() / "copy.csv", map);
  EXPECT_EQ(readTextFile(folder.path() / "copy.csv"),
            "id,x,y,z,category,yaw_deg,std_yaw_deg\n1,0,0,0,,-90,2\n2,1,1,0,,,\n3,2,2,0,,33.3,0\n");
}

TEST(LandmarkCsv, ColumnsOfDirectionsAreWrittenWhereTheyAreKnown)
{
  const ScratchFolder folder;
  const auto written = [&](const Landmark& landmark)
  {
    writeLandmarkCsv(folder.path() / "map.csv", LandmarkTable({landmark}));
    return readTextFile(folder.path() / "map.csv");
  };
  EXPECT_EQ(written({.id = 1, .position = {2, 3, 4}}), "id,x,y,z,category\n1,2,3,4,\n");
  EXPECT_EQ(written({.id = 1, .position = {2, 3, 4}, .stddev = {0.5, 0}, .yaw = kPi}),
            "id,x,y,z,category,std_x,std_y,yaw_deg\n1,2,3,4,,0.5,0,180\n");
}
}  // namespace mrpt_ext::test_landmark_csv
