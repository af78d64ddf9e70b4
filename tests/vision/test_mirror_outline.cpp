#include <gtest/gtest.h>

#include "mrpt_ext/vision/mirror_outline.h"
#include "synthetic_mirror.h"

namespace mrpt_ext::test_mirror_outline
{
namespace
{
using testing::MirrorPicture;

void expectFound(const MirrorPicture& picture, const cv::Mat& image, double tolerance = 0.15)
{
  const auto outline = findMirrorOutline(image, {});
  ASSERT_TRUE(outline);
  EXPECT_NEAR(outline->rim.centre.x, picture.rim.centre.x, tolerance);
  EXPECT_NEAR(outline->rim.centre.y, picture.rim.centre.y, tolerance);
  EXPECT_NEAR(outline->rim.aspect(), picture.rim.aspect(), 0.002);
  EXPECT_LT(outline->std_centre, tolerance);
}
}  // namespace

TEST(MirrorOutline, IsFoundInDarkSurroundings)
{
  const MirrorPicture picture;
  expectFound(picture, testing::paint(picture));
}

TEST(MirrorOutline, IsFoundInBrightSurroundings)
{
  MirrorPicture picture;
  picture.background = 240;
  expectFound(picture, testing::paint(picture));
}

TEST(MirrorOutline, FindsSquareAndFlatPixels)
{
  MirrorPicture picture;
  for (const double aspect : {0.82, 0.92, 1.0, 1.12, 1.23})
  {
    SCOPED_TRACE(aspect);
    picture.rim.semi_v = 205;
    picture.rim.semi_u = 205 * aspect;
    expectFound(picture, testing::paint(picture));
  }
}

TEST(MirrorOutline, MayBeSmall)
{
  MirrorPicture picture;
  picture.rim = {{250, 300}, 150, 144};
  expectFound(picture, testing::paint(picture));
}

TEST(MirrorOutline, MayBePartlyHidden)
{
  const MirrorPicture picture;
  cv::Mat image = testing::paint(picture);
  image(cv::Rect(60, 0, 170, 260)).setTo(cv::Scalar(35));
  image(cv::Rect(500, 250, 60, 200)).setTo(cv::Scalar(150));
  expectFound(picture, image, 0.3);
}

TEST(MirrorOutline, MayLeaveTheImage)
{
  MirrorPicture picture;
  picture.rim = {{330, 225}, 268, 258};
  expectFound(picture, testing::paint(picture), 0.3);
}

TEST(MirrorOutline, DoesNotDependOnTheLight)
{
  const MirrorPicture picture;
  cv::Mat dim;
  testing::paint(picture).convertTo(dim, CV_8U, 0.4);
  expectFound(picture, dim);
}

TEST(MirrorOutline, NamesARivalAboutAnotherCentre)
{
  const MirrorPicture picture;
  EXPECT_FALSE(findMirrorOutline(testing::paint(picture), {})->rival);
  MirrorPicture other = picture;
  other.rim.centre.x += 40;
  cv::Mat image = testing::paint(picture);
  testing::paint(other).rowRange(0, 240).copyTo(image.rowRange(0, 240));
  const auto outline = findMirrorOutline(image, {});
  EXPECT_TRUE(!outline || outline->rival);
}

TEST(MirrorOutline, IsNotInventedWithoutAMirror)
{
  const cv::Size size(640, 480);
  EXPECT_FALSE(findMirrorOutline(cv::Mat::zeros(size, CV_8U), {}));
  EXPECT_FALSE(findMirrorOutline(cv::Mat(size, CV_8U, cv::Scalar(255)), {}));
  for (const double sigma : {4.0, 15.0, 60.0})
  {
    cv::Mat noise(size, CV_8U);
    cv::RNG(3).fill(noise, cv::RNG::NORMAL, 128, sigma);
    EXPECT_FALSE(findMirrorOutline(noise, {})) << sigma;
  }
}

TEST(MirrorOutline, IsNotInventedInABoardOfSquares)
{
  cv::Mat board(480, 640, CV_8U);
  for (int v = 0; v < board.rows; ++v)
    for (int u = 0; u < board.cols; ++u) board.at<uchar>(v, u) = (u / 40 + v / 40) % 2 == 0 ? 40 : 220;
  EXPECT_FALSE(findMirrorOutline(board, {}));
}
}  // namespace mrpt_ext::test_mirror_outline
