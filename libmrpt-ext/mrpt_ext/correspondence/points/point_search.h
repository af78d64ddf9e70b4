#pragma once

#include <span>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/points/triangle_index.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// Finds a lost robot from landmarks that it sees with range and bearing but cannot tell apart.
///
/// Triangles of seen points are looked up by their sides (triangle_index.h); each hit gives a pose, which the other
/// points confirm or reject one after the other within the gate of the pose's own error; survivors are refined and
/// verified (pose_verification.h). Triangles are tried until no set of false points as large as the number that the
/// best pose leaves unexplained could have spoilt them all (triple_schedule.h). So no pose that explains as many points
/// as the best is missed, provided the index holds the triangles: their corners are among the nearest neighbours of one
/// another. Where no triangle finds anything, or only two points were seen, pairs of equal distance give the poses. One
/// point leaves a ring (solvers/pose_ring.h): status `too_few`.
class PointSearch
{
 public:
  /// Builds the index. The map must outlive the search.
  explicit PointSearch(const LandmarkIndex& map) : map_(map), triangles_(map) {}

  /// Detections without range take part in the judgement only. Status `bad_input` for numbers that are not finite or
  /// deviations that are not positive, `none` when no pose explains two points.
  [[nodiscard]] PoseSearchResult search(std::span<const Scan> scans, const PoseSearchOptions& options = {}) const;

  [[nodiscard]] const TriangleIndex& index() const { return triangles_; }

 private:
  const LandmarkIndex& map_;
  TriangleIndex triangles_;
};
}  // namespace mrpt_ext
