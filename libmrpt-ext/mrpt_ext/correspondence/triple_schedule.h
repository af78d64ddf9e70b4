#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/scan_bearing.h"

namespace mrpt_ext
{
/// Three bearings of one scan that are to be explained by three landmarks: `reading[0]` by the landmark that the other
/// two are sought around.
struct DetectionTriple
{
  std::array<int, 3> reading{0, 0, 0};
  double cost = 0;  ///< of trying all landmarks, relative
};

/// Which triples of bearings must be tried so that no pose is missed.
///
/// A pose with f false bearings explains every triple that avoids them. So if no set of f bearings meets all the
/// triples tried (no hitting set of that size), every pose that explains all but f bearings has been proposed. Disjoint
/// triples are best: f + 1 of them suffice; with few bearings they overlap.
class TripleSchedule
{
 public:
  /// `candidates` are tried cheap ones first, those that share bearings with earlier ones later.
  explicit TripleSchedule(std::vector<DetectionTriple> candidates) : candidates_(std::move(candidates)) {}

  /// So many false bearings cannot keep a pose from being proposed; -1 before the first triple.
  [[nodiscard]] int tolerated() const { return static_cast<int>(smallest_hit_.size()) - 1; }
  /// A triple that avoids the smallest set of bearings that meets all triples so far. Nothing when there is none: more
  /// false bearings than `tolerated` cannot be covered.
  std::optional<DetectionTriple> next();

 private:
  void updateSmallestHit();

  std::vector<DetectionTriple> candidates_, chosen_;
  std::vector<int> smallest_hit_;
};

/// What decides how many constellations and poses a triple has.
struct SearchDensity
{
  std::vector<double> landmarks_allowed;  ///< of the category of each reading
  std::vector<double> max_range;          ///< of each scan [m]; infinity: none
  double area = 1;                        ///< of the map [m^2]
  double chance = 0;  ///< that a reading has a landmark within its gate at a wrong, exactly known pose
};

/// All triples of one scan whose bearings differ enough, with what they are expected to cost.
[[nodiscard]] std::vector<DetectionTriple> tripleCandidates(std::span<const ScanBearing> bearings,
                                                            const SearchDensity& density);

/// Largest distance between two landmarks that are seen `gap` [rad, in (-pi, pi]] apart within `max_range`.
[[nodiscard]] double largestSeparation(double gap, double max_range);
}  // namespace mrpt_ext
