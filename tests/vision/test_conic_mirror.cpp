#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/vision/conic_mirror.h"
#include "synthetic_cone.h"

namespace mrpt_ext::test_conic_mirror
{
namespace
{
using testing::MirrorPicture;

const RadialEdge* edgeAt(const ConicMirrorView& view, double azimuth_deg)
{
  const RadialEdge* nearest = nullptr;
  const auto distance = [&](const RadialEdge& e) { return std::abs(wrap(e.azimuth - degToRad(azimuth_deg))); };
  for (const RadialEdge& edge : view.edges)
    if (!nearest || distance(edge) < distance(*nearest)) nearest = &edge;
  return nearest && distance(*nearest) < degToRad(1.0) ? nearest : nullptr;
}

/// Every sector's beginning is an edge of the right polarity, and there is none else. Returns the squared errors in
/// units of the stated standard deviations.
template <typename Picture>
std::vector<double> expectTheSectors(const Picture& picture, const ConicMirrorView& view)
{
  std::vector<double> squares;
  EXPECT_EQ(view.problem, "");
  EXPECT_EQ(view.edges.size(), picture.sectors.size());
  for (std::size_t i = 0; i < picture.sectors.size(); ++i)
  {
    const double before = picture.sectors[(i + picture.sectors.size() - 1) % picture.sectors.size()].brightness;
    const RadialEdge* const edge = edgeAt(view, picture.sectors[i].azimuth_deg);
    if (!edge)
    {
      ADD_FAILURE() << "no edge at " << picture.sectors[i].azimuth_deg;
      continue;
    }
    EXPECT_EQ(edge->polarity, picture.sectors[i].brightness > before ? 1 : -1);
    const double error = wrap(edge->azimuth - degToRad(picture.sectors[i].azimuth_deg));
    EXPECT_LT(std::abs(error), degToRad(0.12)) << picture.sectors[i].azimuth_deg;
    EXPECT_GT(edge->std_azimuth, 0);
    squares.push_back(square(error / edge->std_azimuth));
  }
  return squares;
}
}  // namespace

TEST(ConicMirror, SeesEveryEdgeWithItsPolarity)
{
  const MirrorPicture picture;
  expectTheSectors(picture, viewConicMirror(testing::paint(picture), {}));
}

TEST(ConicMirror, StandardDeviationsAreRight)
{
  MirrorPicture picture;
  picture.noise = 6;
  picture.sectors = {{-150, 128}, {-80, 120}, {-10, 130}, {70, 122}, {120, 134}};
  std::vector<double> squares;
  for (int seed = 1; seed <= 8; ++seed)
  {
    const auto more = expectTheSectors(picture, viewConicMirror(testing::paint(picture, seed), {}));
    squares.insert(squares.end(), more.begin(), more.end());
  }
  double mean = 0;
  for (const double value : squares) mean += value / static_cast<double>(squares.size());
  EXPECT_GT(mean, 0.4);  // not far too careful
  EXPECT_LT(mean, 1.5);  // nor overconfident
}

TEST(ConicMirror, SeesTheSameInSmallImages)
{
  MirrorPicture picture;
  picture.size = {320, 240};
  picture.rim = {{161.2, 118.4}, 114.0, 107.5};
  expectTheSectors(picture, viewConicMirror(testing::paint(picture), {}));
}

TEST(ConicMirror, MayBeBesideTheCamerasAxis)
{
  testing::ConePicture picture;
  ConicMirrorSettings settings;
  settings.axis = picture.mirror;
  for (const Eigen::Vector2d& offset : {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.001, -0.0006)})
  {
    picture.offset = offset;
    expectTheSectors(picture, viewConicMirror(testing::paint(picture, 3, 1), settings));
  }
  // It sees from beside the camera's axis, by an unknown share of the room.
  const auto statedAt = [&](const Eigen::Vector2d& offset)
  {
    picture.offset = offset;
    return edgeAt(viewConicMirror(testing::paint(picture, 3, 1), settings), 35)->std_azimuth;
  };
  EXPECT_GT(statedAt({0.001, -0.0006}), 1.2 * statedAt({0, 0}));
  picture.offset = {0.001, -0.0006};
  // Taken for the camera's axis, some azimuths are off by tenths of a degree.
  double worst = 0;
  const ConicMirrorView view = viewConicMirror(testing::paint(picture, 3, 1), {});
  for (const testing::Sector& sector : picture.sectors)
    if (const RadialEdge* const edge = edgeAt(view, sector.azimuth_deg))
      worst = std::max(worst, std::abs(wrap(edge->azimuth - degToRad(sector.azimuth_deg))));
  EXPECT_GT(worst, degToRad(0.2));
}

TEST(ConicMirror, MeasuresCloseEdges)
{
  // A narrow gap: its edges push each other's peaks away, by a quarter of a degree each.
  MirrorPicture picture;
  picture.noise = 2;
  for (const double gap : {0.9, 1.2, 1.6})
  {
    picture.sectors = {{-150, 190}, {20, 110}, {20 + gap, 190}, {80, 90}};
    const ConicMirrorView view = viewConicMirror(testing::paint(picture), {});
    for (const double azimuth : {20.0, 20 + gap})
    {
      const RadialEdge* const edge = edgeAt(view, azimuth);
      ASSERT_TRUE(edge) << gap;
      const double error = std::abs(wrap(edge->azimuth - degToRad(azimuth)));
      EXPECT_LT(error, degToRad(gap < 1 ? 0.15 : 0.06)) << gap;
      EXPECT_LT(error, 2.5 * edge->std_azimuth) << gap;
      EXPECT_LT(edge->std_azimuth, degToRad(gap < 1 ? 0.3 : gap < 1.5 ? 0.1 : 0.05)) << gap;
    }
  }
}

TEST(ConicMirror, TellsTwoStepsOfOnePolarityApart)
{
  // A door frame: two steps downwards, so near that they make one peak.
  MirrorPicture picture;
  picture.noise = 2;
  for (const double gap : {1.0, 1.1, 1.2})
  {
    picture.sectors = {{-150, 190}, {20, 150}, {20 + gap, 100}, {80, 60}, {120, 170}, {-60, 90}};
    std::sort(picture.sectors.begin(), picture.sectors.end(),
              [](const auto& a, const auto& b) { return a.azimuth_deg < b.azimuth_deg; });
    const ConicMirrorView view = viewConicMirror(testing::paint(picture), {});
    EXPECT_EQ(view.edges.size(), picture.sectors.size()) << gap;
    for (const double azimuth : {20.0, 20 + gap})
    {
      const RadialEdge* nearest = nullptr;
      for (const RadialEdge& edge : view.edges)
        if (std::abs(wrap(edge.azimuth - degToRad(azimuth))) < degToRad(0.3)) nearest = &edge;
      ASSERT_TRUE(nearest) << gap;
      const double error = std::abs(wrap(nearest->azimuth - degToRad(azimuth)));
      EXPECT_LT(error, degToRad(0.15)) << gap;
      EXPECT_LT(error, 3 * nearest->std_azimuth) << gap;
    }
  }
}

TEST(ConicMirror, SeesTheEdgesOfABlurredImage)
{
  MirrorPicture picture;
  picture.noise = 0;
  cv::Mat image = testing::paint(picture), noise(image.size(), CV_32F);
  for (const double blur : {1.6, 2.4, 3.2})
  {
    cv::Mat blurred;
    cv::GaussianBlur(image, blurred, {0, 0}, blur);
    blurred.convertTo(blurred, CV_32F);
    cv::RNG(3).fill(noise, cv::RNG::NORMAL, 0, 2);
    blurred += noise;
    blurred.convertTo(blurred, CV_8U);
    SCOPED_TRACE(blur);
    expectTheSectors(picture, viewConicMirror(blurred, {}));
  }
}

TEST(ConicMirror, DropsASoftShadowAmongSharpEdges)
{
  struct ShadowPicture : MirrorPicture
  {
    [[nodiscard]] double brightnessAt(double u, double v) const
    {
      const double x = (u - rim.centre.x) / rim.semi_u, y = (v - rim.centre.y) / rim.semi_v;
      const double light = 1 / (1 + std::exp((radToDeg(std::atan2(y, x)) - 80) / 1.5));
      return MirrorPicture::brightnessAt(u, v) + (std::hypot(x, y) > 1 ? 0 : 60 * light);
    }
  } picture;
  picture.sectors = {{-150, 120}, {-120, 50}, {-60, 100}, {-20, 50}, {35, 90}};
  const ConicMirrorView view = viewConicMirror(testing::paint(picture, 2, 1), {});
  EXPECT_FALSE(edgeAt(view, 80));
  for (const testing::Sector& sector : picture.sectors) EXPECT_TRUE(edgeAt(view, sector.azimuth_deg));
}

TEST(ConicMirror, DoesNotTakeShadingForEdges)
{
  MirrorPicture picture;
  picture.sectors = {{-170, 130}, {10, 100}};
  picture.shading = 60;
  expectTheSectors(picture, viewConicMirror(testing::paint(picture), {}));
}

TEST(ConicMirror, SeesEdgesUnderOtherLightAndMoreNoise)
{
  MirrorPicture picture;
  picture.noise = 6;
  cv::Mat colour;
  cv::cvtColor(testing::paint(picture), colour, cv::COLOR_GRAY2BGR);
  colour.convertTo(colour, CV_8UC3, 0.7);
  cv::multiply(colour, cv::Scalar(0.8, 1.0, 1.15), colour);
  expectTheSectors(picture, viewConicMirror(colour, {}));
}

TEST(ConicMirror, SeesAnEdgeThatEndsHalfWay)
{
  MirrorPicture picture;
  picture.sectors = {{-170, 180}, {20, 120}};
  cv::Mat image = testing::paint(picture);
  cv::Mat painted = image.clone();
  // A dark table in the outer half, from 80 to 110 degrees.
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u)
    {
      const double x = (u - picture.rim.centre.x) / picture.rim.semi_u,
                   y = (v - picture.rim.centre.y) / picture.rim.semi_v;
      const double r = std::hypot(x, y), azimuth = radToDeg(std::atan2(y, x));
      if (r > 0.6 && r < 1 && azimuth > 80 && azimuth < 110) painted.at<uchar>(v, u) = 50;
    }
  const ConicMirrorView view = viewConicMirror(painted, {});
  const RadialEdge *right = edgeAt(view, 80), *left = edgeAt(view, 110);
  ASSERT_TRUE(right && left);
  EXPECT_EQ(right->polarity, -1);
  EXPECT_EQ(left->polarity, 1);
  EXPECT_NEAR(right->inner, 0.6, 0.06);
}

TEST(ConicMirror, StatesWhyThereIsNoMeasurement)
{
  ConicMirrorSettings settings;
  settings.image_size = {640, 480};
  const auto problem = [&](const cv::Mat& image)
  {
    const ConicMirrorView view = viewConicMirror(image, settings);
    EXPECT_TRUE(view.edges.empty());
    static_cast<void>(drawConicMirror(image, view));
    return view.problem;
  };
  EXPECT_EQ(problem({}), "image is missing, empty or damaged");
  EXPECT_EQ(problem(cv::Mat::zeros(240, 320, CV_8U)), "image is 320x240 pixels, expected 640x480");
  EXPECT_EQ(problem(cv::Mat::zeros(480, 640, CV_16U)), "image has 1 channels of 16 bits, expected 1 or 3 of 8 bits");
  EXPECT_EQ(problem(cv::Mat::zeros(480, 640, CV_8U)), "no mirror found");
  settings.image_size = {};
  EXPECT_EQ(problem(cv::Mat::zeros(2, 1, CV_8UC3)), "image is 1x2 pixels, expected at least 64 either way");
}

TEST(ConicMirror, EdgesBesideClippedLightSayHowFarTheyMayBeOff)
{
  const MirrorPicture picture;
  const cv::Mat image = testing::paint(picture);
  cv::Mat bright;
  image.convertTo(bright, CV_8U, 1.5);  // four of the sectors are beyond 255
  const ConicMirrorView usual = viewConicMirror(image, {}), clipped = viewConicMirror(bright, {});
  int wider = 0;
  for (const testing::Sector& sector : picture.sectors)
  {
    const RadialEdge *const before = edgeAt(usual, sector.azimuth_deg), *const edge =
                                                                            edgeAt(clipped, sector.azimuth_deg);
    ASSERT_TRUE(before && edge) << sector.azimuth_deg;
    EXPECT_LT(std::abs(wrap(edge->azimuth - degToRad(sector.azimuth_deg))), 3 * edge->std_azimuth);
    wider += edge->std_azimuth > 1.5 * before->std_azimuth;
  }
  EXPECT_GE(wider, 4);
}

TEST(ConicMirror, MeasuresNothingWhereTheMirrorIsElsewhereThanInOtherImages)
{
  const MirrorPicture picture;
  MirrorPicture other = picture;
  other.rim = {{300, 245}, 190, 180};
  const cv::Mat usual = testing::paint(picture), odd = testing::paint(other);
  ConicMirrorSettings settings;
  EXPECT_FALSE(usualRimOf({usual, usual}, settings));
  EXPECT_FALSE(usualRimOf({usual, odd, odd, usual}, settings));
  settings.usual_rim = usualRimOf({odd, usual, usual, usual}, settings);
  ASSERT_TRUE(settings.usual_rim);
  EXPECT_NEAR(settings.usual_rim->centre.x, picture.rim.centre.x, 1);
  EXPECT_EQ(viewConicMirror(usual, settings).problem, "");
  const ConicMirrorView view = viewConicMirror(odd, settings);
  EXPECT_EQ(view.problem.find("mirror found about 300 245 px, in other images about 322 239 px"), 0u) << view.problem;
  EXPECT_TRUE(view.edges.empty());
}

TEST(ConicMirror, DrawsFeatures)
{
  const cv::Mat image = testing::paint({});
  const cv::Mat drawing = drawConicMirror(image, viewConicMirror(image, {}));
  ASSERT_EQ(drawing.type(), CV_8UC3);
  ASSERT_EQ(drawing.size(), image.size());
  std::vector<cv::Mat> channels;
  cv::split(drawing, channels);
  EXPECT_GT(cv::countNonZero(channels[0] != channels[1]), 1000);  // coloured marks on a grey picture
}
}  // namespace mrpt_ext::test_conic_mirror
