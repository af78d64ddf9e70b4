#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/bearings/neighbour_grid.h"
#include "mrpt_ext/correspondence/bearings/potentially_visible_sets.h"
#include "mrpt_ext/correspondence/bearings/visibility_grid.h"
#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// Finds a lost robot from bearings to landmarks that it cannot tell apart: every pose that explains the readings, with
/// false and missed ones allowed.
///
/// Triples of readings, chosen so that no number of false readings up to the one observed can spoil them all
/// (triple_schedule.h), are tried against all constellations of three landmarks that a range limit lets be seen
/// together (triple_scan.h): about N n^2 of them for n landmarks in view. Each possible pose is bounded by the number
/// of readings that could have a landmark within the gate of its own uncertainty (inlier_bound.h); those with the
/// highest bounds are refined and judged in double precision (pose_verification.h). The search ends when every pose
/// that explains as much as the best, and every lesser one that chance makes frequent enough to matter, has been
/// proposed.
///
/// Where nothing limits the range, every three landmarks of the map can be seen together and there are too many
/// triples. Then, if it is known in which area the robot is, its positions are counted off instead: cell by cell, under
/// all headings at once, how many readings have a landmark where they point to (visibility_vote.h). The estimated cost
/// decides.
///
/// Paper 000, section 3, grows a tree over all landmarks and tests with a fixed tolerance; here range, order and the
/// pose's own covariance decide, so that the cost is linear in the size of the map and the truth is not lost.
class BearingSearch
{
 public:
  /// The map must outlive the search.
  explicit BearingSearch(const LandmarkIndex& map) : map_(map) {}

  /// Places without bearings, and ranges, take part in the judgement only. Status `too_few` with fewer than three
  /// bearings, `bad_input` for numbers that are not finite or deviations that are not positive, `none` when no pose
  /// explains four readings (three, if there are no more).
  [[nodiscard]] PoseSearchResult search(std::span<const Scan> places, const PoseSearchOptions& options = {}) const;

  /// Prepares the tables for this range limit [m] (infinity: none); otherwise the first search does.
  [[nodiscard]] std::shared_ptr<const PotentiallyVisibleSets> listsFor(double max_range) const;
  /// The landmarks of a kind, as triples look for them.
  [[nodiscard]] std::shared_ptr<const NeighbourGrid> neighboursOf(int kind) const;
  /// The same for panoramas.
  [[nodiscard]] std::shared_ptr<const PanoramaIndex> panoramasFor(const PanoramaIndex::Plan& plan) const;
  /// Those that exist for this area and range limit; nothing when there are none.
  [[nodiscard]] std::shared_ptr<const PanoramaIndex> builtPanoramas(const Box2& area, double max_range) const;

 private:
  const LandmarkIndex& map_;
  mutable std::mutex mutex_;
  mutable std::vector<std::shared_ptr<const PotentiallyVisibleSets>> lists_;
  mutable std::map<int, std::shared_ptr<const NeighbourGrid>> neighbours_;  // by kind
  mutable std::vector<std::shared_ptr<const PanoramaIndex>> panoramas_;
};
}  // namespace mrpt_ext
