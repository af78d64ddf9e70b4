#include "mrpt_ext/vision/radial_edges.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/vision/edge_location.h"
#include "mrpt_ext/vision/edge_pair.h"
#include "mrpt_ext/vision/light_coding.h"
#include "mrpt_ext/vision/radial_peaks.h"

namespace mrpt_ext
{
namespace
{
constexpr double kClearSignificance = 2;   ///< of edges that tell the blur, in least significances
constexpr double kSharpestShare = 0.35;    ///< of them are as sharp as the camera lets them be
constexpr std::size_t kClearEdges = 4;     ///< fewer tell nothing about the camera
constexpr double kLargestBlur = 4;         ///< [px] beyond it shadows and edges look alike
constexpr double kBeside = 2.5;            ///< the levels of its sides are so many standard deviations away
constexpr double kClippedLevel = 250;      ///< [grey levels] of a side that may be brighter than the image shows
constexpr double kSamplingBlur = 0.85;     ///< [px] of the least blur is by sampling, after the camera's clipping
constexpr double kClippingUnknown = 0.58;  ///< of the shift by clipping: as if it were anything up to twice that
constexpr double kUnevenBlur = 0.015;      ///< of a larger blur, by which what is beside an edge moves it
constexpr double kPairWidth = 1.15;        ///< of a sharp edge's width; two edges make a wider peak
constexpr int kBlurRounds = 8;             ///< of bisection: to a sixtieth of a pixel

double medianBrightness(const PolarImage& polar)
{
  std::vector<float> values;
  for (int row = 0; row < polar.grey.rows; row += 4)
    for (int j = 0; j < polar.grey.cols; j += 8) values.push_back(polar.grey.at<float>(row, j));
  return upperMedian(std::move(values));
}

/// Judges the peaks of one image.
class EdgeJudge
{
 public:
  EdgeJudge(const PolarImage& polar, double radius, const RadialEdgeSettings& settings)
      : polar_(polar),
        grid_(polar.grid),
        radius_(radius),
        settings_(settings),
        least_contrast_(settings.min_contrast * medianBrightness(polar)),
        blur_(settings.blur)
  {
  }

  /// The sharpest of the clear edges show what the camera's blur is. Soft shadows are wider than they.
  void learnBlur(const std::vector<RadialPeak>& peaks)
  {
    std::vector<double> blurs;
    for (const RadialPeak& peak : peaks)
      if (isClear(peak) && peak.significance() >= kClearSignificance * settings_.min_significance)
        blurs.push_back(blurOf(peak));
    if (blurs.size() < kClearEdges) return;
    blur_ = std::clamp(*quantile(std::move(blurs), kSharpestShare), blur_, std::max(blur_, kLargestBlur));
  }
  [[nodiscard]] double blur() const { return blur_; }

  [[nodiscard]] bool isEdge(const RadialPeak& peak) const
  {
    return isClear(peak) && sigmaOf(peak) <= std::hypot(settings_.max_width, sharpest(peak));
  }

  [[nodiscard]] RadialEdge edgeAt(const RadialPeak& peak) const
  {
    const double step = grid_.azimuthStep();
    RadialEdge edge;
    edge.azimuth = wrap(peak.column * step);
    edge.polarity = peak.polarity;
    edge.contrast = edge.height = peak.height;
    edge.significance = peak.significance();
    const int beside = static_cast<int>(std::lround(kBeside * peak.sigma)), column = static_cast<int>(peak.column);
    const double before = levelAt(peak.run, column - beside), behind = levelAt(peak.run, column + beside);
    const double shift = clippedShare(peak.run, peak.polarity > 0 ? column + beside : column - beside) *
                         std::sqrt(square(blur_) - square(kSamplingBlur)) * shiftByClipping(std::min(before, behind));
    edge.coding_shift = shiftByCoding(before, behind) + shift;
    edge.std_clipping = kClippingUnknown * shift;
    edge.width = std::max(sigmaOf(peak), sharpest(peak));  // a neighbour makes the peak narrower than any edge is
    edge.inner = grid_.radiusOf(peak.run.first);
    edge.outer = grid_.radiusOf(peak.run.end - 1);
    edge.std_azimuth = columnNoise(peak, settings_.smoothing / step) * step;
    return edge;
  }
  /// Two edges that a peak is too wide for one of.
  [[nodiscard]] std::vector<RadialEdge> pairAt(const RadialPeak& peak, const AzimuthSteps& steps, int number) const
  {
    if (!isClear(peak) || sigmaOf(peak) < kPairWidth * sharpest(peak)) return {};
    const double step = grid_.azimuthStep();
    std::vector<EdgeShape::Row> rows;
    for (int row = peak.run.first; row < peak.run.end; ++row)
      rows.push_back({std::hypot(settings_.smoothing, blur_ / (radius_ * grid_.radiusOf(row))) / step,
                      1 / square(steps.noise[static_cast<std::size_t>(row)])});
    const EdgeShape shape(rows);
    const int middle = static_cast<int>(std::lround(peak.column)), reach = static_cast<int>(4 * shape.width());
    const RunProfile profile(steps, peak.run, peak.polarity, middle, reach);
    const auto pair = fitEdgePair(profile, peak.column, shape);
    if (!pair) return {};
    std::vector<RadialEdge> edges;
    for (std::size_t i = 0; i < 2; ++i)
    {
      RadialPeak one = peak;
      one.column = pair->column[i], one.height = pair->height[i], one.sigma = shape.width();
      if (one.height < least_contrast_ || one.significance() < settings_.min_significance) return {};
      RadialEdge edge = edgeAt(one);
      edge.coding_shift = 0;  // the levels on either side are those of the other edge, too
      edge.pair = number;
      edge.parts = {
          {std::sqrt(edge.inner * edge.outer), edge.azimuth, pair->std_column * step, 0, settings_.smoothing, 0}};
      edges.push_back(std::move(edge));
    }
    return edges;
  }
  /// The peak as the only part of its edge.
  [[nodiscard]] EdgePart wholeOf(const RadialPeak& peak) const
  {
    const double step = grid_.azimuthStep();
    return {std::sqrt(grid_.radiusOf(peak.run.first) * grid_.radiusOf(peak.run.end - 1)),
            wrap(peak.column * step),
            columnNoise(peak, settings_.smoothing / step) * step,
            0,
            peak.spacing * step,
            0};
  }

 private:
  /// [grey levels] mean along a run.
  [[nodiscard]] double levelAt(const RadialRun& run, int column) const
  {
    const int j = wrappedColumn(column, polar_.grey.cols);
    double sum = 0;
    for (int row = run.first; row < run.end; ++row) sum += polar_.grey.at<float>(row, j);
    return sum / (run.end - run.first);
  }
  /// Of a run's rows, those that may be brighter in a column than the image shows.
  [[nodiscard]] double clippedShare(const RadialRun& run, int column) const
  {
    const int j = wrappedColumn(column, polar_.grey.cols);
    int count = 0;
    for (int row = run.first; row < run.end; ++row) count += polar_.grey.at<float>(row, j) > kClippedLevel;
    return static_cast<double>(count) / (run.end - run.first);
  }
  [[nodiscard]] bool isClear(const RadialPeak& peak) const
  {
    return peak.height >= least_contrast_ && peak.significance() >= settings_.min_significance &&
           peak.prominence >= settings_.min_prominence;
  }
  [[nodiscard]] double sigmaOf(const RadialPeak& peak) const { return peak.sigma * grid_.azimuthStep(); }
  /// [rad] standard deviation of the profile of an edge that is sharp in the room, seen with a blur [px]. Rows near the
  /// centre are wider and lower, since a pixel covers more of a turn there: what counts is the bend of the sum.
  [[nodiscard]] double sharpWidth(const RadialPeak& peak, double blur) const
  {
    double height = 0, bend = 0;
    for (int row = peak.run.first; row < peak.run.end; ++row)
    {
      const double variance = square(settings_.smoothing) + square(blur / (radius_ * grid_.radiusOf(row)));
      height += 1 / std::sqrt(variance);
      bend += 1 / (variance * std::sqrt(variance));
    }
    return std::sqrt(height / bend);
  }
  [[nodiscard]] double sharpest(const RadialPeak& peak) const { return sharpWidth(peak, blur_); }
  /// [px] that makes a sharp edge as wide as the peak.
  [[nodiscard]] double blurOf(const RadialPeak& peak) const
  {
    double low = 0, high = kLargestBlur;
    for (int round = 0; round < kBlurRounds; ++round)
    {
      const double middle = 0.5 * (low + high);
      (sharpWidth(peak, middle) < sigmaOf(peak) ? low : high) = middle;
    }
    return low;
  }

  const PolarImage& polar_;
  const PolarGrid& grid_;
  double radius_;
  const RadialEdgeSettings& settings_;
  double least_contrast_, blur_;
};

/// Puts a pair in the place of what was taken for one edge. False when another pair is there.
bool replaceByPair(std::vector<RadialEdge>& edges, std::vector<RadialEdge> pair)
{
  const double low = pair[0].azimuth, apart = wrap(pair[1].azimuth - low), beside = pair[0].width / 2;
  const auto isAmong = [&](const RadialEdge& edge)
  {
    const double from = wrap(edge.azimuth - low);
    return edge.polarity == pair[0].polarity && from > -beside && from < apart + beside;
  };
  if (std::any_of(edges.begin(), edges.end(), [&](const RadialEdge& edge) { return edge.pair > 0 && isAmong(edge); }))
    return false;
  std::erase_if(edges, isAmong);
  for (RadialEdge& edge : pair) edges.push_back(std::move(edge));
  return true;
}
}  // namespace

std::vector<RadialEdge> findRadialEdges(const PolarImage& polar, double centre_std, double radius,
                                        const RadialEdgeSettings& settings)
{
  const AzimuthSteps steps = stepsAlongAzimuth(polar, settings.smoothing);
  std::vector<RadialPeak> peaks;
  for (const int polarity : {-1, 1})
    for (const RadialPeak& peak : findRadialPeaks(steps, polarity, settings.smoothing / polar.grid.azimuthStep(),
                                                  settings.min_length * polar.grid.radii))
      peaks.push_back(peak);
  EdgeJudge judge(polar, radius, settings);
  judge.learnBlur(peaks);
  std::vector<RadialEdge> edges;
  for (const RadialPeak& peak : peaks)
    if (judge.isEdge(peak))
    {
      edges.push_back(judge.edgeAt(peak));
      edges.back().parts = partsOf(peak, steps, polar.grid, settings.smoothing / polar.grid.azimuthStep());
      if (edges.back().parts.empty()) edges.back().parts.push_back(judge.wholeOf(peak));
    }
  int pairs = 0;
  for (const RadialPeak& peak : peaks)
    if (auto pair = judge.pairAt(peak, steps, pairs + 1); !pair.empty() && replaceByPair(edges, std::move(pair)))
      ++pairs;
  const double beyond = std::sqrt(square(judge.blur()) - square(settings.blur));
  locateByParts(edges, {settings.smoothing, judge.blur(), radius}, std::hypot(centre_std, kUnevenBlur * beyond),
                settings.std_floor);
  std::sort(edges.begin(), edges.end(), [](const RadialEdge& a, const RadialEdge& b) { return a.azimuth < b.azimuth; });
  return edges;
}
}  // namespace mrpt_ext
