#include <gtest/gtest.h>

#include "mrpt_ext/vision/mirror_calibration.h"
#include "synthetic_cone.h"

namespace mrpt_ext
{
namespace
{
/// The mirror of `picture` before several walls, about its true principal point or without any statement.
std::vector<cv::Mat> sequenceOf(testing::ConePicture picture)
{
  std::vector<cv::Mat> images;
  for (int i = 0; i < 4; ++i)
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

struct Misalignment
{
  const char* name;
  Eigen::Vector2d offset, camera_tilt, vertical_tilt;
};

class MirrorCalibrations : public ::testing::TestWithParam<Misalignment>
{
};
}  // namespace

TEST_P(MirrorCalibrations, MakeAzimuthsRight)
{
  testing::ConePicture picture;
  picture.size = {400, 300};
  picture.focal = 316;
  picture.mirror.principal_point = {201.4, 149.1};
  picture.offset = GetParam().offset;
  picture.camera_tilt = GetParam().camera_tilt;
  picture.vertical_tilt = GetParam().vertical_tilt;
  const auto images = sequenceOf(picture);
  for (const bool stated : {true, false})
  {
    ConicMirrorSettings settings;
    if (stated) settings.axis = picture.mirror;
    const double before = errorWith(picture, settings);
    const auto alignment = calibrateMirror(images, settings);
    ASSERT_TRUE(alignment);
    settings.axis = alignment->axis;
    const double after = errorWith(picture, settings);
    printf(
        "%s stated %d: %.3f -> %.3f deg; offset-> tilt %.3f %.3f deg vert %.3f %.3f pp %.1f %.1f std %.3f bend %.3f -> "
        "%.3f\n",
        GetParam().name, stated, radToDeg(before), radToDeg(after), radToDeg(alignment->axis.camera_tilt.x),
        radToDeg(alignment->axis.camera_tilt.y), radToDeg(alignment->axis.vertical_tilt.x),
        radToDeg(alignment->axis.vertical_tilt.y), alignment->axis.principal_point.x, alignment->axis.principal_point.y,
        radToDeg(alignment->stdAzimuth(0.8)), radToDeg(alignment->bend_before), radToDeg(alignment->bend_after));
    EXPECT_LT(after, degToRad(stated ? 0.05 : 0.15));
  }
}

INSTANTIATE_TEST_SUITE_P(Vision, MirrorCalibrations,
                         ::testing::Values(Misalignment{"aligned", {0, 0}, {0, 0}, {0, 0}},
                                           Misalignment{"offset", {0.001, -0.0006}, {0, 0}, {0, 0}},
                                           Misalignment{"camera_tilt", {0, 0}, {0.0175, 0.005}, {0, 0}},
                                           Misalignment{"vertical_tilt", {0, 0}, {0, 0}, {0.012, -0.012}},
                                           Misalignment{"all", {0.0006, 0.0003}, {0.006, -0.009}, {-0.008, 0.004}}),
                         [](const auto& test) { return test.param.name; });
}  // namespace mrpt_ext
