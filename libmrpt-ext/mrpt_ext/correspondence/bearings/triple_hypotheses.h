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

namespace mrpt_ext
{
/// A sensor pose that explains a triple of bearings and, by the sieve, at most `bound` bearings altogether.
struct PoseProposal
{
  GaussianPose sensor;
  int bound = 0;
};

/// Proposals with the highest bounds. When it holds more than its capacity it gives up the lowest bounds.
class ProposalStore
{
 public:
  ProposalStore(int floor, std::size_t capacity) : floor_(floor), capacity_(capacity) {}

  [[nodiscard]] int floor() const { return floor_; }  ///< nothing with at least this bound was given up
  void add(PoseProposal proposal);
  /// Highest bound first, otherwise in the order of arrival.
  [[nodiscard]] std::vector<PoseProposal> takeSorted();

 private:
  int floor_;
  std::size_t capacity_, size_ = 0;
  std::vector<std::vector<PoseProposal>> levels_;  // by bound
};

/// One triple of bearings against all landmarks.
struct TripleHypotheses
{
  const LandmarkIndex* map = nullptr;
  std::span<const ScanBearing> bearings;
  DetectionTriple triple;
  std::array<const NeighbourGrid*, 2> neighbours{};  ///< landmarks that the outer bearings may show
  std::vector<BoundingScan> scans;                   ///< of all scans, relative to the triple's sensor
  double max_range = 0;                              ///< of the triple's scan; infinity: none
  double gate = 3.3;
  std::optional<Box2> area;  ///< of the sensor
  std::uint64_t max_tested = 0;

  struct Work
  {
    std::uint64_t tested = 0, possible = 0;
    bool finished = true;
  };

  /// Adds a proposal for every constellation of three landmarks that gives a possible pose.
  Work run(ProposalStore& store) const;
  /// Tries only every `stride`-th landmark for the middle reading, and only counts.
  [[nodiscard]] Work sample(std::size_t stride) const;

 private:
  template <typename Visit>
  Work forEachScan(std::size_t stride, Visit&& visit) const;
};
}  // namespace mrpt_ext
