#include "mrpt_ext/vision/tags/tag_view.h"

#include <gtest/gtest.h>

#include "tag_picture.h"

namespace mrpt_ext::test_tag_view
{
namespace
{
using testing::PaintedTag;
using testing::paintTags;
using testing::PlacedTag;
using testing::wallCamera;

TagSettings wallSettings()
{
  TagSettings settings;
  settings.camera = wallCamera();
  settings.edge = 0.2;
  settings.detector.dictionary = arucoOriginal();
  return settings;
}

TagView viewOf(const cv::Mat& image, const TagSettings& settings = wallSettings())
{
  return viewTags(image, TagDetector(settings.detector), settings);
}

cv::Mat pictureOf(const std::vector<PaintedTag>& tags) { return paintTags({640, 480}, arucoOriginal(), tags); }
}  // namespace

TEST(TagView, MeasuresTags)
{
  const PlacedTag near{.range = 1.2, .bearing = 0.3, .above = 0.1}, far{.range = 2.5, .bearing = -0.2, .turned = -0.7};
  const cv::Mat image = pictureOf({{8, near.corners(wallCamera())}, {2, far.corners(wallCamera())}});
  const TagView view = viewOf(image);
  EXPECT_EQ(view.problem, "");
  EXPECT_TRUE(view.refused.empty());
  ASSERT_EQ(view.tags.size(), 2U);
  EXPECT_EQ(view.tags[0].id, 2);
  EXPECT_NEAR(view.tags[0].measured.range, 2.5, 0.03);
  EXPECT_NEAR(view.tags[0].measured.bearing, -0.2, 5e-4);
  EXPECT_EQ(view.tags[1].id, 8);
  EXPECT_NEAR(view.tags[1].measured.range, 1.2, 0.01);
  EXPECT_NEAR(view.tags[1].measured.bearing, 0.3, 5e-4);
  EXPECT_GT(cv::norm(drawTags(image, view), drawTags(image, {}), cv::NORM_L1), 0);
}

TEST(TagView, RefusesANumberThatIsSeenTwice)
{
  const TagView view = viewOf(pictureOf({{8, PlacedTag{.range = 1.2, .bearing = 0.3}.corners(wallCamera())},
                                         {8, PlacedTag{.range = 2, .bearing = -0.3}.corners(wallCamera())},
                                         {5, PlacedTag{.range = 2, .bearing = 0.05}.corners(wallCamera())}}));
  ASSERT_EQ(view.tags.size(), 1U);
  EXPECT_EQ(view.tags[0].id, 5);
  ASSERT_EQ(view.refused.size(), 1U);
  EXPECT_EQ(view.refused[0].id, 8);
  EXPECT_EQ(view.refused[0].why, "it is seen more than once");
}

TEST(TagView, RefusesCornersThatAreNoSquares)
{
  TagCorners corners = PlacedTag{.range = 0.8}.corners(wallCamera());
  corners[0] += Eigen::Vector2d(-14, -10);
  const TagView view = viewOf(pictureOf({{8, corners}}));
  EXPECT_TRUE(view.tags.empty());
  ASSERT_EQ(view.refused.size(), 1U);
  EXPECT_EQ(view.refused[0].why, "its corners are not those of an upright square");
}

TEST(TagView, SaysWhatIsWrongWithAnImage)
{
  const auto problem = [](const cv::Mat& image) { return viewOf(image).problem; };
  EXPECT_EQ(problem({}), "image is missing, empty or damaged");
  EXPECT_EQ(problem(cv::Mat::zeros(240, 320, CV_8U)), "image is 320x240 pixels, expected 640x480");
  EXPECT_EQ(problem(cv::Mat::zeros(480, 640, CV_8UC3)), "image is black or of one colour");
  EXPECT_EQ(problem(pictureOf({})), "image is black or of one colour");
  cv::Mat wall = pictureOf({});
  wall.at<std::uint8_t>(100, 100) += 20;
  EXPECT_EQ(problem(wall), "");
  EXPECT_TRUE(viewOf(wall).tags.empty());
}
}  // namespace mrpt_ext::test_tag_view
