#pragma once

#include <memory>
#include <mutex>

#include "mrpt_ext/correspondence/bearings/bearing_search.h"
#include "mrpt_ext/correspondence/points/point_search.h"

namespace mrpt_ext
{
/// Finds where a lost robot can be from detections that nobody named, in maps of three to hundreds of thousands of
/// landmarks. Chooses by what was measured: two or more points (bearing and range) are sought as constellations of
/// points (point_search.h), otherwise, or when they are found nowhere, bearings as constellations of bearings
/// (bearing_search.h). What a search needs of the map is built when it is first asked for, once; safe to share between
/// threads.
class GlobalPoseSearch
{
 public:
  explicit GlobalPoseSearch(const LandmarkTable& map) : index_(map) {}

  [[nodiscard]] const LandmarkIndex& index() const { return index_; }
  [[nodiscard]] PoseSearchResult search(std::span<const Scan> scans, const PoseSearchOptions& options) const;

 private:
  [[nodiscard]] const PointSearch& points() const;
  [[nodiscard]] const BearingSearch& bearings() const;

  LandmarkIndex index_;
  mutable std::once_flag points_built_, bearings_built_;
  mutable std::unique_ptr<PointSearch> points_;
  mutable std::unique_ptr<BearingSearch> bearings_;
};
}  // namespace mrpt_ext
