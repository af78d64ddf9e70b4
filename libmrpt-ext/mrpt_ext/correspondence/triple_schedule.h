#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/hitting_set.h"
#include "mrpt_ext/correspondence/scan_bearing.h"
#include "mrpt_ext/geometry/work_budget.h"

namespace mrpt_ext
{
/// Three detections of one scan to be matched to three landmarks. The landmarks of the other two are searched for
/// around that of `detection[0]`.
struct DetectionTriple
{
  std::array<int, 3> detection{0, 0, 0};
  double cost = 0;  ///< of trying all landmarks, relative
};

/// Chooses the triples of detections to try such that no pose is missed.
///
/// A pose with f false detections is proposed by every triple without them. If no set of f detections has a member
/// in each of the triples tried (no hitting set of that size, hitting_set.h), every pose with all but f detections as
/// inliers has been proposed. Disjoint triples are best: f + 1 of them suffice; with few detections they overlap.
class TripleSchedule
{
 public:
  /// Cheap `candidates` are tried first, those that share detections with earlier ones later. `budget` must outlive the
  /// schedule.
  TripleSchedule(std::vector<DetectionTriple> candidates, WorkBudget& budget);

  /// Number of false detections with which a pose is proposed for certain; -1 before the first triple. Where many
  /// triples overlap it is a lower bound.
  [[nodiscard]] int tolerated() const { return static_cast<int>(hit_.least) - 1; }
  /// A triple without any detection of the smallest hitting set so far. Nothing when there is none: more false
  /// detections than `tolerated` cannot be covered.
  std::optional<DetectionTriple> next();

 private:
  [[nodiscard]] std::size_t sharedBy(const DetectionTriple& triple) const;

  std::vector<DetectionTriple> candidates_;
  std::vector<std::array<int, 3>> chosen_;
  std::vector<std::size_t> uses_;  // of each detection by the triples chosen
  HittingSet hit_;
  WorkBudget& budget_;
};

/// What determines the number of constellations and poses of a triple.
struct SearchDensity
{
  std::vector<double> landmarks_allowed;  ///< of the category of each bearing
  std::vector<double> max_range;          ///< of each scan [m]; infinity: none
  double area = 1;                        ///< of the map [m^2]
  double chance = 0;  ///< that a bearing has a landmark within its gate at a wrong but exactly known pose
};

/// All triples of bearings of one scan that differ enough, with their expected cost.
[[nodiscard]] std::vector<DetectionTriple> tripleCandidates(std::span<const ScanBearing> bearings,
                                                            const SearchDensity& density);

/// Largest distance between two landmarks that are seen `gap` [rad, in (-pi, pi]] apart within `max_range`.
[[nodiscard]] double largestSeparation(double gap, double max_range);
}  // namespace mrpt_ext
