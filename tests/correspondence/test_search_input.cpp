#include "mrpt_ext/correspondence/search_input.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_search_input
{
namespace
{
Scan scanOf(int detections)
{
  Scan scan;
  scan.model.detection_probability = 0.7;
  for (int d = 0; d < detections; ++d) scan.detections.push_back({.bearing = 0.01 * d, .std_bearing = 0.001});
  return scan;
}
}  // namespace

TEST(SearchInput, ScansOfUsualSizeStayAsTheyAre)
{
  const std::vector<Scan> scans{scanOf(5), scanOf(8)};
  EXPECT_EQ(SearchInput(scans, 8).scans().data(), scans.data());
}

TEST(SearchInput, OfManyDetectionsSomeInAllDirectionsAreSearched)
{
  const std::vector<Scan> scans{scanOf(5), scanOf(800)};
  const SearchInput input(scans, 8);
  ASSERT_EQ(input.scans().size(), 2u);
  EXPECT_EQ(input.scans()[0].detections.size(), 5u);
  EXPECT_TRUE(input.scans()[0].model.detection_probability);
  const Scan& cut = input.scans()[1];
  ASSERT_EQ(cut.detections.size(), 8u);
  EXPECT_FALSE(cut.model.detection_probability) << "what was left out was not missed";
  for (std::size_t d = 0; d < 8; ++d)
    EXPECT_NEAR(*cut.detections[d].bearing, static_cast<double>(d), 1e-9) << "every hundredth";
  PoseSearchResult result;
  result.poses.push_back({.assignment = {1, 2, 3, 4, 5, 10, 11, 12, 13, 14, 15, 16, 17}});
  input.restore(result);
  const std::vector<int>& assignment = result.poses.front().assignment;
  ASSERT_EQ(assignment.size(), 805u);
  EXPECT_EQ(assignment[4], 5);
  EXPECT_EQ(assignment[5], 10);
  EXPECT_EQ(assignment[105], 11);
  EXPECT_EQ(assignment[106], -1);
}

TEST(SearchInput, OfManyScansTheNewestIsAmongTheChosen)
{
  std::vector<Scan> scans(1000, scanOf(1));
  scans.back().detections.front().bearing = 3;
  const SearchInput input(scans, 8);
  ASSERT_EQ(input.scans().size(), SearchInput::kMostScans);
  EXPECT_EQ(input.scans().back().detections.front().bearing, 3);
}

TEST(SearchInput, LargeMapsAreGivenMoreWork)
{
  EXPECT_LT(mostSearchWork(3), mostSearchWork(10'000));
  EXPECT_LT(mostSearchWork(10'000), 800'000'000u) << "below a second";
  EXPECT_LT(mostStepWork(10'000), 500'000'000u) << "half a second, as a step does more than to search";
}

TEST(SearchInput, FarMoreDetectionsThanLandmarksHoldNoPose)
{
  const std::vector<Scan> scans{scanOf(1000)};
  EXPECT_FALSE(SearchInput(scans, 32).isPromising(20));
  EXPECT_TRUE(SearchInput(scans, 32).isPromising(500));
  EXPECT_TRUE(SearchInput(std::span(scans).first(0), 32).isPromising(1));
  const std::vector<Scan> usual{scanOf(30)};
  EXPECT_TRUE(SearchInput(usual, 32).isPromising(3));
}
}  // namespace mrpt_ext::test_search_input
