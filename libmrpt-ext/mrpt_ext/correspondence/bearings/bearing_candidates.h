#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/bearings/bearing_search_tables.h"
#include "mrpt_ext/correspondence/bearings/inlier_refinement.h"
#include "mrpt_ext/correspondence/bearings/search_strategy.h"
#include "mrpt_ext/correspondence/bearings/triple_hypotheses.h"
#include "mrpt_ext/correspondence/bearings/visibility_vote.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan_bearing.h"

namespace mrpt_ext
{
/// Range limit of a scan's sensor [m]; infinity: none.
[[nodiscard]] inline double rangeLimit(const Scan& scan)
{
  return scan.model.max_range.value_or(std::numeric_limits<double>::infinity());
}

/// Generates candidate robot poses for verification, from triples of bearings or from a vote on a grid, refined on
/// their inliers. The arguments of the constructor must outlive it; `budget` is
/// what the proposals may use.
class BearingCandidates
{
 public:
  BearingCandidates(const LandmarkIndex& map, std::span<const Scan> scans, const PoseSearchOptions& options,
                    std::span<const ScanBearing> bearings, const BearingSearchTables& tables, WorkBudget& budget);

  /// Proposes the poses of all landmark triples that match one triple of bearings: those that may have at least
  /// `floor` inliers and, refined, have at least `least`. Returns the floor that was kept: above `floor` when
  /// there were too many. What the budget does not allow is left out.
  int propose(const DetectionTriple& triple, int floor, int least);

  /// Refines the boxes voted for by the bearings of `scan` and proposes those with at least `least` inliers.
  void propose(std::span<const PoseBox> boxes, const VisibilityGrid& index, int scan, int least);

  /// Estimates the effort of a round with this triple of bearings from a sample of the landmarks.
  TripleEffort sampleEffort(const DetectionTriple& triple);

  /// Candidates not verified yet, by number of inliers.
  [[nodiscard]] std::vector<std::vector<GaussianPose>>& pending() { return pending_; }
  /// Mean number of landmark triples that match a triple of bearings.
  [[nodiscard]] double meanPossible() const { return possible_ / std::max(1, rounds_); }
  [[nodiscard]] const PoseSearchResult::Work& work() const { return work_; }
  /// Where the sensor of a scan can be.
  [[nodiscard]] std::optional<Box2> areaOfSensor(int scan) const;

 private:
  [[nodiscard]] TripleHypotheses hypothesesOf(const DetectionTriple& triple) const;
  [[nodiscard]] std::vector<BoundingScan> scansFrom(int scan, std::uint32_t used) const;
  [[nodiscard]] std::uint32_t bitsOf(int scan, const DetectionTriple& triple) const;
  [[nodiscard]] bool isFixed(const GaussianPose& sensor, int scan) const;
  void refine(const GaussianPose& sensor, int scan, std::span<const BoundingScan> scans, int least);
  void refineBox(const GaussianPose& sensor, int scan, std::span<const BoundingScan> scans, int least, int splits);
  void addPending(const RefinedPose& refined_pose, int scan);

  const LandmarkIndex& map_;
  std::span<const Scan> scans_;
  const PoseSearchOptions& options_;
  std::span<const ScanBearing> bearings_;
  WorkBudget& budget_;
  std::uint64_t cost_of_bound_ = 0;  // [operations]
  std::vector<DirectionTable> tables_;
  std::vector<std::shared_ptr<const PotentiallyVisibleSets>> visible_sets_;  // none for a scan without bearings
  std::vector<std::shared_ptr<const NeighbourGrid>> neighbours_;             // that a bearing may show
  std::vector<std::vector<GaussianPose>> pending_;
  GatedLandmarks scratch_;
  PoseSearchResult::Work work_;
  double possible_ = 0;
  int rounds_ = 0;
};
}  // namespace mrpt_ext
