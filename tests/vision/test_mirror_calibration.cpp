#include <gtest/gtest.h>

#include "mrpt_ext/vision/mirror_calibration.h"
#include "synthetic_cone.h"
#include "test_length.h"

namespace mrpt_ext::test_mirror_calibration
{
namespace
{
/// The mirror of `picture` before several walls, about its true principal point or without any statement.
std::vector<cv::Mat> sequenceOf(testing::ConePicture picture)
{
  std::vector<cv::Mat> images;
  for (int i = 0; i < 3; ++i)
  {
    picture.sectors.clear();
    for (int k = 0; k < 9; ++k)
      picture.sectors.push_back(
          {-175.0 + 40 * k + 7 * i + (k * k * 5 + i * 3) % 11, k % 2 ? 70.0 + 10 * k : 190.0 - 8 * k});
    images.push_back(testing::paint(picture, 2, i + 1));
  }
  return images;
}

/// [rad] the root mean square error of the azimuths of the sectors in one more image.
double errorWith(testing::ConePicture picture, const ConicMirrorSettings& settings)
{
  const ConicMirrorView view = viewConicMirror(testing::paint(picture, 2, 9), settings);
  double squares = 0;
  for (const testing::Sector& sector : picture.sectors)
  {
    double nearest = degToRad(5);
    for (const RadialEdge& edge : view.edges)
      nearest = std::min(nearest, std::abs(wrap(edge.azimuth - degToRad(sector.azimuth_deg))));
    squares += square(nearest);
  }
  return std::sqrt(squares / static_cast<double>(picture.sectors.size()));
}

testing::ConePicture smallPicture()
{
  testing::ConePicture picture;
  picture.size = {400, 300};
  picture.focal = 316;
  picture.mirror.principal_point = {201.4, 149.1};
  return picture;
}

/// The error with the axes that a sequence tells, when they are better than those of the settings.
double errorAfter(const testing::ConePicture& picture, ConicMirrorSettings settings)
{
  const auto alignment = calibrateMirror(sequenceOf(picture), settings);
  if (alignment && alignment->isBetter()) settings.axis = alignment->axis;
  return errorWith(picture, settings);
}

ConicMirrorSettings stated(const testing::ConePicture& picture)
{
  ConicMirrorSettings settings;
  settings.axis = picture.mirror;
  return settings;
}
}  // namespace

TEST(MirrorCalibration, LeavesAxesThatAgree)
{
  const testing::ConePicture picture = smallPicture();
  for (const ConicMirrorSettings& settings : {stated(picture), ConicMirrorSettings()})
  {
    const auto alignment = calibrateMirror(sequenceOf(picture), settings);
    ASSERT_TRUE(alignment);
    EXPECT_FALSE(alignment->isBetter());
  }
}

TEST(MirrorCalibration, FindsATiltedCamera)
{
  testing::ConePicture picture = smallPicture();
  picture.camera_tilt = {degToRad(1), degToRad(0.3)};
  const auto alignment = calibrateMirror(sequenceOf(picture), stated(picture));
  ASSERT_TRUE(alignment && alignment->isBetter());
  EXPECT_NEAR(alignment->axis.camera_tilt.x, picture.camera_tilt.x(), degToRad(0.05));
  EXPECT_NEAR(alignment->axis.camera_tilt.y, picture.camera_tilt.y(), degToRad(0.05));
  if (testing::isShort()) return;
  EXPECT_LT(errorAfter(picture, stated(picture)), degToRad(0.03));
  EXPECT_LT(errorAfter(picture, {}), degToRad(0.06));  // no principal point stated
}

TEST(MirrorCalibration, FindsAMirrorBesideTheCamera)
{
  testing::ConePicture picture = smallPicture();
  picture.offset = {0.001, -0.0006};
  EXPECT_GT(errorWith(picture, {}), degToRad(0.12));
  EXPECT_LT(errorAfter(picture, {}), degToRad(0.03));
  EXPECT_LT(errorAfter(picture, stated(picture)), degToRad(0.03));
}

TEST(MirrorCalibration, FindsAllCausesWithAPrincipalPoint)
{
  testing::ConePicture picture = smallPicture();
  picture.offset = {0.0006, 0.0003};
  picture.camera_tilt = {0.006, -0.009};
  picture.vertical_tilt = {-0.008, 0.004};
  EXPECT_LT(errorAfter(picture, stated(picture)), degToRad(0.03));
}

TEST(MirrorCalibration, NeedsEdges)
{
  EXPECT_FALSE(calibrateMirror({}, {}));
  testing::ConePicture picture = smallPicture();
  picture.sectors = {{-90, 100}, {90, 160}};
  EXPECT_FALSE(calibrateMirror({testing::paint(picture, 2, 1)}, stated(picture)));
}
}  // namespace mrpt_ext::test_mirror_calibration
