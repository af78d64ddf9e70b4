#include "mrpt_ext/vision/omni_objects.h"

#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/image_check.h"
#include "mrpt_ext/vision/pole_cover.h"
#include "mrpt_ext/vision/pole_distance.h"
#include "mrpt_ext/vision/silhouette.h"

namespace mrpt_ext
{
namespace
{
constexpr int kRimSamples = 90;
constexpr double kRimDistance = 0.04;   ///< of the samples on either side of the rim, share of its radius
constexpr double kSliceHeight = 2;      ///< [px]
constexpr int kMinSliceCount = 5;       ///< of one colour, so that they can be compared
constexpr double kSliceMargin = 1.5;    ///< [px] from where a colour ends
constexpr double kGuessedWidth = 0.04;  ///< standard deviation of a pole's width by a rough distance, share
constexpr double kGuessedRadius = 1;    ///< [px] of the image radius of a ball's middle
constexpr double kSeenWidth = 0.08;     ///< [px] of half a silhouette's width that its slices have in common
constexpr double kBallShare = 0.75;     ///< of the ball's height that is measured: its poles are short

int brightnessAt(const cv::Mat& image, const cv::Point2d& position)
{
  const cv::Point pixel(cvRound(position.x), cvRound(position.y));
  if (!cv::Rect({0, 0}, image.size()).contains(pixel)) return -1;
  const auto& p = image.at<cv::Vec3b>(pixel);
  return (p[0] + p[1] + p[2]) / 3;
}

/// True when enough of the mirror's rim is at its expected position: bright inside, dark outside. What is the other way
/// round counts against it, else mere noise would have a rim.
bool rimIsThere(const cv::Mat& image, const OmniCameraSettings& settings)
{
  const HyperbolicMirror& mirror = settings.mirror;
  int seen = 0, counted = 0;
  for (int i = 0; i < kRimSamples; ++i)
  {
    const double azimuth = kTwoPi * i / kRimSamples;
    const int inside = brightnessAt(image, mirror.pixel(azimuth, (1 - kRimDistance) * mirror.rimRho()));
    const int outside = brightnessAt(image, mirror.pixel(azimuth, (1 + kRimDistance) * mirror.rimRho()));
    if (inside < 0 || outside < 0) continue;
    ++counted;
    if (inside - outside >= settings.rim_contrast) ++seen;
    if (outside - inside >= settings.rim_contrast) --seen;
  }
  return counted > 0 && seen >= settings.rim_visible_share * counted;
}

/// Cuts image radii [low, high], `margin` [px] less at both ends, into slices; `half_width` is half the object's width
/// at a radius.
template <typename HalfWidth>
void addSlices(std::vector<SilhouetteSlice>& slices, const HyperbolicMirror& mirror, double low, double high,
               double margin, const HalfWidth& half_width)
{
  const double pixel = 1 / mirror.focalLength();
  low += margin * pixel;
  high = std::min(high - margin * pixel, mirror.rimRho() - 2 * kSliceMargin * pixel);
  const double pixels = (high - low) / pixel;
  if (pixels < 1) return;
  const int count = std::max(kMinSliceCount, static_cast<int>(std::lround(pixels / kSliceHeight)));
  const double height = (high - low) / count;
  for (int i = 0; i < count; ++i)
    slices.push_back({low + i * height, low + (i + 1) * height, half_width(low + (i + 0.5) * height)});
}

std::vector<SilhouetteSlice> poleSlices(const OmniCameraSettings& settings, const ObjectGuess& guess)
{
  const HyperbolicMirror& mirror = settings.mirror;
  const auto rho_of = [&](double share)
  { return mirror.rhoAt(mirror.slopeOf(share * settings.sizes.pole_height, guess.distance)); };
  std::vector<SilhouetteSlice> slices;
  for (int band = 0; band < 3; ++band)
    addSlices(slices, mirror, rho_of(band / 3.0), rho_of((band + 1) / 3.0), kSliceMargin,
              [&](double) { return guess.half_width; });
  return slices;
}

/// The outline of a sphere: directions at the angle `radius` from that to its middle.
std::vector<SilhouetteSlice> ballSlices(const OmniCameraSettings& settings, const ObjectGuess& guess)
{
  const HyperbolicMirror& mirror = settings.mirror;
  const double slope = mirror.slopeOf(settings.sizes.ball_radius, guess.distance);
  const double middle = std::atan(slope);
  const double radius = std::asin(std::min(1.0, settings.sizes.ball_radius * std::cos(middle) / guess.distance));
  std::vector<SilhouetteSlice> slices;
  addSlices(slices, mirror, mirror.rhoAt(std::tan(middle - kBallShare * radius)),
            mirror.rhoAt(std::tan(middle + kBallShare * radius)), 0,
            [&](double rho)
            {
              const double elevation = std::atan(mirror.slopeAt(rho));
              const double cosine = (std::cos(radius) - std::sin(elevation) * std::sin(middle)) /
                                    (std::cos(elevation) * std::cos(middle));
              return std::acos(std::clamp(cosine, -1.0, 1.0));
            });
  return slices;
}

/// Half of an object's width by its distance.
struct ExpectedWidth
{
  double half_width = 0, std = 0;  ///< [rad]
};

std::optional<ExpectedWidth> widthByBands(const cv::Mat& image, const OmniCameraSettings& settings,
                                          const ObjectGuess& seen)
{
  const auto by_bands = distanceByBands(image, settings.mirror, settings.sizes, seen);
  if (!by_bands) return std::nullopt;
  const double half_width = poleHalfWidth(settings.sizes, by_bands->distance);
  return ExpectedWidth{half_width, by_bands->std / by_bands->distance * half_width};
}

/// A ball's distance, and so its width, is known as well as where its middle is.
ExpectedWidth widthOfBall(const OmniCameraSettings& settings, const ObjectGuess& guess)
{
  const HyperbolicMirror& mirror = settings.mirror;
  const double drop = mirror.focus_height - settings.sizes.ball_radius;
  const double rho = mirror.rhoAt(-drop / guess.distance) + kGuessedRadius / mirror.focalLength();
  const double farther = -drop / std::min(mirror.slopeAt(rho), -1e-3);
  return {guess.half_width, (farther / guess.distance - 1) * guess.half_width};
}

/// False where what is found beside a pole hides nothing of it.
bool hidesSome(const PoleCover& cover, const ObjectGuess& guess)
{
  return std::abs(cover.edge - guess.azimuth) < guess.half_width;
}

bool isBlocked(const std::vector<BlockedSector>& sectors, double azimuth)
{
  for (const BlockedSector& sector : sectors)
    if (std::abs(wrap(azimuth - sector.middle)) < sector.half_width) return true;
  return false;
}
}  // namespace

bool OmniCamera::measure(const cv::Mat& image, const std::string& label, const ObjectGuess& guess, OmniView& view) const
{
  const bool is_ball = label == "ball";
  const auto slices = is_ball ? ballSlices(settings_, guess) : poleSlices(settings_, guess);
  const auto silhouette =
      measureSilhouette(image, settings_.mirror, guess.azimuth, slices, settings_.min_slices, is_ball);
  if (isBlocked(settings_.blocked, silhouette ? silhouette->azimuth : guess.azimuth))
  {
    view.hidden.push_back({label, guess.azimuth, guess.half_width, guess.half_width, guess.distance});
    return true;
  }
  if (!is_ball)
    if (const auto cover = coverOfPole(image, settings_.mirror, settings_.sizes, guess);
        cover && hidesSome(*cover, guess))
      return measureCovered(image, label, guess, *cover, view);
  if (!silhouette) return false;
  const ObjectGuess seen{silhouette->azimuth, silhouette->width_ratio * guess.half_width, guess.distance};
  if (!is_ball && !bandsMeetThere(image, settings_.mirror, settings_.sizes, seen)) return false;
  const ExpectedWidth expected = is_ball
                                     ? widthOfBall(settings_, guess)
                                     : widthByBands(image, settings_, seen)
                                           .value_or(ExpectedWidth{guess.half_width, kGuessedWidth * guess.half_width});
  if (std::abs(seen.half_width - expected.half_width) > settings_.search.width_tolerance * expected.half_width)
    return false;
  // What is missing of the width may be missing on either side.
  const double pixel = 1 / (settings_.mirror.focalLength() * 0.5 * (slices.front().rho_low + slices.back().rho_high));
  const double std_width = std::hypot(silhouette->std_width_ratio * guess.half_width, kSeenWidth * pixel);
  const double missing = std::sqrt(
      std::max(0.0, square(seen.half_width - expected.half_width) - square(expected.std) - square(std_width)));
  const double std = std::sqrt(square(silhouette->std_azimuth) + square(settings_.std_floor) + square(missing));
  view.objects.push_back({label, silhouette->azimuth, std, seen.half_width, guess.distance});
  return true;
}

bool OmniCamera::measureCovered(const cv::Mat& image, const std::string& label, const ObjectGuess& guess,
                                const PoleCover& cover, OmniView& view) const
{
  // The pole's colours are seen about the guess, from what hides the rest to the other edge.
  const ObjectGuess part{guess.azimuth, std::abs(cover.edge - guess.azimuth), guess.distance};
  const auto expected = widthByBands(image, settings_, part);
  if (!expected) return false;
  const auto edge = measureEdge(image, settings_.mirror, part.azimuth, poleSlices(settings_, part),
                                settings_.min_slices, -cover.side);
  if (!edge) return false;
  const double std = std::sqrt(square(edge->std_azimuth) + square(settings_.std_floor) + square(expected->std));
  view.objects.push_back(
      {label, wrap(edge->azimuth + cover.side * expected->half_width), std, expected->half_width, guess.distance});
  return true;
}

OmniView OmniCamera::view(const cv::Mat& image) const
{
  OmniView view;
  view.problem = complaintAboutImage(image, settings_.image_size);
  if (view.problem.empty() && image.channels() != 3) view.problem = "image is grey, expected colours";
  if (view.problem.empty() && !rimIsThere(image, settings_)) view.problem = "no mirror found";
  if (!view.problem.empty()) return view;
  const cv::Mat panorama = panorama_.unroll(image);
  view.white = settings_.colours.white.value_or(whiteOf(panorama, settings_.colours.white_share));
  const cv::Mat1b colours = classifyColours(panorama, settings_.colours, view.white);
  const ColourCounts yellow = countColour(colours, ObjectColour::yellow);
  const ColourCounts blue = countColour(colours, ObjectColour::blue);
  const auto pole = [&](const ColourCounts& ends, const ColourCounts& middle)
  { return findBandedPole(ends, middle, panorama_, settings_.mirror, settings_.sizes, settings_.search); };
  if (const auto p = pole(yellow, blue)) measure(image, "p", *p, view);
  if (const auto q = pole(blue, yellow)) measure(image, "q", *q, view);
  for (const ObjectGuess& ball : findBalls(colours, panorama_, settings_.mirror, settings_.sizes, settings_.search))
    if (measure(image, "ball", ball, view)) break;
  return view;
}
}  // namespace mrpt_ext
