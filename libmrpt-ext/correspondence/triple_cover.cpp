#include "mrpt_ext/correspondence/triple_cover.h"

#include <algorithm>
#include <limits>

namespace mrpt_ext
{
namespace
{
constexpr double kLeastSine = 0.12;       // of a gap: the cotangent stays small
constexpr std::size_t kMaxReadings = 36;  // of which triples are formed
constexpr double kOverlapCost = 1.5;      // per shared reading

bool contains(const ReadingTriple& triple, int reading)
{
  return std::find(triple.reading.begin(), triple.reading.end(), reading) != triple.reading.end();
}

bool isHit(const ReadingTriple& triple, const std::vector<int>& hit)
{
  return std::any_of(hit.begin(), hit.end(), [&](int reading) { return contains(triple, reading); });
}

bool disjoint(const ReadingTriple& a, const ReadingTriple& b)
{
  return std::none_of(a.reading.begin(), a.reading.end(), [&](int reading) { return contains(b, reading); });
}

/// Triples that `hit` misses and that are mutually disjoint: each needs a further reading.
std::size_t readingsNeeded(const std::vector<ReadingTriple>& triples, const std::vector<int>& hit)
{
  std::vector<const ReadingTriple*> packed;
  for (const ReadingTriple& t : triples)
    if (!isHit(t, hit) && std::all_of(packed.begin(), packed.end(), [&](const auto* p) { return disjoint(*p, t); }))
      packed.push_back(&t);
  return packed.size();
}

/// Extends `hit` to at most `size` readings that meet all triples.
bool extendToHittingSet(const std::vector<ReadingTriple>& triples, std::vector<int>& hit, std::size_t size)
{
  const auto open = std::find_if(triples.begin(), triples.end(), [&](const auto& t) { return !isHit(t, hit); });
  if (open == triples.end()) return true;
  if (hit.size() + readingsNeeded(triples, hit) > size) return false;
  for (const int reading : open->reading)
  {
    hit.push_back(reading);
    if (extendToHittingSet(triples, hit, size)) return true;
    hit.pop_back();
  }
  return false;
}
}  // namespace

void TripleCover::updateSmallestHit()
{
  std::size_t size = smallest_hit_.size();
  std::vector<int> hit;
  while (!extendToHittingSet(chosen_, hit, size)) ++size;
  smallest_hit_ = std::move(hit);
}

std::optional<ReadingTriple> TripleCover::next()
{
  const ReadingTriple* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const ReadingTriple& t : candidates_)
  {
    if (isHit(t, smallest_hit_)) continue;
    double cost = t.cost;
    for (const ReadingTriple& c : chosen_)
      for (const int reading : t.reading)
        if (contains(c, reading)) cost *= kOverlapCost;
    if (cost < least)
    {
      least = cost;
      best = &t;
    }
  }
  if (best == nullptr) return std::nullopt;
  chosen_.push_back(*best);
  updateSmallestHit();
  return chosen_.back();
}

double largestSeparation(double gap, double max_range)
{
  const double half = 0.5 * std::abs(gap);
  return half <= kPi / 6 ? max_range : 2 * max_range * std::sin(half);
}

namespace
{
/// Cost of trying the landmarks around those that explain `middle`, weighted with how badly the triple fixes the pose.
double tripleCost(const BearingReading& middle, const BearingReading& first, const BearingReading& second,
                  std::array<double, 3> allowed, double area, double max_range)
{
  const double gap_1 = wrap(first.bearing - middle.bearing), gap_2 = wrap(second.bearing - middle.bearing);
  const double gap_3 = wrap(second.bearing - first.bearing);
  const auto around = [&](double gap, double number)
  { return number * std::min(1.0, kPi * square(largestSeparation(gap, max_range)) / area); };
  const double tried = allowed[0] * (around(gap_1, allowed[1]) + 8) * (around(gap_2, allowed[2]) + 8);
  // Twice the area of the triangle of the three directions: what the pose's covariance is inversely proportional to.
  const double spread = std::abs(4 * std::sin(0.5 * gap_1) * std::sin(0.5 * gap_2) * std::sin(0.5 * gap_3));
  return tried * (1 + square(0.6 / std::max(spread, 1e-3)));
}
}  // namespace

std::vector<ReadingTriple> tripleCandidates(std::span<const BearingReading> readings,
                                            std::span<const double> landmarks_allowed, double area,
                                            std::span<const double> max_range)
{
  std::vector<ReadingTriple> triples;
  const int count = static_cast<int>(std::min(readings.size(), kMaxReadings));
  const auto at = [&](int i) -> const BearingReading& { return readings[static_cast<std::size_t>(i)]; };
  const auto allowed = [&](int i) { return landmarks_allowed[static_cast<std::size_t>(i)]; };
  const auto usable = [&](int i, int j)
  { return at(i).place == at(j).place && std::abs(std::sin(at(i).bearing - at(j).bearing)) > kLeastSine; };
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      for (int k = j + 1; k < count; ++k)
      {
        if (i == j || i == k || !usable(i, j) || !usable(i, k) || at(j).place != at(k).place) continue;
        const double range = max_range[static_cast<std::size_t>(at(i).place)];
        const double cost = tripleCost(at(i), at(j), at(k), {allowed(i), allowed(j), allowed(k)}, area, range);
        triples.push_back({{i, j, k}, cost});
      }
  return triples;
}
}  // namespace mrpt_ext
