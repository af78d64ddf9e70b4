#include "mrpt_ext/vision/pole_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr int kAcross = 5;               ///< azimuths in the middle of the pole
constexpr double kMiddleShare = 0.4;     ///< of its half width to either side
constexpr double kSample = 0.25;         ///< [px] along a radius
constexpr double kStdBoundary = 0.15;    ///< [px] of a boundary's radius
constexpr double kMostResidual = 0.6;    ///< [px] boundaries that fit no distance are not the pole's
constexpr double kMostChange = 0.12;     ///< of the distance by all colours, share
constexpr double kLeastContrast = 0.05;  ///< squared difference of the bands' colours, share of their squared light
constexpr std::array kBoundaries{2.0 / 3, 1.0 / 3};  ///< shares of the pole's height
constexpr double kHalfBand = 1.0 / 6;                ///< likewise
constexpr int kDistanceRounds = 4;

/// Mean light at a radius in the middle of the pole.
std::optional<cv::Vec3d> lightAcross(const cv::Mat& image, const HyperbolicMirror& mirror, const ObjectGuess& guess,
                                     double rho)
{
  cv::Vec3d sum(0, 0, 0);
  for (int i = 0; i < kAcross; ++i)
  {
    const double offset = (2.0 * i / (kAcross - 1) - 1) * kMiddleShare * guess.half_width;
    const auto light = lightAt(image, mirror.pixel(guess.azimuth + offset, rho));
    if (!light) return std::nullopt;
    sum += *light;
  }
  return sum / kAcross;
}

/// Radius at which one colour becomes another between the radii `low` and `high`: the shares of the other one, summed.
std::optional<double> boundaryBetween(const cv::Mat& image, const HyperbolicMirror& mirror, const ObjectGuess& guess,
                                      double low, double high)
{
  const int count = static_cast<int>((high - low) * mirror.focalLength() / kSample), level = count / 4;
  if (level < 2) return std::nullopt;
  std::vector<cv::Vec3d> lights;
  for (int i = 0; i < count; ++i)
  {
    const auto light = lightAcross(image, mirror, guess, low + (i + 0.5) * (high - low) / count);
    if (!light) return std::nullopt;
    lights.push_back(*light);
  }
  cv::Vec3d inner(0, 0, 0), outer(0, 0, 0);
  for (int i = 0; i < level; ++i)
  {
    inner += lights[static_cast<std::size_t>(i)] / level;
    outer += lights[static_cast<std::size_t>(count - 1 - i)] / level;
  }
  const cv::Vec3d change = outer - inner;
  if (change.dot(change) < kLeastContrast * (inner.dot(inner) + outer.dot(outer))) return std::nullopt;
  double inside = 0;
  for (const cv::Vec3d& light : lights) inside += (outer - light).dot(change) / change.dot(change);
  if (inside < level || inside > count - level) return std::nullopt;
  return low + inside / count * (high - low);
}
}  // namespace

std::optional<PoleDistance> distanceByBands(const cv::Mat& image, const HyperbolicMirror& mirror, double pole_height,
                                            const ObjectGuess& guess)
{
  const auto rhoOf = [&](double share, double distance)
  { return mirror.rhoAt(mirror.slopeOf(share * pole_height, distance)); };
  std::array<double, kBoundaries.size()> seen{};
  for (std::size_t i = 0; i < kBoundaries.size(); ++i)
  {
    const auto rho = boundaryBetween(image, mirror, guess, rhoOf(kBoundaries[i] - kHalfBand, guess.distance),
                                     rhoOf(kBoundaries[i] + kHalfBand, guess.distance));
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
      const double here = rhoOf(kBoundaries[i], distance);
      const double slope = (rhoOf(kBoundaries[i], distance + kStep) - here) / kStep;
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
