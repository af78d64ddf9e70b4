#pragma once

#include <span>

#include "mrpt_ext/correspondence/bearings/bearing_search_tables.h"
#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// Global localization from bearings to anonymous landmarks: every pose that is consistent with them, false and missed
/// detections included.
///
/// Triples of bearings are matched to all triples of landmarks that the range limit lets be seen together
/// (triple_scan.h): about N n^2 of them for N landmarks, n of them in view. The schedule of the triples
/// (triple_schedule.h) is such that no set of false bearings as large as the observed one can be part of them all. The
/// number of inliers of each possible pose is bounded from above, with gates that follow the pose's own covariance
/// (inlier_bound.h); the poses with the highest bounds are refined and verified in double precision
/// (pose_verification.h). The search ends when every pose with as many inliers as the best has been proposed, and every
/// lesser one that is frequent enough by chance to matter.
///
/// Without a range limit every three landmarks of the map can be seen together, which makes too many triples. If the
/// robot's area is known, a vote over a grid of poses takes their place: for each cell, under all headings at once, the
/// number of bearings that point to a landmark (visibility_vote.h). The estimated cost decides (search_strategy.h).
///
/// Paper 000, section 3, grows a tree over all landmarks and tests with a fixed tolerance. Here range, circular order
/// and covariance decide: the cost is linear in the size of the map and the true pose is not lost.
class BearingSearch
{
 public:
  /// The map must outlive the search.
  explicit BearingSearch(const LandmarkIndex& map) : map_(map), tables_(map) {}

  /// Scans without bearings, and ranges, only take part in the verification. Status `too_few` with fewer than three
  /// bearings, `bad_input` for numbers that are not finite or standard deviations that are not positive, `none` when no
  /// pose has four inliers (three, if there are no more bearings).
  [[nodiscard]] PoseSearchResult search(std::span<const Scan> scans, const PoseSearchOptions& options = {}) const;

  [[nodiscard]] const BearingSearchTables& tables() const { return tables_; }

 private:
  const LandmarkIndex& map_;
  BearingSearchTables tables_;
};
}  // namespace mrpt_ext
