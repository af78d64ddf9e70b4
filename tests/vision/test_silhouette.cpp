#include "mrpt_ext/vision/silhouette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/outline_fit.h"

// Where an object ends in the image of a mirror, by colour and by brightness, on painted images.
namespace mrpt_ext::test_silhouette
{
namespace
{
const HyperbolicMirror kMirror{0.03, 0.024, 0.031, 0.62, 423, 423, {160.4, 158.7}};
constexpr double kHalfWidth = degToRad(2.5), kInnerRho = 0.12, kMiddleRho = 0.16, kOuterRho = 0.2;
const cv::Vec3d kPaint(40, 150, 230), kDarkPaint(150, 40, 20), kGround(70, 110, 60);  // BGR

/// How a scene is lit, 1: as painted.
struct Light
{
  double left = 1, right = 1;  ///< the ground beside the object
  double shade = 0;            ///< of the object: darker to the right by this share, brighter to the left
  bool has_bands = false;      ///< the inner half of the object is of a paint that is darker than the ground
};

/// A sector about `azimuth` in front of the ground, nine samples per pixel.
cv::Mat painted(double azimuth, const Light& light)
{
  cv::Mat image(320, 320, CV_8UC3);
  for (int row = 0; row < image.rows; ++row)
    for (int column = 0; column < image.cols; ++column)
    {
      cv::Vec3d sum(0, 0, 0);
      for (int i = 0; i < 9; ++i)
      {
        const double u = column + (i % 3 - 1) / 3.0, v = row + (i / 3 - 1) / 3.0;
        const double off = wrap(std::atan2(v - kMirror.centre.y, u - kMirror.centre.x) - azimuth);
        const bool is_inner = std::hypot(v - kMirror.centre.y, u - kMirror.centre.x) < kMiddleRho * kMirror.fx;
        if (std::abs(off) < kHalfWidth)
          sum += (1 - light.shade * off / kHalfWidth) * (light.has_bands && is_inner ? kDarkPaint : kPaint) / 9;
        else
          sum += (off < 0 ? light.left : light.right) * kGround / 9;
      }
      for (int c = 0; c < 3; ++c) image.at<cv::Vec3b>(row, column)[c] = cv::saturate_cast<unsigned char>(sum[c]);
    }
  return image;
}

/// Blurred, with noise, and kept as JPEG with colour of half the resolution where a quality is given.
cv::Mat taken(const cv::Mat& image, double noise, int quality, cv::RNG& random)
{
  cv::Mat blurred, added(image.size(), CV_32FC3), result;
  cv::GaussianBlur(image, blurred, {0, 0}, 0.6);
  random.fill(added, cv::RNG::NORMAL, 0, noise);
  blurred.convertTo(blurred, CV_32FC3);
  cv::Mat(blurred + added).convertTo(result, CV_8UC3);
  if (quality == 0) return result;
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", result, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
  return cv::imdecode(bytes, cv::IMREAD_COLOR);
}

std::vector<SilhouetteSlice> slices()
{
  std::vector<SilhouetteSlice> all;
  constexpr int kCount = 16;
  for (int i = 0; i < kCount; ++i)
    all.push_back({kInnerRho + i * (kOuterRho - kInnerRho) / kCount,
                   kInnerRho + (i + 1) * (kOuterRho - kInnerRho) / kCount, kHalfWidth});
  return all;
}

/// Many pictures, the object somewhere else in each.
struct Score
{
  double rms = 0;   ///< [deg]
  double nees = 0;  ///< mean squared error in units of the stated variance
  double width = 0;
  double std = 0;  ///< [deg] as stated
};

Score scoreOf(const Light& light, double noise, int quality, bool casts_shadow)
{
  constexpr int kPictures = 40;
  cv::RNG random(7);
  Score score;
  for (int i = 0; i < kPictures; ++i)
  {
    const double azimuth = random.uniform(-kPi, kPi), guess = azimuth + random.uniform(-0.01, 0.01);
    const cv::Mat image = taken(painted(azimuth, light), noise, quality, random);
    const auto found = measureSilhouette(image, kMirror, guess, slices(), 3, casts_shadow);
    EXPECT_TRUE(found);
    if (!found) continue;
    const double error = wrap(found->azimuth - azimuth);
    score.rms += square(radToDeg(error)) / kPictures;
    score.nees += square(error / found->std_azimuth) / kPictures;
    score.width += found->width_ratio / kPictures;
    score.std += radToDeg(found->std_azimuth) / kPictures;
  }
  score.rms = std::sqrt(score.rms);
  return score;
}

SliceProfile steps(const Light& light)
{
  cv::RNG random(3);
  const double azimuth = 0.3;
  const auto profile = profileOf(taken(painted(azimuth, light), 0, 0, random), kMirror, azimuth, slices().front(), 6);
  return profile.value_or(SliceProfile{});
}
}  // namespace

TEST(OutlineEquations, GradientOfBrightnessIsThatOfTheResiduals)
{
  const SliceProfile profile = steps({1, 0.8, 0.2});
  ASSERT_GT(profile.size(), 12u);
  OutlineVector at;
  at << 0.3, 0.9 * profile.half_width, 1.1, -0.1, 0.2;
  const auto equations = [&](const OutlineVector& v) {
    return brightnessEquations(profile, {v[0], v[1], v[2], v[3], v[4]});
  };
  const auto cost = [&](const OutlineVector& v)
  { return 0.5 * equations(v).meanSquare() * static_cast<double>(profile.size()); };
  const OutlineVector gradient = equations(at).gradient;
  constexpr double kStep = 0.02;
  OutlineVector numeric;
  for (int i = 0; i < kOutlineParameters; ++i)
  {
    const OutlineVector step = kStep * OutlineVector::Unit(i);
    numeric[i] = (cost(at + step) - cost(at - step)) / (2 * kStep);
  }
  EXPECT_LT((gradient + numeric).norm(), 0.03 * numeric.norm()) << gradient << "\n" << numeric;
}

TEST(OutlineEquations, StepsLeadBack)
{
  const SliceProfile profile = steps({1, 0.8, 0.2});
  for (const auto equations : {colourEquations, brightnessEquations})
    for (const double off : {-0.8, -0.3, 0.3, 0.8})
    {
      Outline outline{off, profile.half_width, 0.8, -0.2, 0};
      for (int round = 0; round < 4; ++round)
      {
        const OutlineEquations e = equations(profile, outline);
        outline.offset += e.gradient[0] / e.information(0, 0);
      }
      EXPECT_NEAR(outline.offset, 0, 0.1) << off;
    }
}

TEST(Silhouette, IsFoundToHundredthsOfAPixel)
{
  for (const bool casts_shadow : {true, false})
  {
    const Score score = scoreOf({}, 1, 0, casts_shadow);
    EXPECT_LT(score.rms, 0.02);
    EXPECT_NEAR(score.width, 1, 0.03);
  }
}

// Edges of these pictures are softened by a Gaussian, so that the share of the blur by which others may be off is more
// than their error.
TEST(Silhouette, StatesHowFarItIsOff)
{
  for (const double noise : {2.0, 6.0})
    for (const bool casts_shadow : {true, false})
    {
      const Score score = scoreOf({}, noise, 0, casts_shadow);
      EXPECT_LT(score.nees, 1.3) << noise << casts_shadow;
      EXPECT_LT(score.std, 0.02 + 0.01 * noise) << noise << casts_shadow;
    }
}

TEST(Silhouette, ColourIsNotMovedByShadeAndShadow)
{
  EXPECT_LT(scoreOf({1, 0.5, 0.3}, 1, 0, true).rms, 0.04);
  EXPECT_LT(scoreOf({1.3, 0.7, 0.0}, 1, 0, true).rms, 0.04);
}

TEST(Silhouette, BrightnessIsSharpWhereColourIsCoarse)
{
  const Score colour = scoreOf({}, 2, 50, true), both = scoreOf({}, 2, 50, false);
  EXPECT_LT(both.rms, 0.7 * colour.rms) << both.rms << " " << colour.rms;
  EXPECT_LT(colour.nees, 2) << colour.rms;
  EXPECT_LT(both.nees, 2) << both.rms;
}

// Darker on one side and farther on the other look alike in a slice of a narrow object, but the one makes all bands
// darker there, the other those that are brighter than the ground.
TEST(Silhouette, ShadeOfNarrowPolesIsNotTakenForTheirPlace)
{
  const Score score = scoreOf({1, 1, 0.15, true}, 3, 50, false);
  EXPECT_LT(score.rms, 0.03);
  EXPECT_LT(score.nees, 1.5);
}

TEST(Silhouette, NothingWhereTheObjectIsNot)
{
  const cv::Mat image = painted(1, {});
  EXPECT_FALSE(measureSilhouette(image, kMirror, 1, {}, 3, false));
  EXPECT_FALSE(measureSilhouette(image, kMirror, 1, {{0.5, 0.51, kHalfWidth}}, 1, false)) << "outside the image";
  const auto found = measureSilhouette(image, kMirror, 1 + 3 * kHalfWidth, slices(), 3, true);
  EXPECT_TRUE(!found || std::abs(found->azimuth - 1) > kHalfWidth);
}
}  // namespace mrpt_ext::test_silhouette
