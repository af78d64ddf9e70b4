#include "mrpt_ext/vision/pole_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mrpt_ext/vision/light_coding.h"
#include "mrpt_ext/vision/slice_profile.h"

namespace mrpt_ext
{
namespace
{
constexpr int kAcross = 5;               ///< azimuths in the middle of the pole
constexpr double kMiddleShare = 0.4;     ///< of its half width to either side
constexpr double kSample = 0.25;         ///< [px] along a radius
constexpr double kStdBoundary = 0.15;    ///< [px] of a boundary's radius
constexpr double kMostResidual = 0.6;    ///< [px] boundaries that fit no distance are not the pole's
constexpr double kMostOffByColour = 2;   ///< [px] of a boundary from that of all colours: pixels of coarse colour
constexpr double kMostChange = 0.12;     ///< of the distance by all colours, share
constexpr double kLeastContrast = 0.05;  ///< squared difference of the bands' colours, share of their squared levels
constexpr std::array kBoundaries{2.0 / 3, 1.0 / 3};  ///< shares of the pole's height
constexpr double kHalfBand = 1.0 / 6;                ///< likewise
constexpr int kDistanceRounds = 4;

/// Mean grey levels at a radius in the middle of the pole.
std::optional<cv::Vec3d> levelsAcross(const cv::Mat& image, const HyperbolicMirror& mirror, const ObjectGuess& guess,
                                      double rho)
{
  cv::Vec3d sum(0, 0, 0);
  for (int i = 0; i < kAcross; ++i)
  {
    const double offset = (2.0 * i / (kAcross - 1) - 1) * kMiddleShare * guess.half_width;
    const auto levels = levelsAt(image, mirror.pixel(guess.azimuth + offset, rho));
    if (!levels) return std::nullopt;
    sum += *levels;
  }
  return sum / kAcross;
}

/// [px] by which a boundary seems too near to the image's centre since pixels on it sum light, each channel by itself.
double codingShift(const cv::Vec3d& inner, const cv::Vec3d& outer)
{
  double shift = 0, weights = 0;
  for (int c = 0; c < 3; ++c)
  {
    const double change = outer[c] - inner[c];
    weights += change * change;
    shift += change * change * std::copysign(shiftByCoding(inner[c], outer[c]), change);
  }
  return shift / weights;
}

/// Radius at which one colour becomes another between the radii `low` and `high`: the shares of the other one, summed.
std::optional<double> boundaryBetween(const cv::Mat& image, const HyperbolicMirror& mirror, const ObjectGuess& guess,
                                      double low, double high)
{
  const int count = static_cast<int>((high - low) * mirror.focalLength() / kSample), level = count / 4;
  if (level < 2) return std::nullopt;
  std::vector<cv::Vec3d> all;
  for (int i = 0; i < count; ++i)
  {
    const auto levels = levelsAcross(image, mirror, guess, low + (i + 0.5) * (high - low) / count);
    if (!levels) return std::nullopt;
    all.push_back(*levels);
  }
  cv::Vec3d inner(0, 0, 0), outer(0, 0, 0);
  for (int i = 0; i < level; ++i)
  {
    inner += all[static_cast<std::size_t>(i)] / level;
    outer += all[static_cast<std::size_t>(count - 1 - i)] / level;
  }
  const cv::Vec3d change = outer - inner;
  if (change.dot(change) < kLeastContrast * (inner.dot(inner) + outer.dot(outer))) return std::nullopt;
  double inside = 0;
  for (const cv::Vec3d& levels : all) inside += (outer - levels).dot(change) / change.dot(change);
  if (inside < level || inside > count - level) return std::nullopt;
  return low + inside / count * (high - low) + codingShift(inner, outer) / mirror.focalLength();
}

/// Image radius of a share of the height of a pole: what is seen of it is its front.
double rhoOnPole(const HyperbolicMirror& mirror, const FieldObjectSizes& sizes, double share, double distance)
{
  return mirror.rhoAt(mirror.slopeOf(share * sizes.pole_height, distance - sizes.pole_radius));
}

/// Image radius of a boundary, sought where the guess has it.
std::optional<double> boundaryAt(const cv::Mat& image, const HyperbolicMirror& mirror, const FieldObjectSizes& sizes,
                                 const ObjectGuess& guess, double share)
{
  return boundaryBetween(image, mirror, guess, rhoOnPole(mirror, sizes, share - kHalfBand, guess.distance),
                         rhoOnPole(mirror, sizes, share + kHalfBand, guess.distance));
}
}  // namespace

bool bandsMeetThere(const cv::Mat& image, const HyperbolicMirror& mirror, const FieldObjectSizes& sizes,
                    const ObjectGuess& guess)
{
  for (const double share : kBoundaries)
  {
    if (rhoOnPole(mirror, sizes, share + kHalfBand, guess.distance) > mirror.rimRho()) continue;
    const auto rho = boundaryAt(image, mirror, sizes, guess, share);
    const double expected = rhoOnPole(mirror, sizes, share, guess.distance);
    return rho && std::abs(*rho - expected) * mirror.focalLength() < kMostOffByColour;
  }
  return false;
}

std::optional<PoleDistance> distanceByBands(const cv::Mat& image, const HyperbolicMirror& mirror,
                                            const FieldObjectSizes& sizes, const ObjectGuess& guess)
{
  const auto rho_of = [&](double share, double distance) { return rhoOnPole(mirror, sizes, share, distance); };
  std::array<double, kBoundaries.size()> seen{};
  for (std::size_t i = 0; i < kBoundaries.size(); ++i)
  {
    const auto rho = boundaryAt(image, mirror, sizes, guess, kBoundaries[i]);
    if (!rho) return std::nullopt;
    seen[i] = *rho;
  }
  double distance = guess.distance, information = 0, largest = 0;
  for (int round = 0; round < kDistanceRounds; ++round)
  {
    double right = information = largest = 0;
    for (std::size_t i = 0; i < kBoundaries.size(); ++i)
    {
      constexpr double kStep = 1e-4;
      const double here = rho_of(kBoundaries[i], distance);
      const double slope = (rho_of(kBoundaries[i], distance + kStep) - here) / kStep;
      information += slope * slope;
      right += slope * (seen[i] - here);
      largest = std::max(largest, std::abs(seen[i] - here) * mirror.focalLength());
    }
    distance += right / information;
    if (!(std::abs(distance / guess.distance - 1) < kMostChange)) return std::nullopt;
  }
  if (largest > kMostResidual) return std::nullopt;
  return PoleDistance{distance, kStdBoundary / mirror.focalLength() / std::sqrt(information)};
}
}  // namespace mrpt_ext
