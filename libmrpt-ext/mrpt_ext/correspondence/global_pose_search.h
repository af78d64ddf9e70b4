#pragma once

#include <atomic>
#include <memory>
#include <mutex>

#include "mrpt_ext/correspondence/bearings/bearing_search.h"
#include "mrpt_ext/correspondence/points/point_search.h"
#include "mrpt_ext/correspondence/search_input.h"

namespace mrpt_ext
{
/// Global localization from anonymous detections, in maps of three to hundreds of thousands of landmarks. With two
/// or more points (bearing and range) the search is one for constellations of points (point_search.h); otherwise,
/// or when it finds nothing, one for constellations of bearings (tree_search.h for small maps, else
/// bearing_search.h). Indices of the map are built when they are first needed; safe to share between threads.
class GlobalPoseSearch
{
 public:
  /// `stop` ends every search soon after it is set.
  explicit GlobalPoseSearch(const LandmarkTable& map, const std::atomic<bool>* stop = nullptr)
      : index_(map), stop_(stop)
  {
  }

  [[nodiscard]] const LandmarkIndex& index() const { return index_; }
  /// For all searches of one step of a localizer together. A search() without a budget takes as much as a single search
  /// may.
  [[nodiscard]] WorkBudget budget() const { return WorkBudget(mostStepWork(index_.size()), stop_); }
  [[nodiscard]] PoseSearchResult search(std::span<const Scan> scans, const PoseSearchOptions& options) const;

 private:
  [[nodiscard]] const PointSearch& points() const;
  [[nodiscard]] const BearingSearch& bearings() const;

  LandmarkIndex index_;
  const std::atomic<bool>* stop_;
  mutable std::once_flag points_built_, bearings_built_;
  mutable std::unique_ptr<PointSearch> points_;
  mutable std::unique_ptr<BearingSearch> bearings_;
};
}  // namespace mrpt_ext
