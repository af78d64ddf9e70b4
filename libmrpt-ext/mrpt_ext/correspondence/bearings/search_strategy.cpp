#include "mrpt_ext/correspondence/bearings/search_strategy.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/correspondence/bearings/visibility_vote.h"
#include "mrpt_ext/correspondence/binomial.h"

namespace mrpt_ext
{
namespace
{
// Measured, in nanoseconds.
constexpr double kCostOfTriple = 1.3;    // a landmark triple tried
constexpr double kCostOfBound = 2;       // a landmark in view of a possible pose
constexpr double kCostOfRotation = 6;    // of a ring, counting included
constexpr double kCostOfBox = 5000;      // refining what survives, several times more than by chance
constexpr double kCostOfDirection = 6;   // building: per cell and landmark
constexpr double kSearchesPerMap = 20;   // that share the building
constexpr double kMostBuilt = 5e7;       // cells x landmarks: built at once, in half a second at most
constexpr double kWorthComparing = 1e7;  // triples that cost less are not compared
/// Nanoseconds per search. `rotations_of`: rotations per bearing.
double costOf(const VisibilityGrid::Layout& layout, std::size_t landmarks, std::span<const std::size_t> rotations_of,
              int misses)
{
  const auto count = static_cast<double>(rotations_of.size());
  double rotations = 0, occupancy = 0;
  for (const std::size_t n : rotations_of)
  {
    rotations += static_cast<double>(n);
    occupancy += (1 - std::pow(1 - layout.occupancy, static_cast<double>(n))) / count;
  }
  const auto cells = static_cast<double>(layout.cells());
  const int bearings = static_cast<int>(rotations_of.size());
  const double boxes = cells * VisibilityGrid::kBins * binomialTail(bearings, bearings - misses, occupancy);
  return cells * rotations * kCostOfRotation + boxes * kCostOfBox +
         cells * static_cast<double>(landmarks) * kCostOfDirection / kSearchesPerMap;
}
}  // namespace

std::optional<VisibilityGrid::Layout> chooseVisibilityGrid(const LandmarkIndex& map, const Box2& area, double max_range,
                                                           std::span<const ScanBearing> bearings, double gate,
                                                           const TripleEffort& triples, int misses,
                                                           const VisibilityGrid::Layout* built)
{
  const bool has_categories =
      std::any_of(bearings.begin(), bearings.end(), [](const ScanBearing& r) { return r.category != kAnyCategory; });
  const bool one_scan = std::all_of(bearings.begin(), bearings.end(),
                                    [&](const ScanBearing& r) { return r.scan == bearings.front().scan; });
  double least = (kCostOfTriple * triples.tested + kCostOfBound * triples.possible * triples.in_view) * (misses + 1);
  if (has_categories || !one_scan || least < kWorthComparing) return std::nullopt;

  std::vector<std::size_t> rotations_of;
  for (const ScanBearing& r : bearings) rotations_of.push_back(ringRotations(r, gate).size());
  if (built != nullptr && costOf(*built, 0, rotations_of, misses) < least) return *built;
  std::optional<VisibilityGrid::Layout> best;
  for (const double motion : {1.0, 1.5, 2.0, 3.0, 4.0})
  {
    const auto layout = VisibilityGrid::chooseLayout(map, area, max_range, motion);
    if (!layout || static_cast<double>(layout->cells() * map.size()) > kMostBuilt) continue;
    const double cost = costOf(*layout, map.size(), rotations_of, misses);
    if (cost >= least) continue;
    least = cost;
    best = layout;
  }
  return best;
}
}  // namespace mrpt_ext
