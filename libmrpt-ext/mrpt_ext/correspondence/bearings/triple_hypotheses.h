#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/bearings/inlier_bound.h"
#include "mrpt_ext/correspondence/bearings/neighbour_grid.h"
#include "mrpt_ext/correspondence/triple_schedule.h"
#include "mrpt_ext/geometry/box.h"
#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/work_budget.h"

namespace mrpt_ext
{
/// A sensor pose that matches a triple of bearings, with an upper bound on the number of its inliers.
struct PoseProposal
{
  GaussianPose sensor;
  int bound = 0;
};

/// Proposals with the highest bounds. Beyond its capacity it drops those with the lowest bounds.
class ProposalStore
{
 public:
  ProposalStore(int floor, std::size_t capacity) : floor_(floor), capacity_(capacity) {}

  [[nodiscard]] int floor() const { return floor_; }  ///< nothing with at least this bound was dropped
  void add(PoseProposal proposal);
  /// Highest bound first, otherwise in order of arrival.
  [[nodiscard]] std::vector<PoseProposal> takeSorted();

 private:
  int floor_;
  std::size_t capacity_, size_ = 0;
  std::vector<std::vector<PoseProposal>> levels_;  // by bound
};

/// Matches one triple of bearings to all triples of landmarks that can be seen together.
struct TripleHypotheses
{
  const LandmarkIndex* map = nullptr;
  std::span<const ScanBearing> bearings;
  DetectionTriple triple;
  std::array<const NeighbourGrid*, 2> neighbours{};  ///< landmarks that the outer bearings may show
  std::vector<BoundingScan> scans;                   ///< relative to the sensor of the triple
  double max_range = 0;                              ///< of the triple's scan; infinity: none
  double gate = 3.3;
  std::optional<Box2> area;  ///< of the sensor
  WorkBudget* budget = nullptr;

  struct Work
  {
    std::uint64_t tested = 0, possible = 0;
    std::size_t middles = 0;  ///< landmarks tried for the middle bearing
    bool finished = true;
  };

  /// Adds a proposal for every landmark triple that gives a possible pose, as far as the budget goes.
  Work run(ProposalStore& store) const;
  /// Tries only every `stride`-th landmark for the middle bearing, and only counts.
  [[nodiscard]] Work sample(std::size_t stride) const;

 private:
  template <typename Visit>
  Work forEachScan(std::size_t stride, Visit&& visit) const;
  /// Landmarks that the inliers of a pose are looked for among.
  [[nodiscard]] std::size_t landmarksInView() const;
};
}  // namespace mrpt_ext
