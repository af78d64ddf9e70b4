#include "mrpt_ext/vision/stereo/upright_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "../support/synthetic_field.h"

namespace mrpt_ext::test_upright_edges
{
namespace
{
constexpr double kColumn = 150.3, kDisparity = 8.6;  ///< [px] of the edge in row 100
const EdgeWindow kWindow{95, 105, 150, 10};

/// White to the left of an edge, yellow to its right. The edge moves by `slope` columns per row.
cv::Mat withEdge(double column, double slope)
{
  cv::Mat image(240, 320, CV_8UC3);
  for (int row = 0; row < image.rows; ++row)
    for (int u = 0; u < image.cols; ++u)
    {
      const double white = std::clamp(column + slope * (row - 100) - u + 0.5, 0.0, 1.0);
      image.at<cv::Vec3b>(row, u) = cv::Vec3d(white * testing::kWhite + (1 - white) * testing::kYellow);
    }
  return image;
}

/// The same with a goal's side in the shade, so many pixels wide, between white and yellow. Pixels sum light.
cv::Mat withSide(double column, double wide)
{
  cv::Mat image(240, 320, CV_8UC3);
  for (int u = 0; u < image.cols; ++u)
  {
    const double white = std::clamp(column - u + 0.5, 0.0, 1.0),
                 yellow = 1 - std::clamp(column + wide - u + 0.5, 0.0, 1.0);
    const cv::Vec3d light = white * testing::kWhite.mul(testing::kWhite) +
                            (0.5 * (1 - white - yellow) + yellow) * testing::kYellow.mul(testing::kYellow);
    image.col(u).setTo(cv::Scalar(std::sqrt(light[0]), std::sqrt(light[1]), std::sqrt(light[2])));
  }
  return image;
}

std::vector<UprightEdge> edgesOf(const cv::Mat& left, const cv::Mat& right)
{
  StereoCamera camera = testing::smallCamera();
  camera.pitch = 0;
  const GoalColour yellow;
  return UprightEdges(left, right, camera, {4, 20, 5, 0.1, 0.1}).in(kWindow, {&yellow, 1});
}
}  // namespace

TEST(UprightEdges, AreWhereBothImagesShowThem)
{
  const auto edges = edgesOf(withEdge(kColumn, 0), withEdge(kColumn - kDisparity, 0));
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_NEAR(edges[0].middle.x, kColumn, 0.15);  // of a step that is one pixel wide no more is known
  EXPECT_NEAR(edges[0].disparity, kDisparity, 0.2);
  EXPECT_EQ(edges[0].rows.size(), 11u);
}

TEST(UprightEdges, MayLeanByTheRollOfACameraButNotMore)
{
  for (const double slope : {-0.05, 0.05})
    EXPECT_EQ(edgesOf(withEdge(kColumn, slope), withEdge(kColumn - kDisparity, slope)).size(), 1u) << slope;
  for (const double slope : {-0.8, -0.3, 0.3, 0.8})
    EXPECT_TRUE(edgesOf(withEdge(kColumn, slope), withEdge(kColumn - kDisparity, slope)).empty()) << slope;
}

TEST(UprightEdges, RowsThatMoveTogetherCountLess)
{
  const std::vector<double> together{-0.2, -0.2, -0.2, -0.1, -0.1, 0, 0.1, 0.1, 0.2, 0.2, 0.2},
      apart{-0.2, 0.2, -0.1, 0.2, -0.2, 0.1, -0.1, 0.2, -0.2, 0.1, 0};
  const auto stdWith = [](const std::vector<double>& moves)
  {
    cv::Mat left = withEdge(kColumn, 0);
    for (int row = kWindow.first_row; row <= kWindow.last_row; ++row)
      withEdge(kColumn + moves[static_cast<std::size_t>(row - kWindow.first_row)], 0).row(row).copyTo(left.row(row));
    const auto edges = edgesOf(left, withEdge(kColumn - kDisparity, 0));
    return edges.size() == 1 ? edges[0].std_disparity : 0;
  };
  EXPECT_GT(stdWith(apart), 0.1);
  EXPECT_GT(stdWith(together), 1.2 * stdWith(apart));
}

TEST(UprightEdges, TrustBrightnessWhereColourDiffers)
{
  const auto pixels = [](double of_brightness, double of_colour)
  {
    cv::Mat image = withEdge(of_brightness, 0);
    const cv::Mat colour = withEdge(of_colour, 0);
    cv::Mat mixed, chroma;
    cv::cvtColor(image, mixed, cv::COLOR_BGR2YCrCb), cv::cvtColor(colour, chroma, cv::COLOR_BGR2YCrCb);
    cv::mixChannels(chroma, mixed, {1, 1, 2, 2});
    cv::cvtColor(mixed, image, cv::COLOR_YCrCb2BGR);
    return image;
  };
  const auto same = edgesOf(pixels(kColumn, kColumn), pixels(kColumn - kDisparity, kColumn - kDisparity));
  const auto apart = edgesOf(pixels(kColumn, kColumn + 0.6), pixels(kColumn - kDisparity, kColumn - kDisparity));
  ASSERT_EQ(same.size(), 1u);
  ASSERT_EQ(apart.size(), 1u);
  EXPECT_NEAR(apart[0].disparity, same[0].disparity, 0.1);
  EXPECT_NEAR(apart[0].middle.x, same[0].middle.x, 0.1);
}

TEST(UprightEdges, AreNotMovedByASideInTheShadeThatOneImageShows)
{
  for (const double column : {kColumn, kColumn + 0.2, kColumn + 0.5})
    for (const double wide : {1.0, 1.5, 2.0})  // narrower ones may be colour that is coarser than the pixels
      for (const bool in_left : {false, true})
      {
        const auto edges =
            edgesOf(withSide(column, in_left ? wide : 0), withSide(column - kDisparity, in_left ? 0 : wide));
        ASSERT_EQ(edges.size(), 1u);
        EXPECT_NEAR(edges[0].middle.x, column, 0.15) << wide << " px";
        EXPECT_NEAR(edges[0].disparity, kDisparity, 0.2) << wide << " px";
      }
}
}  // namespace mrpt_ext::test_upright_edges
