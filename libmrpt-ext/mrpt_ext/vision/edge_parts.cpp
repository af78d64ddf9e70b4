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
}  // namespace

std::vector<EdgePart> partsOf(const RadialPeak& peak, const AzimuthSteps& steps, const PolarGrid& grid,
                              double smoothing)
{
  const int rows = peak.run.end - peak.run.first, count = std::clamp(rows / kPartRows, 1, kParts);
  const int centre = static_cast<int>(std::lround(peak.column));
  const int reach = std::max(1, static_cast<int>(std::lround(kPartReach * peak.sigma)));
  std::vector<EdgePart> parts;
  for (int i = 0; i < count; ++i)
  {
    RadialRun run = peak.run;
    run.first = peak.run.first + rows * i / count;
    run.end = peak.run.first + rows * (i + 1) / count;
    const RunProfile profile(steps, run, peak.polarity);
    int highest = centre;
    for (int column = centre - reach; column <= centre + reach; ++column)
      if (profile(column) > profile(highest)) highest = column;
    const auto sampled = sampledPeak(profile, highest, std::max(1, static_cast<int>(std::lround(smoothing))));
    if (!sampled || std::abs(highest - centre) == reach) continue;
    RadialPeak part = peak;
    part.sigma = sampled->sigma;
    part.spacing = sampled->spacing;
    part.height = profile(highest);
    part.noise = profile.noise();
    if (part.significance() < kPartSignificance) continue;
    parts.push_back({grid.radiusOf(0.5 * (run.first + run.end - 1)),
                     wrap((highest + sampled->offset) * grid.azimuthStep()),
                     columnNoise(part, smoothing) * grid.azimuthStep()});
  }
  return parts;
}
}  // namespace mrpt_ext
