#include "mrpt_ext/correspondence/bearings/triple_hypotheses.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kBatch = 65536;     // (j, k) tried before the hits are evaluated
constexpr std::uint64_t kCostOfHit = 40;  // operations, besides those for each landmark in view
constexpr double kRangeSlack = 1.02;      // a landmark at the limit is in view though the pose is a little off

TripleShape shapeOf(const ScanBearing& middle, const ScanBearing& first, const ScanBearing& second, double max_range)
{
  const auto cot = [&](const ScanBearing& r) { return static_cast<float>(1 / std::tan(r.angle - middle.angle)); };
  const auto sign = [&](const ScanBearing& r) { return std::sin(r.angle - middle.angle) > 0 ? 1.0F : -1.0F; };
  const double farthest = std::min(kRangeSlack * max_range, 1e9);
  return {cot(first), cot(second), sign(first), sign(second), static_cast<float>(square(farthest))};
}

TripleBearings bearingsOf(const ScanBearing& middle, const ScanBearing& first, const ScanBearing& second)
{
  const auto std = [](const ScanBearing& r) { return static_cast<float>(r.std); };
  return {static_cast<float>(middle.direction.x()), static_cast<float>(middle.direction.y()), std(middle), std(first),
          std(second)};
}

/// Keeps the hits inside the area.
void keepInside(const Box2& area, const Vector2d& around, TripleHits& hits)
{
  const Vector2d low = area.min - around, high = area.max - around;
  std::size_t kept = 0;
  for (std::size_t n = 0; n < hits.count; ++n)
  {
    const double x = hits.x[n], y = hits.y[n];
    hits.x[kept] = hits.x[n];
    hits.y[kept] = hits.y[n];
    hits.j[kept] = hits.j[n];
    hits.k[kept] = hits.k[n];
    kept += static_cast<std::size_t>(x >= low.x() && x <= high.x() && y >= low.y() && y <= high.y());
  }
  hits.count = kept;
}

PoseProposal proposalAt(const TriplePoses& p, std::size_t n, const Vector2d& around, int bound)
{
  PoseProposal proposal;
  proposal.sensor.mean = {around.x() + p.x[n], around.y() + p.y[n], std::atan2(p.s[n], p.c[n])};
  Matrix3d factor;
  factor << p.ix[n], p.jx[n], p.kx[n], p.iy[n], p.jy[n], p.ky[n], p.ih[n], p.jh[n], p.kh[n];
  proposal.sensor.covariance = factor * factor.transpose();
  proposal.bound = bound;
  return proposal;
}
}  // namespace

void ProposalStore::add(PoseProposal proposal)
{
  if (proposal.bound < floor_) return;
  const auto level = static_cast<std::size_t>(proposal.bound);
  if (levels_.size() <= level) levels_.resize(level + 1);
  levels_[level].push_back(std::move(proposal));
  for (++size_; size_ > capacity_; ++floor_)
  {
    std::vector<PoseProposal>& lowest = levels_[static_cast<std::size_t>(floor_)];
    size_ -= lowest.size();
    lowest.clear();
  }
}

std::vector<PoseProposal> ProposalStore::takeSorted()
{
  std::vector<PoseProposal> sorted;
  sorted.reserve(size_);
  for (std::size_t level = levels_.size(); level-- > 0;)
    std::move(levels_[level].begin(), levels_[level].end(), std::back_inserter(sorted));
  levels_.clear();
  size_ = 0;
  return sorted;
}

/// Calls visit(i, neighbours of i for the first bearing, those for the second, hits) for every batch with hits, until
/// it returns false.
template <typename Visit>
TripleHypotheses::Work TripleHypotheses::forEachScan(std::size_t stride, Visit&& visit) const
{
  const auto bearing = [this](int n) -> const ScanBearing&
  { return bearings[static_cast<std::size_t>(triple.detection[static_cast<std::size_t>(n)])]; };
  const ScanBearing &middle = bearing(0), &first = bearing(1), &second = bearing(2);
  const TripleShape shape = shapeOf(middle, first, second, max_range);
  const double all = 2 * (map->high() - map->low()).norm() + 1;
  const auto radius = [&](const ScanBearing& r)
  { return std::min(kRangeSlack * largestSeparation(wrap(r.angle - middle.angle), max_range), all); };
  const double radius_first = radius(first), radius_second = radius(second);

  Work work;
  Neighbours around_first, around_second;
  TripleHits hits;
  const std::vector<std::uint32_t>& order = scans.front().visible_sets->order();
  for (std::size_t o = 0; o < order.size() && work.finished; o += stride)
  {
    const std::uint32_t i = order[o];
    ++work.middles;
    if (!map->mayShow(middle.category, i)) continue;
    neighbours[0]->collect(map->position(i), radius_first, around_first);
    if (around_first.count == 0) continue;
    neighbours[1]->collect(map->position(i), radius_second, around_second);
    if (around_second.count == 0) continue;
    const std::size_t rows = std::max<std::size_t>(1, kBatch / around_second.padded);
    hits.reserve(std::min(rows, around_first.count) * around_second.padded + 16);
    for (std::size_t j = 0; j < around_first.count && work.finished; j += rows)
    {
      const std::size_t end = std::min(around_first.count, j + rows);
      hits.count = 0;
      scanTriples(shape, around_first, j, end, around_second, hits);
      const std::size_t tested = (end - j) * around_second.count;
      work.tested += tested;
      WorkCounter::add(2 * tested);
      work.finished = budget->spend(2 * tested);
      if (area) keepInside(*area, map->position(i), hits);
      if (hits.count == 0) continue;
      work.possible += hits.count;
      work.finished = work.finished && visit(i, around_first, around_second, hits);
    }
  }
  return work;
}

std::size_t TripleHypotheses::landmarksInView() const
{
  double count = 0;
  for (const BoundingScan& scan : scans) count += scan.visible_sets->meanCount();
  return static_cast<std::size_t>(count);
}

TripleHypotheses::Work TripleHypotheses::run(ProposalStore& store) const
{
  const auto bearing = [this](std::size_t n) -> const ScanBearing&
  { return bearings[static_cast<std::size_t>(triple.detection[n])]; };
  const TripleBearings seen = bearingsOf(bearing(0), bearing(1), bearing(2));
  const std::uint64_t cost_of_hit = kCostOfHit + 4 * landmarksInView();
  TriplePoses poses;
  std::vector<std::uint16_t> inliers;
  return forEachScan(1,
                     [&](std::uint32_t i, const Neighbours& first, const Neighbours& second, const TripleHits& hits)
                     {
                       if (!budget->spend(hits.count * cost_of_hit)) return false;
                       WorkCounter::add(hits.count * cost_of_hit);
                       posesOfHits(seen, first, second, hits, poses);
                       boundInliers(poses, map->position(i), scans, gate, store.floor(), inliers);
                       for (std::size_t n = 0; n < poses.count; ++n)
                         if (inliers[n] >= store.floor()) store.add(proposalAt(poses, n, map->position(i), inliers[n]));
                       return true;
                     });
}

TripleHypotheses::Work TripleHypotheses::sample(std::size_t stride) const
{
  return forEachScan(stride, [](auto&&...) { return true; });
}
}  // namespace mrpt_ext
