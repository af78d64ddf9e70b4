#include "mrpt_ext/vision/edge_location.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr int kNeighbourRounds = 12;  ///< neighbours' moves depend on each other
constexpr double kMoveUnknown = 0.6;  ///< share of a neighbour's pull that is not known
constexpr double kUneven = 0.0003;    ///< [rad] standard deviation of a part beyond noise
constexpr double kForeign = 4;        ///< standard deviations from which on a part shows something else
constexpr int kLocationReweightings = 3;

/// [rad] by which `other` moves a part of `edge`: to where the slopes of both profiles cancel. Edges of opposite
/// polarity push each other away.
double pull(const RadialEdge& edge, const EdgePart& part, const RadialEdge& other, double width)
{
  if (part.radius < other.inner || part.radius > other.outer) return 0;
  const double apart = wrap(other.azimuth - edge.azimuth);
  const double height = edge.polarity * other.polarity * other.contrast / edge.contrast;
  return std::clamp(height * apart * std::exp(-square(apart / width) / 2), -width, width);
}

/// A part as its neighbours left it.
struct FreedPart
{
  double azimuth = 0;    ///< [rad] against the edge's
  double variance = 0;   ///< [rad^2]
  double move = 0;       ///< [rad]
  double per_pixel = 0;  ///< [rad] of a pixel that the centre is off
};

struct MeanOfParts
{
  double azimuth = 0;  ///< [rad] against the edge's
  double std = 0;
};

MeanOfParts meanOf(const std::vector<FreedPart>& parts, double centre_std)
{
  std::vector<double> weights(parts.size(), 1.0);
  double total = 0, mean = 0, move = 0, per_pixel = 0, squares = 0, count = 0;
  for (int round = 0; round < kLocationReweightings; ++round)
  {
    total = mean = move = per_pixel = squares = count = 0;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      const double weight = weights[i] / parts[i].variance;
      total += weight;
      mean += weight * parts[i].azimuth;
      move += weight * parts[i].move;
      per_pixel += weight * parts[i].per_pixel;
    }
    mean /= total;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      const double share = square(parts[i].azimuth - mean) / parts[i].variance;
      squares += weights[i] * share;
      count += weights[i];
      // The heaviest part keeps some weight, so that there is always a mean.
      weights[i] = std::max(0.01, share < square(kForeign) ? square(1 - share / square(kForeign)) : 0.0);
    }
  }
  const double scatter = count > 1 ? std::max(1.0, squares / (count - 1)) : 1.0;
  return {mean,
          std::sqrt(scatter / total + square(kMoveUnknown * move / total) + square(centre_std * per_pixel / total))};
}

std::vector<FreedPart> freed(const std::vector<RadialEdge>& edges, const RadialEdge& edge, const EdgeBlur& blur)
{
  std::vector<FreedPart> parts;
  for (const EdgePart& part : edge.parts)
  {
    double move = 0;
    for (const RadialEdge& other : edges)
      if (&other != &edge) move += pull(edge, part, other, blur.widthAt(part.radius));
    const double pixel = 1 / (part.radius * blur.radius);
    const double coding = edge.polarity * edge.coding_shift * pixel;
    parts.push_back({wrap(part.azimuth - edge.azimuth) - move + coding,
                     square(part.std_azimuth) + square(kUneven) + square(kMoveUnknown * move), move, pixel});
  }
  return parts;
}
}  // namespace

double EdgeBlur::widthAt(double share) const { return std::hypot(smoothing, pixels / (radius * share)); }

void locateByParts(std::vector<RadialEdge>& edges, const EdgeBlur& blur, double centre_std, double floor)
{
  for (int round = 0; round < kNeighbourRounds; ++round)
  {
    std::vector<MeanOfParts> means;
    for (const RadialEdge& edge : edges)
      means.push_back(meanOf(freed(edges, edge, blur), std::hypot(centre_std, edge.std_clipping)));
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      edges[i].azimuth = wrap(edges[i].azimuth + means[i].azimuth);
      edges[i].std_azimuth = std::hypot(means[i].std, floor);
    }
  }
}
}  // namespace mrpt_ext
