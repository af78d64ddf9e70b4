#include "mrpt_ext/vision/edge_parts.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr int kParts = 6;
constexpr int kPartRows = 6;             ///< of a part
constexpr double kPartSignificance = 5;  ///< of a part
constexpr double kPartReach = 1.5;       ///< a part's peak is that near the edge's, in widths of the edge

/// The columns about a middle one, among which a peak is sought.
struct Search
{
  int centre = 0, reach = 0, spacing = 0;
};

/// The highest peak.
struct FoundPeak
{
  double column = 0, height = 0;
  SampledPeak shape;
};

/// Nothing where the profile is highest at the end of the search.
std::optional<FoundPeak> highestPeak(const RunProfile& profile, const Search& search)
{
  int highest = search.centre;
  for (int column = search.centre - search.reach; column <= search.centre + search.reach; ++column)
    if (profile(column) > profile(highest)) highest = column;
  if (std::abs(highest - search.centre) == search.reach) return std::nullopt;
  const auto sampled = sampledPeak(profile, highest, search.spacing);
  if (!sampled) return std::nullopt;
  return FoundPeak{highest + sampled->offset, profile(highest), *sampled};
}
}  // namespace

std::vector<EdgePart> partsOf(const RadialPeak& peak, const AzimuthSteps& steps, const PolarGrid& grid,
                              double smoothing)
{
  const int rows = peak.run.end - peak.run.first, count = std::clamp(rows / kPartRows, 1, kParts);
  const Search search{static_cast<int>(std::lround(peak.column)),
                      std::max(1, static_cast<int>(std::lround(kPartReach * peak.sigma))),
                      std::max(1, static_cast<int>(std::lround(smoothing)))};
  const double more = smoothing * std::sqrt(square(kMoreSmoothing) - 1);
  const int reach = search.reach + reachOfSamples(search.spacing) + RunProfile::reachOf(more);
  std::vector<EdgePart> parts;
  for (int i = 0; i < count; ++i)
  {
    RadialRun run = peak.run;
    run.first = peak.run.first + rows * i / count;
    run.end = peak.run.first + rows * (i + 1) / count;
    const RunProfile profile(steps, run, peak.polarity, search.centre, reach);
    const auto found = highestPeak(profile, search);
    if (!found) continue;
    RadialPeak part = peak;
    part.sigma = found->shape.sigma;
    part.spacing = found->shape.spacing;
    part.height = found->height;
    part.noise = profile.noise();
    if (part.significance() < kPartSignificance) continue;
    const auto softer = highestPeak(profile.smoothed(more), search);
    const double step = grid.azimuthStep();
    parts.push_back({grid.radiusOf(0.5 * (run.first + run.end - 1)), wrap(found->column * step),
                     columnNoise(part, smoothing) * step, softer ? (softer->column - found->column) * step : 0,
                     found->shape.spacing * step, softer ? softer->shape.spacing * step : 0});
  }
  return parts;
}
}  // namespace mrpt_ext
