#include "mrpt_ext/vision/edge_location.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr int kNeighbourRounds = 12;  ///< neighbours' moves depend on each other
constexpr int kTopRounds = 4;
constexpr double kLeastLeft = 0.3;     ///< of its height, by neighbours; edges with less are not seen
constexpr double kMoveUnknown = 0.35;  ///< share of a neighbour's pull that is not known
constexpr double kPullReach = 5;       ///< [widths] between edges
constexpr double kUsualDrift = 0.09;   ///< of an edge's width, by what is beside it
constexpr double kDriftUnknown = 0.7;  ///< of the drift that smoothing has moved an edge by, standard deviation
constexpr double kDriftNoise = 1.2;    ///< of an edge's own noise, in its drift
constexpr double kPriorFreedom = 5;    ///< degrees of freedom that what is usual counts as
constexpr double kMostScatter = 4;     ///< of an edge that tells what is usual, in units of its parts' variances
constexpr double kUnevenPart = 0.02;   ///< [px] standard deviation of a part, by the raster of the pixels
constexpr double kUnevenEdge = 0.02;   ///< [px] of all parts of an edge alike
constexpr double kForeign = 4;         ///< standard deviations from which on a part shows something else
constexpr int kLocationReweightings = 3;

/// The profile of an edge and of its neighbours at one radius, in the edge's own height: Gaussians of one width. Edges
/// of the other polarity are negative.
class CrowdedProfile
{
 public:
  explicit CrowdedProfile(double width) : width_(width) {}

  void add(double apart, double height) { neighbours_.push_back({apart, height}); }
  [[nodiscard]] bool isCrowded() const { return !neighbours_.empty(); }

  /// [rad] by which the neighbours move what is located by a Gaussian through three samples so far apart.
  [[nodiscard]] double displacement(double spacing) const
  {
    const double top = highest();
    const double before = at(top - spacing), here = at(top), behind = at(top + spacing);
    if (!(before > 0) || !(here > 0) || !(behind > 0)) return top;
    const double a = std::log(before), b = std::log(here), c = std::log(behind), bend = a - 2 * b + c;
    if (!(bend < 0)) return top;
    return top + std::clamp(0.5 * (a - c) / bend, -1.0, 1.0) * spacing;
  }
  /// Of the top, in heights of the edge alone.
  [[nodiscard]] double topHeight() const { return at(highest()); }

 private:
  struct Neighbour
  {
    double apart = 0, height = 0;
  };

  [[nodiscard]] double bell(double x) const { return std::exp(-square(x / width_) / 2); }
  [[nodiscard]] double at(double x) const
  {
    double sum = bell(x);
    for (const Neighbour& other : neighbours_) sum += other.height * bell(x - other.apart);
    return sum;
  }
  /// Where the slopes cancel, by Newton's method from the edge itself.
  [[nodiscard]] double highest() const
  {
    double top = 0;
    for (int round = 0; round < kTopRounds; ++round)
    {
      double slope = 0, bend = 0;
      const auto add = [&](double x, double height)
      {
        const double bells = height * bell(x);
        slope -= x / square(width_) * bells, bend += (square(x / width_) - 1) / square(width_) * bells;
      };
      add(top, 1);
      for (const Neighbour& other : neighbours_) add(top - other.apart, other.height);
      if (!(bend < 0)) break;
      top = std::clamp(top - slope / bend, -width_, width_);
    }
    return top;
  }

  double width_;
  std::vector<Neighbour> neighbours_;
};

CrowdedProfile profileAt(const RadialEdge& edge, double radius, const std::vector<RadialEdge>& edges, double width)
{
  CrowdedProfile profile(width);
  for (const RadialEdge& other : edges)
  {
    if (&other == &edge || (edge.pair != 0 && other.pair == edge.pair)) continue;
    if (radius < other.inner || radius > other.outer) continue;
    const double apart = wrap(other.azimuth - edge.azimuth);
    if (std::abs(apart) < kPullReach * width)
      profile.add(apart, edge.polarity * other.polarity * other.height / edge.height);
  }
  return profile;
}

double heightAlone(const RadialEdge& edge, const std::vector<RadialEdge>& edges, const EdgeBlur& blur)
{
  const double radius = std::sqrt(edge.inner * edge.outer);
  const CrowdedProfile profile = profileAt(edge, radius, edges, blur.widthAt(radius));
  return profile.isCrowded() ? edge.contrast / std::max(kLeastLeft, profile.topHeight()) : edge.contrast;
}

/// A part as its neighbours left it.
struct FreedPart
{
  double azimuth = 0;     ///< [rad] against the edge's
  double variance = 0;    ///< [rad^2]
  double move = 0;        ///< [rad] by neighbours
  double drift = 0;       ///< [rad] with more smoothing, but for what neighbours do
  double wider_move = 0;  ///< [rad] by which neighbours move it more with more smoothing
  double per_pixel = 0;   ///< [rad] of a pixel that the centre is off
};

struct MeanOfParts
{
  double azimuth = 0;  ///< [rad] against the edge's
  double std = 0;
  double squares = 0, freedom = 0;  ///< of the parts about the mean, in units of their variances; degrees of freedom
};

/// How much parts scatter in this image, in units of their variances. Noise is measured where there are few edges:
/// bricks make it seem larger than it is beside edges, a camera's compression and sharpening smaller.
double usualScatter(const std::vector<MeanOfParts>& means)
{
  double squares = kPriorFreedom, freedom = kPriorFreedom;
  for (const MeanOfParts& mean : means)
  {
    squares += std::min(mean.squares, kMostScatter * mean.freedom);
    freedom += mean.freedom;
  }
  return squares / freedom;
}

/// What is beside an edge moves it the more, the more the image is smoothed. How far without smoothing, and the
/// variance that this leaves.
struct DriftedBack
{
  double move = 0, variance = 0;
};

/// From the drift with more smoothing and its standard deviation [rad], for an edge whose profile has this width.
DriftedBack driftedBack(double drift, double std_drift, double width)
{
  const double usual = square(kUsualDrift * width), believed = drift * usual / (usual + square(std_drift));
  const double left = usual * square(std_drift) / (usual + square(std_drift));
  return {-believed, square(kDriftUnknown * believed) + left};
}

/// Variance of the mean in units of that by noise. Noise is another one in every part. What makes parts scatter more
/// may last along the edge, and so be no smaller in the mean.
double scatterOfMean(double scatter, double freedom) { return scatter + freedom * std::max(0.0, scatter - 1); }

MeanOfParts meanOf(const std::vector<FreedPart>& parts, double centre_std, double width, double usual_scatter)
{
  std::vector<double> weights(parts.size(), 1.0);
  double total = 0, mean = 0, move = 0, drift = 0, wider_move = 0, per_pixel = 0, squares = 0, count = 0;
  for (int round = 0; round < kLocationReweightings; ++round)
  {
    total = mean = move = drift = wider_move = per_pixel = squares = count = 0;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      const double weight = weights[i] / parts[i].variance;
      total += weight;
      mean += weight * parts[i].azimuth;
      move += weight * parts[i].move;
      drift += weight * parts[i].drift;
      wider_move += weight * parts[i].wider_move;
      per_pixel += weight * parts[i].per_pixel;
    }
    mean /= total, move /= total, drift /= total, wider_move /= total, per_pixel /= total;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      const double share = square(parts[i].azimuth - mean) / parts[i].variance;
      squares += weights[i] * share;
      count += weights[i];
      // The heaviest part keeps some weight, so that there is always a mean.
      weights[i] = std::max(0.01, share < square(kForeign) ? square(1 - share / square(kForeign)) : 0.0);
    }
  }
  const double freedom = std::max(0.0, count - 1);
  if (freedom == 0) squares = 0;
  const double scatter = (kPriorFreedom * usual_scatter + squares) / (kPriorFreedom + freedom);
  const double std_drift = std::hypot(kDriftNoise * std::sqrt(scatter / total), kMoveUnknown * wider_move);
  const DriftedBack back = driftedBack(drift, std_drift, width);
  return {mean + back.move,
          std::sqrt(scatterOfMean(scatter, freedom) / total + square(kMoveUnknown * move) + back.variance +
                    square(std::hypot(centre_std, kUnevenEdge) * per_pixel)),
          squares, freedom};
}

std::vector<FreedPart> freed(const std::vector<RadialEdge>& edges, const RadialEdge& edge, const EdgeBlur& blur)
{
  const EdgeBlur more = blur.smoothed(kMoreSmoothing);
  std::vector<FreedPart> parts;
  for (const EdgePart& part : edge.parts)
  {
    double move = 0, softer = 0;
    if (const auto profile = profileAt(edge, part.radius, edges, blur.widthAt(part.radius)); profile.isCrowded())
      move = profile.displacement(part.spacing);
    if (part.soft_spacing > 0)
      if (const auto profile = profileAt(edge, part.radius, edges, more.widthAt(part.radius)); profile.isCrowded())
        softer = profile.displacement(part.soft_spacing);
    const double more_move = part.soft_spacing > 0 ? softer - move : 0;
    const double pixel = 1 / (part.radius * blur.radius);
    const double coding = edge.polarity * edge.coding_shift * pixel;
    parts.push_back({wrap(part.azimuth - edge.azimuth) - move + coding,
                     square(part.std_azimuth) + square(kUnevenPart * pixel) + square(kMoveUnknown * move), move,
                     part.drift - more_move, more_move, pixel});
  }
  return parts;
}
}  // namespace

double EdgeBlur::widthAt(double share) const { return std::hypot(smoothing, pixels / (radius * share)); }

void locateByParts(std::vector<RadialEdge>& edges, const EdgeBlur& blur, double centre_std, double floor)
{
  double usual_scatter = 1;
  for (int round = 0; round < kNeighbourRounds; ++round)
  {
    std::vector<MeanOfParts> means;
    for (const RadialEdge& edge : edges)
      means.push_back(
          meanOf(freed(edges, edge, blur), std::hypot(centre_std, edge.std_clipping), edge.width, usual_scatter));
    usual_scatter = usualScatter(means);
    std::vector<double> heights;
    for (const RadialEdge& edge : edges) heights.push_back(heightAlone(edge, edges, blur));
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      edges[i].azimuth = wrap(edges[i].azimuth + means[i].azimuth);
      edges[i].height = heights[i];
      edges[i].std_azimuth = std::hypot(means[i].std, floor);
    }
  }
}
}  // namespace mrpt_ext
