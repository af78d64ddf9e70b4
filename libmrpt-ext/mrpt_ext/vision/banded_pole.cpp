#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/field_objects.h"

namespace mrpt_ext
{
namespace
{
constexpr double kDistanceStep = 1.05;  ///< ratio of neighbouring distances that are tried
constexpr double kHeadroom = 1.15;      ///< share of the pole's height where its top colour must have ended
constexpr int kMinBandRows = 2;         ///< fewer rows of a band do not count

/// Rows of the panorama that a distance gives to the bands: the first rows of headroom, top, middle, bottom, floor.
struct BandRows
{
  double distance = 0;
  std::array<int, 5> first{};
};

std::vector<BandRows> bandRows(const MirrorPanorama& panorama, const HyperbolicMirror& mirror, double height,
                               const FieldObjectSearch& search)
{
  std::vector<BandRows> all;
  for (double d = search.min_distance; d <= search.max_distance; d *= kDistanceStep)
  {
    BandRows rows{d, {}};
    constexpr std::array<double, 5> kHeights{kHeadroom, 1, 2.0 / 3, 1.0 / 3, 0};
    for (std::size_t i = 0; i < kHeights.size(); ++i)
      rows.first[i] = panorama.rowAt(mirror.slopeOf(kHeights[i] * height, d));
    all.push_back(rows);
  }
  return all;
}

/// How many pixels of the two colours a column has above each row.
struct ColumnCounts
{
  const ColourCounts &ends, &middle;
  int column = 0;

  [[nodiscard]] bool showBands() const
  {
    return ends(ends.rows - 1, column) >= kMinBandRows && middle(middle.rows - 1, column) >= kMinBandRows;
  }
  /// Share of the pixels in rows [first, end) that have a colour; nothing when there are too few rows.
  [[nodiscard]] std::optional<double> share(const ColourCounts& colour, int first, int end) const
  {
    if (end - first < kMinBandRows) return std::nullopt;
    return static_cast<double>(colour(end, column) - colour(first, column)) / (end - first);
  }
};

/// How well a column shows the bands: mean share of the bands in their colours less what of the top colour is above
/// the top; 0 when the middle and one of the others do not show.
double bandScore(const ColumnCounts& counts, const BandRows& rows, double band_share)
{
  const auto middle = counts.share(counts.middle, rows.first[2], rows.first[3]);
  if (!middle || *middle < band_share) return 0;
  const auto top = counts.share(counts.ends, rows.first[1], rows.first[2]);
  const auto bottom = counts.share(counts.ends, rows.first[3], rows.first[4]);
  if (std::max(top.value_or(0), bottom.value_or(0)) < band_share) return 0;
  const double seen = (*middle + top.value_or(0) + bottom.value_or(0)) / 3;
  return seen - 0.5 * counts.share(counts.ends, rows.first[0], rows.first[1]).value_or(0);
}

/// Neighbouring columns that show a pole.
struct PoleRun
{
  int first = 0, last = 0;
  double sum = 0;  ///< of the scores
  double best = 0, distance = 0;
};

struct ColumnScore
{
  double score = 0, distance = 0;
};

std::vector<ColumnScore> scoreColumns(const ColourCounts& ends, const ColourCounts& middle,
                                      const std::vector<BandRows>& all, double band_share)
{
  std::vector<ColumnScore> scores(static_cast<std::size_t>(ends.cols));
  for (int column = 0; column < ends.cols; ++column)
  {
    const ColumnCounts counts{ends, middle, column};
    if (!counts.showBands()) continue;
    ColumnScore& best = scores[static_cast<std::size_t>(column)];
    for (const BandRows& rows : all)
      if (const double score = bandScore(counts, rows, band_share); score > best.score) best = {score, rows.distance};
  }
  return scores;
}

/// Runs of columns with a score, across the seam of the panorama; one missing column does not end a run.
std::vector<PoleRun> runsOf(const std::vector<ColumnScore>& scores)
{
  const int columns = static_cast<int>(scores.size());
  const auto at = [&](int column) { return scores[static_cast<std::size_t>(column % columns)]; };
  int begin = 0;  // behind a gap, so that no run crosses the end
  while (begin < columns && (at(begin).score > 0 || at(begin + 1).score > 0)) ++begin;
  std::vector<PoleRun> runs;
  for (int column = begin; column < begin + columns; ++column)
  {
    const ColumnScore score = at(column);
    if (score.score <= 0) continue;
    if (runs.empty() || column - runs.back().last > 2) runs.push_back({column, column, 0, 0, 0});
    PoleRun& run = runs.back();
    run.last = column;
    run.sum += score.score;
    if (score.score > run.best)
    {
      run.best = score.score;
      run.distance = score.distance;
    }
  }
  return runs;
}
}  // namespace

double poleHalfWidth(const FieldObjectSizes& sizes, double distance)
{
  return std::asin(std::min(1.0, sizes.pole_radius / distance));
}

ColourCounts countColour(const cv::Mat1b& colours, ObjectColour colour)
{
  ColourCounts counts(colours.rows + 1, colours.cols);
  counts.row(0).setTo(0);
  for (int row = 0; row < colours.rows; ++row)
    std::transform(colours[row], colours[row] + colours.cols, counts[row], counts[row + 1],
                   [colour](unsigned char pixel, short above)
                   { return static_cast<short>(above + (pixel == static_cast<unsigned char>(colour) ? 1 : 0)); });
  return counts;
}

std::optional<ObjectGuess> findBandedPole(const ColourCounts& ends, const ColourCounts& middle,
                                          const MirrorPanorama& panorama, const HyperbolicMirror& mirror,
                                          const FieldObjectSizes& sizes, const FieldObjectSearch& search)
{
  const auto all = bandRows(panorama, mirror, sizes.pole_height, search);
  std::optional<ObjectGuess> found;
  double best = 0;
  for (const PoleRun& run : runsOf(scoreColumns(ends, middle, all, search.band_share)))
  {
    const double half_width = poleHalfWidth(sizes, run.distance);
    const double columns = 2 * half_width * panorama.columns() / kTwoPi;
    // The classified width is good to a column on either side.
    const double width = run.last - run.first + 1;
    if (width < (1 - search.width_tolerance) * columns - 2 || width > (1 + search.width_tolerance) * columns + 2)
      continue;
    if (run.sum / columns <= best) continue;
    best = run.sum / columns;
    found = ObjectGuess{panorama.azimuth(0.5 * (run.first + run.last)), half_width, run.distance};
  }
  return found;
}
}  // namespace mrpt_ext
