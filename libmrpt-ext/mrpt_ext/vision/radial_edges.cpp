#include "mrpt_ext/vision/radial_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/vision/radial_votes.h"

namespace mrpt_ext
{
namespace
{
constexpr double kNeighbourhood = 1.3;  ///< a peak is the largest within this many standard deviations of the smoothing
constexpr double kFlank = 6;            ///< its flanks reach so many standard deviations
/// Neighbouring rows share pixels, and so do the rows of one pixel near the centre.
constexpr double kRowCorrelation = 1.2;
constexpr int kNeighbourRounds = 12;  ///< neighbours' moves depend on each other
constexpr double kMoveUnknown = 0.5;  ///< share of a neighbour's pull that is not known

/// Steps of one run of rows summed with the weights 1/noise^2, for azimuths around one column.
class RunProfile
{
 public:
  RunProfile(const AzimuthSteps& steps, const RadialRun& run, int polarity) : steps_(steps), run_(run)
  {
    for (int row = run.first; row < run.end; ++row)
    {
      const double noise = steps.noise[static_cast<std::size_t>(row)];
      weights_.push_back(polarity / square(noise));
      total_ += 1 / square(noise);
    }
    noise_ = kRowCorrelation / std::sqrt(total_);
  }

  /// [grey levels] mean step at a column, which may be beyond either end of a turn.
  [[nodiscard]] double operator()(int column) const
  {
    const int columns = steps_.heights.cols, j = ((column % columns) + columns) % columns;
    double sum = 0;
    for (int row = run_.first; row < run_.end; ++row)
      sum += weights_[static_cast<std::size_t>(row - run_.first)] * steps_.heights.at<float>(row, j);
    return sum / total_;
  }
  [[nodiscard]] double noise() const { return noise_; }

 private:
  const AzimuthSteps& steps_;
  RadialRun run_;
  std::vector<double> weights_;
  double total_ = 0, noise_ = 0;
};

/// A peak of a profile: a Gaussian through three samples.
struct Peak
{
  double offset = 0;  ///< [columns] from the middle sample
  double sigma = 0;   ///< [columns]
  double height = 0;
};

std::optional<Peak> gaussianPeak(double before, double here, double behind, double spacing)
{
  if (!(before > 0) || !(here > 0) || !(behind > 0)) return std::nullopt;
  const double a = std::log(before), b = std::log(here), c = std::log(behind), bend = a - 2 * b + c;
  if (!(bend < 0)) return std::nullopt;
  const double offset = 0.5 * (a - c) / bend;
  if (!(std::abs(offset) < 1)) return std::nullopt;
  return Peak{offset * spacing, spacing / std::sqrt(-bend), here};
}

/// How far the profile falls on the side that falls less, share of the peak (1: to nothing or below).
double prominence(const RunProfile& profile, int column, double peak, int reach)
{
  const auto lowest = [&](int direction)
  {
    double low = peak;
    for (int k = 1; k <= reach && low > 0; ++k) low = std::min(low, profile(column + direction * k));
    return std::max(low, 0.0);
  };
  return 1 - std::max(lowest(-1), lowest(1)) / peak;
}

/// Columns where the evidence is largest among their neighbours.
std::vector<int> peakColumns(const std::vector<RadialRun>& runs, int reach, float least)
{
  const int columns = static_cast<int>(runs.size());
  const auto evidence = [&](int j) { return runs[static_cast<std::size_t>((j + columns) % columns)].evidence; };
  std::vector<int> peaks;
  for (int j = 0; j < columns; ++j)
  {
    bool is_peak = evidence(j) > least;
    for (int k = 1; k <= reach && is_peak; ++k)
      is_peak = evidence(j) > evidence(j - k) && evidence(j) >= evidence(j + k);
    if (is_peak) peaks.push_back(j);
  }
  return peaks;
}

/// [rad] by which `other`, at `position`, moves the peak of an edge at `own_position`: the slope of its profile there
/// over the peak's bend. Edges of opposite polarity push each other away.
double pull(const RadialEdge& edge, double own_position, const RadialEdge& other, double position)
{
  if (std::max(edge.inner, other.inner) >= std::min(edge.outer, other.outer)) return 0;  // at different heights
  const double apart = wrap(position - own_position), variance = square(other.width);
  const double height = edge.polarity * other.polarity * other.contrast / edge.contrast;
  return height * square(edge.width) * apart / variance * std::exp(-square(apart) / (2 * variance));
}

void moveNeighboursBack(std::vector<RadialEdge>& edges)
{
  std::vector<double> seen, moves(edges.size(), 0.0);
  for (const RadialEdge& e : edges) seen.push_back(e.azimuth);
  for (int round = 0; round < kNeighbourRounds; ++round)
  {
    std::vector<double> next(edges.size(), 0.0);
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = 0; j < edges.size(); ++j)
        if (j != i) next[i] += pull(edges[i], seen[i] - moves[i], edges[j], seen[j] - moves[j]);
    for (std::size_t i = 0; i < edges.size(); ++i) next[i] = std::clamp(next[i], -edges[i].width, edges[i].width);
    moves = next;
  }
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    edges[i].azimuth = wrap(seen[i] - moves[i]);
    edges[i].std_azimuth = std::hypot(edges[i].std_azimuth, kMoveUnknown * moves[i]);
  }
}

double medianBrightness(const PolarImage& polar)
{
  std::vector<float> values;
  for (int row = 0; row < polar.grey.rows; row += 4)
    for (int j = 0; j < polar.grey.cols; j += 8) values.push_back(polar.grey.at<float>(row, j));
  return upperMedian(std::move(values));
}
}  // namespace

std::vector<RadialEdge> findRadialEdges(const PolarImage& polar, double centre_std, double radius,
                                        const RadialEdgeSettings& settings)
{
  const AzimuthSteps steps = stepsAlongAzimuth(polar, settings.smoothing);
  const double step = polar.grid.azimuthStep(), smoothing = settings.smoothing / step;
  const int spacing = std::max(1, static_cast<int>(std::lround(smoothing)));
  const double least_contrast = settings.min_contrast * medianBrightness(polar);
  std::vector<RadialEdge> edges;
  for (const int polarity : {-1, 1})
  {
    const auto runs = strongestRuns(steps, polarity);
    for (const int column : peakColumns(runs, static_cast<int>(std::ceil(kNeighbourhood * smoothing)), 1.F))
    {
      const RadialRun& run = runs[static_cast<std::size_t>(column)];
      const double rows = run.end - run.first;
      if (rows < settings.min_length * polar.grid.radii) continue;
      const RunProfile profile(steps, run, polarity);
      const auto peak = gaussianPeak(profile(column - spacing), profile(column), profile(column + spacing), spacing);
      if (!peak || peak->height < least_contrast) continue;
      const double significance = peak->height / profile.noise();
      const double inner = polar.grid.radiusOf(run.first), outer = polar.grid.radiusOf(run.end - 1);
      const double pixel = 1 / (0.5 * (inner + outer) * radius);  // [rad]
      const double widest = std::hypot(settings.max_width, settings.smoothing, settings.blur * pixel);
      if (significance < settings.min_significance || peak->sigma * step > widest) continue;
      if (prominence(profile, column, peak->height, static_cast<int>(kFlank * smoothing)) < settings.min_prominence)
        continue;
      RadialEdge edge;
      edge.azimuth = wrap((column + peak->offset) * step);
      edge.polarity = polarity;
      edge.contrast = peak->height;
      edge.significance = significance;
      // A neighbour makes the peak narrower than any edge is.
      edge.width = std::max(peak->sigma * step, std::hypot(settings.smoothing, settings.blur * pixel));
      edge.inner = inner;
      edge.outer = outer;
      // White noise through a Gaussian's derivative: the slope's standard deviation is sqrt(3/2)/smoothing of the
      // value's, and the peak's bend is height/sigma^2.
      const double by_noise = std::sqrt(1.5) * square(peak->sigma) / (smoothing * significance) * step;
      const double by_centre = centre_std * pixel;
      edge.std_azimuth = std::sqrt(square(by_noise) + square(by_centre) + square(settings.std_floor));
      edges.push_back(edge);
    }
  }
  moveNeighboursBack(edges);
  std::sort(edges.begin(), edges.end(), [](const RadialEdge& a, const RadialEdge& b) { return a.azimuth < b.azimuth; });
  return edges;
}
}  // namespace mrpt_ext
