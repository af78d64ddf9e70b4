#pragma once

#include <span>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/points/triangle_index.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// Global localization from anonymous landmarks with range and bearing.
///
/// Triangles of detected points are looked up by their sides (triangle_index.h). Each hit gives a pose, which the
/// other points confirm or reject one after the other within the gate of its own uncertainty; survivors are refined
/// and verified (pose_verification.h). Triangles are tried until no set of false points as large as the number of
/// outliers of the best pose can be part of them all (triple_schedule.h). So no pose with as many inliers as the
/// best is missed, provided the index holds the triangles: their corners are among the nearest neighbours of one
/// another. Where no triangle matches, or only two points are seen, pairs of equal distance give the poses. One
/// point leaves a ring (solvers/pose_ring.h): status `too_few`.
class PointSearch
{
 public:
  /// Builds the index. The map must outlive the search.
  explicit PointSearch(const LandmarkIndex& map) : map_(map), triangles_(map) {}

  /// Detections without range only take part in the verification. Status `bad_input` for numbers that are not
  /// finite or standard deviations that are not positive, `none` when no pose has two inliers.
  [[nodiscard]] PoseSearchResult search(std::span<const Scan> scans, const PoseSearchOptions& options = {}) const;

  [[nodiscard]] const TriangleIndex& index() const { return triangles_; }

 private:
  const LandmarkIndex& map_;
  TriangleIndex triangles_;
};
}  // namespace mrpt_ext
