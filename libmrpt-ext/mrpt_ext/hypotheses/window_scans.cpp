#include "mrpt_ext/hypotheses/window_scans.h"

#include <algorithm>

#include "mrpt_ext/correspondence/local_map/local_map.h"
#include "mrpt_ext/hypotheses/informative_readings.h"
#include "mrpt_ext/hypotheses/scans.h"
#include "mrpt_ext/hypotheses/window_readings.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMergingShare = 0.5;  // of the work; the search gets the rest
}

std::vector<PastScan> pastScans(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                const LandmarkIndex& index)
{
  std::vector<PastScan> scans;
  for (const Reading& propagated : oldest_first)
  {
    const Reading reading = withoutOdometryNoise(propagated);
    for (Scan& scan : scansOf({&reading, 1}, map, index))
      scans.push_back({std::move(scan), reading.odometry_covariance});
  }
  return scans;
}

std::vector<Scan> windowScans(std::span<const Reading> oldest_first, const LandmarkTable& map,
                              const LandmarkIndex& index, WorkBudget& budget)
{
  if (!isWindow(oldest_first)) return scansOf(oldest_first, map, index);
  WorkBudget merging(budget, kMergingShare);
  return asScans(buildLocalMap(pastScans(informativeReadings(oldest_first), map, index), merging));
}
}  // namespace mrpt_ext
