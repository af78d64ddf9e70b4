#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/bearings/inlier_refinement.h"
#include "mrpt_ext/correspondence/bearings/search_strategy.h"
#include "mrpt_ext/correspondence/bearings/triple_hypotheses.h"
#include "mrpt_ext/correspondence/bearings/visibility_vote.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan_bearing.h"

namespace mrpt_ext
{
class BearingSearch;

/// Range limit of a place's sensor [m]; infinity: none.
[[nodiscard]] inline double rangeLimit(const Scan& place)
{
  return place.model.max_range.value_or(std::numeric_limits<double>::infinity());
}

/// Finds robot poses that are worth judging, from triples of readings or from panoramas, and refines them on all that
/// they explain. What it is given must outlive it.
class BearingCandidates
{
 public:
  BearingCandidates(const LandmarkIndex& map, std::span<const Scan> places, const PoseSearchOptions& options,
                    std::span<const ScanBearing> readings, const BearingSearch& owner);

  /// Proposes from all landmark triples that explain one triple of readings: poses that may explain at least `floor`
  /// readings and, refined, explain at least `least`. Returns the floor that was kept: higher than asked for when there
  /// were too many.
  int proposeFrom(const ReadingTriple& triple, int floor, int least);

  /// Refines the boxes of a scan of `place` and proposes those that explain at least `least` readings.
  void proposeFrom(std::span<const PanoramaHit> boxes, const PanoramaIndex& index, int place, int least);

  /// Estimates what a round with this triple of readings amounts to, from some landmarks.
  TripleEffort sampleEffort(const ReadingTriple& triple);

  /// Waiting to be judged, by the number of readings explained.
  [[nodiscard]] std::vector<std::vector<GaussianPose>>& waiting() { return waiting_; }
  /// Mean number of landmark triples that explain a triple of readings.
  [[nodiscard]] double meanPossible() const { return possible_ / std::max(1, rounds_); }
  [[nodiscard]] const PoseSearchResult::Work& work() const { return work_; }
  [[nodiscard]] bool finished() const { return finished_; }  ///< false: `max_tested` stopped a round
  /// Where the sensor of a place can be.
  [[nodiscard]] std::optional<Box2> areaOfSensor(int place) const;

 private:
  [[nodiscard]] TripleRound roundOf(const ReadingTriple& triple) const;
  [[nodiscard]] std::vector<BoundingScan> viewsFrom(int place, std::uint32_t used) const;
  [[nodiscard]] std::uint32_t bitsOf(int place, const ReadingTriple& triple) const;
  [[nodiscard]] bool isFixed(const GaussianPose& sensor, int place) const;
  void refine(const GaussianPose& sensor, int place, std::span<const BoundingScan> views, int least);
  void refineBox(const GaussianPose& sensor, int place, std::span<const BoundingScan> views, int least, int splits);
  void wait(const RefinedPose& tight, int place);

  const LandmarkIndex& map_;
  std::span<const Scan> places_;
  const PoseSearchOptions& options_;
  std::span<const ScanBearing> readings_;
  std::vector<ReadingTable> tables_;
  std::vector<std::shared_ptr<const PotentiallyVisibleSets>> lists_;  // none for a place without bearings
  std::vector<std::shared_ptr<const NeighbourGrid>> neighbours_;      // that a reading may show
  std::vector<std::vector<GaussianPose>> waiting_;
  GatedLandmarks scratch_;
  PoseSearchResult::Work work_;
  double possible_ = 0;
  int rounds_ = 0;
  bool finished_ = true;
};
}  // namespace mrpt_ext
