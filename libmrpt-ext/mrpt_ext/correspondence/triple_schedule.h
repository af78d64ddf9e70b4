#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/scan_bearing.h"

namespace mrpt_ext
{
/// Three bearings of one place that are to be explained by three landmarks: `reading[0]` by the landmark that the other
/// two are sought around.
struct ReadingTriple
{
  std::array<int, 3> reading{0, 0, 0};
  double cost = 0;  ///< of trying all landmarks, relative
};

/// Which triples of readings must be tried so that no pose is missed.
///
/// A pose with f false readings explains every triple that avoids them. So if no set of f readings meets all the
/// triples tried (no hitting set of that size), every pose that explains all but f readings has been proposed. Disjoint
/// triples are best: f + 1 of them suffice; with few readings they overlap.
class TripleSchedule
{
 public:
  /// `candidates` are tried cheap ones first, those that share readings with earlier ones later.
  explicit TripleSchedule(std::vector<ReadingTriple> candidates) : candidates_(std::move(candidates)) {}

  /// So many false readings cannot keep a pose from being proposed; -1 before the first triple.
  [[nodiscard]] int tolerated() const { return static_cast<int>(smallest_hit_.size()) - 1; }
  /// A triple that avoids the smallest set of readings that meets all triples so far. Nothing when there is none: more
  /// false readings than `tolerated` cannot be covered.
  std::optional<ReadingTriple> next();

 private:
  void updateSmallestHit();

  std::vector<ReadingTriple> candidates_, chosen_;
  std::vector<int> smallest_hit_;
};

/// What decides how many constellations and poses a triple has.
struct SearchDensity
{
  std::vector<double> landmarks_allowed;  ///< of the kind of each reading
  std::vector<double> max_range;          ///< of each place [m]; infinity: none
  double area = 1;                        ///< of the map [m^2]
  double chance = 0;  ///< that a reading has a landmark within its gate at a wrong, exactly known pose
};

/// All triples of one place whose bearings differ enough, with what they are expected to cost.
[[nodiscard]] std::vector<ReadingTriple> tripleCandidates(std::span<const ScanBearing> readings,
                                                          const SearchDensity& density);

/// Largest distance between two landmarks that are seen `gap` [rad, in (-pi, pi]] apart within `max_range`.
[[nodiscard]] double largestSeparation(double gap, double max_range);
}  // namespace mrpt_ext
