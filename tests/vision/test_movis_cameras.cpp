#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/omni_objects.h"
#include "mrpt_ext/vision/pole_cover.h"
#include "mrpt_ext/vision/pole_distance.h"

// One omnidirectional camera of paper 001: its mirror, its colours, what it sees and what it refuses.
namespace mrpt_ext::test_movis_cameras
{
namespace
{
/// Camera M1 of datasets/movis-field.
OmniCameraSettings ownCamera()
{
  OmniCameraSettings settings;
  settings.image_size = {320, 320};
  settings.mirror = {0.03, 0.024, 0.031, 0.62, 423, 423, {160.4, 158.7}};
  settings.sizes = {0.1, 1.0, 0.11};
  return settings;
}

cv::Mat ownImage(const std::string& name)
{
  return cv::imread(std::string(MRPT_EXT_SOURCE_DIR) + "/datasets/movis-field/" + name);
}

const OmniObject* find(const std::vector<OmniObject>& objects, const std::string& label)
{
  for (const OmniObject& object : objects)
    if (object.label == label) return &object;
  return nullptr;
}

cv::Vec3b pixelOf(double r, double g, double b)
{
  const auto level = [](double linear)
  { return static_cast<unsigned char>(std::lround(255 * (1.055 * std::pow(linear, 1 / 2.4) - 0.055))); };
  return {level(b), level(g), level(r)};
}

ObjectColour colourOf(const cv::Vec3b& pixel, const cv::Vec3d& white)
{
  return static_cast<ObjectColour>(classifyColours(cv::Mat(1, 1, CV_8UC3, pixel), {}, white)(0, 0));
}
}  // namespace

TEST(HyperbolicMirror, MapsElevationsInBothDirections)
{
  const HyperbolicMirror mirror = ownCamera().mirror;
  for (const double slope : {-3.0, -1.0, -0.2, 0.0, 0.1, 0.25})
    EXPECT_NEAR(mirror.slopeAt(mirror.rhoAt(slope)), slope, 1e-9);
  // The horizon's radius is b^2 / (2 a c).
  const double c = std::hypot(mirror.a, mirror.b);
  EXPECT_NEAR(mirror.rhoAt(0), mirror.b * mirror.b / (2 * mirror.a * c), 1e-12);
  // A point of the rim is on the mirror, where the ray through the focus leaves it.
  const double height = mirror.a * std::hypot(1.0, mirror.rim_radius / mirror.b) - c;
  EXPECT_NEAR(mirror.slopeAt(mirror.rimRho()), height / mirror.rim_radius, 1e-9);
}

TEST(MirrorPanorama, HasAzimuthsInColumnsAndSlopesInRows)
{
  const HyperbolicMirror mirror = ownCamera().mirror;
  const MirrorPanorama panorama(mirror, 720, -1.5);
  EXPECT_EQ(panorama.columns(), 720);
  for (int row = 1; row < panorama.rows(); ++row) EXPECT_LT(panorama.slope(row), panorama.slope(row - 1));
  EXPECT_EQ(panorama.rowAt(1e9), 0);
  EXPECT_EQ(panorama.rowAt(-1e9), panorama.rows());
  cv::Mat image(320, 320, CV_8UC3, cv::Scalar(0, 0, 0));
  cv::circle(image, mirror.pixel(degToRad(90.0), mirror.rhoAt(-0.3)), 3, {255, 255, 255}, cv::FILLED);
  const cv::Mat seen = panorama.unroll(image);
  EXPECT_EQ(seen.at<cv::Vec3b>(panorama.rowAt(-0.3), 180), cv::Vec3b(255, 255, 255));
  EXPECT_EQ(seen.at<cv::Vec3b>(panorama.rowAt(-0.3), 0), cv::Vec3b(0, 0, 0));
}

TEST(ObjectColours, AreHuesAfterWhiteBalance)
{
  const cv::Vec3d day(1, 1, 1), lamp(0.55, 0.9, 1.1);  // BGR
  for (const double brightness : {1.0, 0.5, 0.1})
    for (const cv::Vec3d& white : {day, lamp})
    {
      const auto seen = [&](double r, double g, double b)
      {
        return colourOf(
            pixelOf(0.9 * r * brightness * white[2], 0.9 * g * brightness * white[1], 0.9 * b * brightness * white[0]),
            white * 0.9);
      };
      EXPECT_EQ(seen(0.9, 0.75, 0.05), ObjectColour::yellow);
      EXPECT_EQ(seen(0.95, 0.3, 0.02), ObjectColour::orange);
      EXPECT_EQ(seen(0.05, 0.12, 0.6), ObjectColour::blue);
      EXPECT_EQ(seen(0.05, 0.32, 0.09), ObjectColour::other);
      EXPECT_EQ(seen(0.6, 0.58, 0.55), ObjectColour::other);
    }
}

TEST(ObjectColours, WhiteIsBrightInAllChannels)
{
  cv::Mat image(100, 100, CV_8UC3, cv::Scalar(30, 90, 30));
  image.rowRange(0, 40).setTo(cv::Scalar(20, 250, 255));    // bright yellow
  image.rowRange(40, 45).setTo(cv::Scalar(150, 200, 220));  // white in warm light
  const cv::Vec3d white = whiteOf(image, 0.03);
  EXPECT_NEAR(white[0], linearLight()[150], 1e-6);
  EXPECT_NEAR(white[1], linearLight()[200], 1e-6);
  EXPECT_NEAR(white[2], linearLight()[220], 1e-6);
}

TEST(OmniCamera, SeesPolesAndBall)
{
  const OmniCamera camera(ownCamera());
  const OmniView view = camera.view(ownImage("field_00_M1.jpg"));
  EXPECT_EQ(view.problem, "");
  ASSERT_EQ(view.objects.size(), 3u);
  // observations.csv, less the half degree by which the camera is turned.
  EXPECT_NEAR(radToDeg(find(view.objects, "p")->azimuth), 121.127 - 0.5, 0.15);
  EXPECT_NEAR(radToDeg(find(view.objects, "q")->azimuth), 59.2979 - 0.5, 0.15);
  EXPECT_NEAR(radToDeg(find(view.objects, "ball")->azimuth), 62.4155 - 0.5, 0.15);
  EXPECT_NEAR(radToDeg(find(view.objects, "p")->half_width), 1.595, 0.15);
  EXPECT_NEAR(find(view.objects, "p")->distance, 3.59, 0.4);
  for (const OmniObject& object : view.objects)
  {
    EXPECT_GT(object.std_azimuth, 0);
    EXPECT_LT(object.std_azimuth, degToRad(0.2));
  }
  const cv::Mat drawing = camera.draw(ownImage("field_00_M1.jpg"), view);
  EXPECT_GT(cv::norm(drawing, ownImage("field_00_M1.jpg"), cv::NORM_L1), 0);
}

TEST(OmniCamera, RotatingTheImageRotatesTheObjects)
{
  // A quarter turn, which moves pixels without mixing them: u' = 319 - v, v' = u.
  cv::Mat turned;
  cv::rotate(ownImage("field_05_M1.jpg"), turned, cv::ROTATE_90_CLOCKWISE);
  OmniCameraSettings settings = ownCamera();
  const OmniView before = OmniCamera(settings).view(ownImage("field_05_M1.jpg"));
  settings.mirror.centre = {319 - settings.mirror.centre.y, settings.mirror.centre.x};
  const OmniView after = OmniCamera(settings).view(turned);
  ASSERT_EQ(before.objects.size(), 3u);
  ASSERT_EQ(after.objects.size(), 3u);
  for (const OmniObject& object : before.objects)
    EXPECT_NEAR(wrap(find(after.objects, object.label)->azimuth - object.azimuth - kPi / 2), 0, degToRad(0.02));
}

TEST(OmniCamera, DoesNotMeasureBehindItsNeighbours)
{
  OmniCameraSettings settings = ownCamera();
  settings.blocked = {{degToRad(120.0), degToRad(5.0)}};
  const OmniView view = OmniCamera(settings).view(ownImage("field_00_M1.jpg"));
  EXPECT_EQ(find(view.objects, "p"), nullptr);
  EXPECT_NE(find(view.hidden, "p"), nullptr);
  EXPECT_NE(find(view.objects, "q"), nullptr);
}

namespace
{
/// A black robot in front of what is to the left of the share `from` of a pole's half width.
cv::Mat coveredFrom(double from, const OmniObject& pole)
{
  const OmniCameraSettings settings = ownCamera();
  cv::Mat image = ownImage("field_00_M1.jpg");
  for (double azimuth = pole.azimuth + from * pole.half_width; azimuth < pole.azimuth + 3 * pole.half_width;
       azimuth += 0.002)
    cv::line(image, settings.mirror.pixel(azimuth, 0.4 * settings.mirror.rimRho()),
             settings.mirror.pixel(azimuth, settings.mirror.rimRho()), {25, 25, 25}, 2);
  return image;
}
}  // namespace

TEST(OmniCamera, APoleCoveredInPartIsLeftOutOrSaysHowFarItMayBeOff)
{
  const OmniCamera camera(ownCamera());
  const OmniObject p = *find(camera.view(ownImage("field_00_M1.jpg")).objects, "p");
  for (const double from : {0.0, 0.3, 0.5, 0.7, 1.1, 1.5})
  {
    const OmniView view = camera.view(coveredFrom(from, p));
    const OmniObject* const seen = find(view.objects, "p");
    EXPECT_TRUE(!seen || std::abs(wrap(seen->azimuth - p.azimuth)) < 2 * seen->std_azimuth) << from;
    EXPECT_NE(find(view.objects, "q"), nullptr);
  }
  EXPECT_NE(find(camera.view(coveredFrom(1.1, p)).objects, "p"), nullptr);
}

TEST(PoleDistance, FollowsFromWhereBandsMeet)
{
  const OmniCameraSettings settings = ownCamera();
  const OmniView view = OmniCamera(settings).view(ownImage("field_00_M1.jpg"));
  for (const auto& [label, truth] : {std::pair{"p", 3.59}, std::pair{"q", 5.1}})
  {
    const OmniObject object = *find(view.objects, label);
    for (const double guess : {0.95 * object.distance, object.distance})
    {
      const auto found = distanceByBands(ownImage("field_00_M1.jpg"), settings.mirror, settings.sizes,
                                         {object.azimuth, object.half_width, guess});
      ASSERT_TRUE(found) << label;
      EXPECT_NEAR(found->distance, truth, 3 * found->std) << label;
      EXPECT_LT(found->std, 0.05 * truth) << label;
    }
    EXPECT_FALSE(distanceByBands(ownImage("field_00_M1.jpg"), settings.mirror, settings.sizes,
                                 {object.azimuth + 0.5, object.half_width, object.distance}))
        << label;
  }
}

TEST(OmniCamera, ColoursOfAPoleWithOtherBandsAreNoPole)
{
  const OmniCamera camera(ownCamera());
  const HyperbolicMirror& mirror = camera.settings().mirror;
  const cv::Mat image = ownImage("field_00_M1.jpg");
  const OmniObject q = *find(camera.view(image).objects, "q");
  const cv::Vec3b blue = pixelOf(0.05, 0.12, 0.6), yellow = pixelOf(0.9, 0.75, 0.05);
  constexpr double kDistance = 2, kFront = kDistance - 0.1;
  const double half_width = poleHalfWidth(camera.settings().sizes, kDistance);
  for (const double upper : {2.0 / 3, 0.55})
  {
    cv::Mat painted = image.clone();  // something blue and yellow before the pole q
    for (int row = 0; row < image.rows; ++row)
      for (int column = 0; column < image.cols; ++column)
      {
        const cv::Point2d at = cv::Point2d(column, row) - mirror.centre;
        const double height =
            mirror.focus_height + kFront * mirror.slopeAt(std::max(1e-3, cv::norm(at) / mirror.focalLength()));
        if (std::abs(wrap(std::atan2(at.y, at.x) - q.azimuth)) < half_width && height > 0 && height < 1)
          painted.at<cv::Vec3b>(row, column) = height > 1.0 / 3 && height < upper ? yellow : blue;
      }
    const OmniView view = camera.view(painted);
    EXPECT_EQ(find(view.objects, "q") != nullptr, upper > 0.6) << upper;
  }
}

TEST(OmniCamera, MeasuresTheVisibleSideOfACoveredPole)
{
  // Something upright is painted in front of a third of the pole: a sector from the floor before the pole to the rim.
  const OmniCamera camera(ownCamera());
  const HyperbolicMirror& mirror = camera.settings().mirror;
  const cv::Mat image = ownImage("field_00_M1.jpg");
  const OmniObject whole = *find(camera.view(image).objects, "p");
  const double foot = mirror.rhoAt(mirror.slopeOf(0, whole.distance)), begin = foot - 12 / mirror.focalLength();
  for (const int side : {-1, 1})
  {
    cv::Mat covered = image.clone();
    const double edge = whole.azimuth + side * whole.half_width / 3;
    for (int row = 0; row < image.rows; ++row)
      for (int column = 0; column < image.cols; ++column)
      {
        const cv::Point2d at = cv::Point2d(column, row) - mirror.centre;
        const double beyond = side * wrap(std::atan2(at.y, at.x) - edge);
        if (beyond > 0 && beyond < 0.2 && cv::norm(at) > begin * mirror.focalLength() &&
            cv::norm(at) < mirror.rimRho() * mirror.focalLength())
          covered.at<cv::Vec3b>(row, column) = {120, 110, 150};
      }
    const auto cover = coverOfPole(covered, mirror, camera.settings().sizes,
                                   {whole.azimuth - side * whole.half_width / 3, whole.half_width, whole.distance});
    ASSERT_TRUE(cover);
    EXPECT_EQ(cover->side, side);
    EXPECT_NEAR(radToDeg(wrap(cover->edge - edge)), 0, 0.4);
    const OmniView view = camera.view(covered);
    const OmniObject* const seen = find(view.objects, "p");
    ASSERT_TRUE(seen) << side;
    EXPECT_NEAR(wrap(seen->azimuth - whole.azimuth), 0, 3 * seen->std_azimuth) << side;
    EXPECT_LT(radToDeg(seen->std_azimuth), 0.2) << side;
  }
  // Nothing is in front of the pole as it is.
  EXPECT_FALSE(coverOfPole(image, mirror, camera.settings().sizes, {whole.azimuth, whole.half_width, whole.distance}));
}

TEST(OmniCamera, StatesWhyThereIsNoMeasurement)
{
  const OmniCamera camera(ownCamera());
  const auto problem = [&](const cv::Mat& image)
  {
    const OmniView view = camera.view(image);
    EXPECT_TRUE(view.objects.empty());
    static_cast<void>(camera.draw(image, view));
    return view.problem;
  };
  EXPECT_EQ(problem({}), "image is missing, empty or damaged");
  EXPECT_EQ(problem(cv::Mat::zeros(240, 320, CV_8UC3)), "image is 320x240 pixels, expected 320x320");
  EXPECT_EQ(problem(cv::Mat::zeros(320, 320, CV_8U)), "image is grey, expected colours");
  EXPECT_EQ(problem(cv::Mat::zeros(320, 320, CV_8UC3)), "no mirror found");
  for (const std::uint64_t seed : {1, 2, 3, 4})
  {
    cv::Mat noise(320, 320, CV_8UC3);
    cv::RNG(seed).fill(noise, cv::RNG::UNIFORM, 0, 256);
    EXPECT_EQ(problem(noise), "no mirror found");
  }
  // The mirror is there, with nothing of the field in it.
  cv::Mat empty = cv::Mat::zeros(320, 320, CV_8UC3);
  cv::circle(empty, {160, 159}, 150, {120, 140, 130}, cv::FILLED);
  EXPECT_EQ(problem(empty), "");
}
}  // namespace mrpt_ext::test_movis_cameras
