#include "mrpt_ext/correspondence/bearings/visibility_vote.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
// Operations: a rotation for all headings, and a box that is kept.
constexpr std::uint64_t kCostOfTurn = 6, kCostOfBox = 6;
constexpr int kWords = VisibilityGrid::kWords, kBins = VisibilityGrid::kBins;

/// One rotation of the ring, in the form of the kernel.
struct Rotation
{
  std::int32_t byte = 0, bit = 0;
  std::int32_t ends_bearing = 0;  ///< the last one of its bearing
};

std::vector<Rotation> rotationsOf(std::span<const ScanBearing> bearings, double gate)
{
  std::vector<Rotation> rotations;
  for (const ScanBearing& bearing : bearings)
  {
    for (const int shift : ringRotations(bearing, gate)) rotations.push_back({shift >> 3, shift & 7, 0});
    rotations.back().ends_bearing = 1;
  }
  return rotations;
}

/// Number of outliers for every heading, in bit slices: bit b of a counter has its value, where it is at most
/// seven. `within`: headings with no more of them than allowed.
struct MissCounters
{
  alignas(64) std::array<std::uint64_t, kWords> ones, twos, fours, within;
};

using Lanes [[gnu::vector_size(64)]] = std::uint64_t;
constexpr int kLanes = sizeof(Lanes) / sizeof(std::uint64_t);

/// True when some heading is within `allowed`.
MRPT_EXT_VECTOR_CLONES
bool countMisses(const std::uint64_t* ring, const Rotation* rotations, std::size_t count, int allowed,
                 MissCounters& counters)
{
  // The ring twice, so that a rotation is a read from further on; one word more for the byte beyond.
  alignas(64) std::array<unsigned char, (2 * kWords + 1) * sizeof(std::uint64_t)> twice;
  constexpr std::size_t kBytes = kWords * sizeof(std::uint64_t);
  std::memcpy(twice.data(), ring, kBytes);
  std::memcpy(twice.data() + kBytes, ring, kBytes);
  std::memcpy(twice.data() + 2 * kBytes, ring, sizeof(std::uint64_t));
  Lanes any{};
  for (int w = 0; w < kWords; w += kLanes)
  {
    Lanes ones{}, twos{}, fours{}, over{}, seen{};
    const unsigned char* from = twice.data() + static_cast<std::size_t>(w) * sizeof(std::uint64_t);
    for (std::size_t r = 0; r < count; ++r)
    {
      Lanes here, beyond;  // beyond: one byte further on, for the bits that the shift moves in
      std::memcpy(&here, from + rotations[r].byte, sizeof(Lanes));
      std::memcpy(&beyond, from + rotations[r].byte + 1, sizeof(Lanes));
      seen |= (here >> rotations[r].bit) | (beyond << (8 - rotations[r].bit));
      if (rotations[r].ends_bearing == 0) continue;
      const Lanes missed = ~seen;
      const Lanes carry_two = ones & missed, carry_four = twos & carry_two;
      over |= fours & carry_four;
      ones ^= missed;
      twos ^= carry_two;
      fours ^= carry_four;
      seen = Lanes{};
    }
    std::memcpy(&counters.ones[static_cast<std::size_t>(w)], &ones, sizeof(Lanes));
    std::memcpy(&counters.twos[static_cast<std::size_t>(w)], &twos, sizeof(Lanes));
    std::memcpy(&counters.fours[static_cast<std::size_t>(w)], &fours, sizeof(Lanes));
    Lanes below{}, equal = ~over;  // counters that are below what is allowed, and equal to it, digit by digit
    const auto compare = [&](const Lanes& counter, int digit)
    {
      if ((allowed & digit) != 0) below |= equal & ~counter;
      equal &= (allowed & digit) != 0 ? counter : ~counter;
    };
    compare(fours, 4);
    compare(twos, 2);
    compare(ones, 1);
    const Lanes within = below | equal;
    std::memcpy(&counters.within[static_cast<std::size_t>(w)], &within, sizeof(Lanes));
    any |= within;
  }
  std::uint64_t found = 0;
  for (int l = 0; l < kLanes; ++l) found |= any[l];
  return found != 0;
}

int missesOf(const MissCounters& count, std::size_t w, int bit)
{
  const auto digit = [&](const auto& counter) { return static_cast<int>(counter[w] >> bit & 1U); };
  return digit(count.ones) + 2 * digit(count.twos) + 4 * digit(count.fours);
}
}  // namespace

std::vector<int> ringRotations(const ScanBearing& bearing, double gate)
{
  const double low = (bearing.angle - gate * bearing.std) / VisibilityGrid::kBinWidth;
  const double high = (bearing.angle + gate * bearing.std) / VisibilityGrid::kBinWidth + 1;  // headings fill a bin
  std::vector<int> shifts;
  for (double q = std::floor(low); shifts.empty() || q <= high; q += VisibilityGrid::kReach)
    shifts.push_back(static_cast<int>(q + 4.0 * kBins) & (kBins - 1));
  return shifts;
}

PoseBoxes voteForPoses(const VisibilityGrid& index, std::span<const ScanBearing> bearings, double gate, int floor,
                       std::size_t capacity, WorkBudget& budget)
{
  const int usable = static_cast<int>(bearings.size());
  PoseBoxes hits;
  hits.floor = std::max(floor, usable - kMostOutliers);
  hits.by_inliers.resize(static_cast<std::size_t>(usable) + 1);
  const std::vector<Rotation> rotations = rotationsOf(bearings, gate);
  MissCounters count;
  std::size_t held = 0;
  const std::uint64_t cost_of_cell = kCostOfTurn * rotations.size();
  for (std::size_t cell = 0; cell < index.layout().cells(); ++cell)
  {
    hits.finished = budget.spend(cost_of_cell);
    if (!hits.finished) break;
    WorkCounter::add(cost_of_cell);
    // Landmarks in or close to the cell are not in its ring: each may match one bearing more.
    const int close = index.closeLandmarks(cell);
    const int allowed = std::min(usable - hits.floor + close, kMostOutliers);
    if (!countMisses(index.ring(cell), rotations.data(), rotations.size(), allowed, count)) continue;
    const std::size_t before = held;
    for (std::size_t w = 0; w < kWords; ++w)
      for (std::uint64_t left = count.within[w]; left != 0; left &= left - 1)
      {
        const int bit = std::countr_zero(left);
        const int inliers = std::min(usable, usable - missesOf(count, w, bit) + close);
        hits.by_inliers[static_cast<std::size_t>(inliers)].push_back(
            {static_cast<std::uint32_t>(cell), static_cast<std::uint16_t>(64 * w + static_cast<std::size_t>(bit)),
             static_cast<std::uint16_t>(inliers)});
        ++held;
      }
    WorkCounter::add(kCostOfBox * (held - before));
    budget.spend(kCostOfBox * (held - before));
    for (; held > capacity && hits.floor < usable; ++hits.floor)
    {
      auto& lowest = hits.by_inliers[static_cast<std::size_t>(hits.floor)];
      held -= lowest.size();
      lowest = {};
    }
  }
  return hits;
}

GaussianPose poseOf(const PoseBox& hit, const VisibilityGrid& index, double gate)
{
  const Vector2d centre = index.centre(hit.cell);
  GaussianPose pose;
  pose.mean = {centre.x(), centre.y(), wrap((hit.heading + 0.5) * VisibilityGrid::kBinWidth)};
  // Position and heading may both be at the rim of the box: their shares of a direction add up, not their squares.
  const double side = std::sqrt(2.0) * index.cellRadius() / gate;
  const double turn = std::sqrt(2.0) * 0.5 * VisibilityGrid::kBinWidth / gate;
  pose.covariance = Vector3d(side * side, side * side, turn * turn).asDiagonal();
  return pose;
}
}  // namespace mrpt_ext
