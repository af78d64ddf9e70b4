#pragma once

#include <cstdint>
#include <vector>

#include "mrpt_ext/correspondence/bearings/triple_scan.h"
#include "mrpt_ext/correspondence/landmark_index.h"

namespace mrpt_ext
{
/// The landmarks of one category in square buckets, their positions side by side: a LandmarkIndex for the inner
/// loop of the triples, which needs the neighbours of a point as vectors of relative positions. Built in O(N).
class NeighbourGrid
{
 public:
  /// `category`: kAnyCategory for all landmarks.
  NeighbourGrid(const LandmarkIndex& map, int category);

  /// The landmarks within `radius` [m] of `centre`, relative to it, and padded. One exactly at the centre is left out.
  void collect(const Vector2d& centre, double radius, Neighbours& out) const;

 private:
  Vector2d low_{0, 0};
  double inverse_bucket_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_;  // per bucket, row-major; one more at the end
  std::vector<double> x_, y_;         // by bucket
};
}  // namespace mrpt_ext
