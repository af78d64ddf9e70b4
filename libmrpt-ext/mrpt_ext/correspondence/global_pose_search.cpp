#include "mrpt_ext/correspondence/global_pose_search.h"

#include <algorithm>

#include "mrpt_ext/correspondence/scan_bearing.h"
#include "mrpt_ext/correspondence/tree/tree_search.h"

namespace mrpt_ext
{
namespace
{
/// Number of bearings of the scan with most of them.
int mostBearings(std::span<const Scan> scans)
{
  std::ptrdiff_t most = 0;
  for (const Scan& scan : scans)
    most = std::max(most, std::count_if(scan.detections.begin(), scan.detections.end(),
                                        [](const AnonymousDetection& d) { return d.bearing.has_value(); }));
  return static_cast<int>(most);
}
}  // namespace

PoseSearchResult GlobalPoseSearch::search(std::span<const Scan> scans, const PoseSearchOptions& options) const
{
  if (!areUsable(scans))
  {
    PoseSearchResult nothing;
    nothing.status = SolveStatus::bad_input;
    return nothing;
  }
  WorkBudget own(std::max(mostStepWork(index_.size()), mostSearchWork(index_.size())), stop_);
  PoseSearchOptions within = options;
  if (within.budget == nullptr) within.budget = &own;
  if (pointCount(scans) >= 2)
  {
    PoseSearchResult found = points().search(scans, within);
    if (found.status == SolveStatus::ok) return found;
  }
  if (index_.size() <= kLargestTreeMap && mostBearings(scans) <= kMostTreeBearings)
    return searchByTree(index_, scans, within);
  return bearings().search(scans, within);
}

const PointSearch& GlobalPoseSearch::points() const
{
  std::call_once(points_built_, [this] { points_ = std::make_unique<PointSearch>(index_); });
  return *points_;
}

const BearingSearch& GlobalPoseSearch::bearings() const
{
  std::call_once(bearings_built_, [this] { bearings_ = std::make_unique<BearingSearch>(index_); });
  return *bearings_;
}
}  // namespace mrpt_ext
