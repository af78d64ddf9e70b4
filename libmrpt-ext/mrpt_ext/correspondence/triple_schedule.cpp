#include "mrpt_ext/correspondence/triple_schedule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrpt_ext
{
namespace
{
constexpr double kLeastSine = 0.12;       // of a gap: the cotangent stays small
constexpr std::size_t kMaxBearings = 36;  // of which triples are formed
constexpr double kOverlapCost = 1.5;      // per shared bearing

/// Of the exact smallest hitting set of one round; beyond, a bound takes its place. Some twenty detections in any
/// overlap stay below.
constexpr std::uint64_t kExactWork = 600'000;

bool contains(const DetectionTriple& triple, int detection)
{
  return std::find(triple.detection.begin(), triple.detection.end(), detection) != triple.detection.end();
}

bool isHit(const DetectionTriple& triple, const std::vector<int>& hit)
{
  return std::any_of(hit.begin(), hit.end(), [&](int detection) { return contains(triple, detection); });
}
}  // namespace

TripleSchedule::TripleSchedule(std::vector<DetectionTriple> candidates, WorkBudget& budget)
    : candidates_(std::move(candidates)), budget_(budget)
{
  int last = -1;
  for (const DetectionTriple& t : candidates_)
    last = std::max(last, *std::max_element(t.detection.begin(), t.detection.end()));
  uses_.assign(static_cast<std::size_t>(last) + 1, 0);
}

/// Bearings shared with the triples chosen, counted once per triple.
std::size_t TripleSchedule::sharedBy(const DetectionTriple& triple) const
{
  std::size_t shared = 0;
  for (const int detection : triple.detection) shared += uses_[static_cast<std::size_t>(detection)];
  return shared;
}

std::optional<DetectionTriple> TripleSchedule::next()
{
  if (!budget_.spend(candidates_.size() * (4 + 3 * hit_.members.size()))) return std::nullopt;
  const DetectionTriple* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const DetectionTriple& t : candidates_)
  {
    if (isHit(t, hit_.members)) continue;
    const double cost = t.cost * std::pow(kOverlapCost, static_cast<double>(sharedBy(t)));
    if (cost >= least) continue;
    least = cost;
    best = &t;
  }
  if (best == nullptr) return std::nullopt;
  chosen_.push_back(best->detection);
  for (const int detection : best->detection) ++uses_[static_cast<std::size_t>(detection)];
  WorkBudget exact(kExactWork);
  hit_ = smallestHittingSet(chosen_, hit_.least, exact);
  budget_.spend(exact.spent());
  return *best;
}

double largestSeparation(double gap, double max_range)
{
  const double half = 0.5 * std::abs(gap);
  return half <= kPi / 6 ? max_range : 2 * max_range * std::sin(half);
}

namespace
{
/// Costs in units of one constellation tried, measured with one landmark per 10 m^2 and a range limit of 8 m.
constexpr double kCostOfPose = 20, kCostOfSurvivor = 700;

/// What three bearings cost, whichever of them is the middle one.
class TripleCost
{
 public:
  TripleCost(std::span<const ScanBearing> bearings, const SearchDensity& density)
      : bearings_(bearings), density_(density), pairs_(bearings.size() * bearings.size())
  {
    const int count = static_cast<int>(bearings.size());
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j)
      {
        const double gap = std::abs(wrap(at(i).angle - at(j).angle));
        pairs_[pairIndex(i, j)] = {gap, landmarksAround(j, gap)};
      }
    for (int i = 0; i < count; ++i) in_range_.push_back(landmarksAround(i, 0));
  }

  /// The best choice of the middle one.
  [[nodiscard]] DetectionTriple operator()(int i, int j, int k) const
  {
    const double gap_ij = gap(i, j), gap_jk = gap(j, k), gap_ki = gap(k, i);
    DetectionTriple best{{i, j, k}, std::numeric_limits<double>::infinity()};
    const auto consider = [&](int middle, int first, int second)
    {
      const double tried = allowed(middle) * around(middle, first) * around(middle, second);
      if (tried < best.cost) best = {{middle, first, second}, tried};
    };
    consider(i, j, k);
    consider(j, i, k);
    consider(k, i, j);
    const double widest = std::max({gap_ij, gap_jk, gap_ki});
    const double sum = gap_ij + gap_jk + gap_ki;
    const double span = std::min(sum - widest, kTwoPi - widest);  // between the outer two, over the third
    best.cost += posesOf(i, j, k, span) * (kCostOfPose + kCostOfSurvivor * survival(span));
    return best;
  }

 private:
  /// Two bearings: the angle between them, and the landmarks that the other one may show around that of the one.
  struct Pair
  {
    double gap, around;
  };

  [[nodiscard]] std::size_t pairIndex(int i, int j) const
  {
    return static_cast<std::size_t>(i) * bearings_.size() + static_cast<std::size_t>(j);
  }
  [[nodiscard]] double gap(int i, int j) const { return pairs_[pairIndex(i, j)].gap; }
  [[nodiscard]] double around(int i, int j) const { return pairs_[pairIndex(i, j)].around; }
  [[nodiscard]] const ScanBearing& at(int i) const { return bearings_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double allowed(int i) const { return density_.landmarks_allowed[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double range(int i) const { return density_.max_range[static_cast<std::size_t>(at(i).scan)]; }

  [[nodiscard]] double landmarksAround(int i, double gap) const
  {
    return allowed(i) * std::min(1.0, kPi * square(largestSeparation(gap, range(i))) / density_.area);
  }

  [[nodiscard]] double inRange(int i) const { return in_range_[static_cast<std::size_t>(i)]; }

  /// Possible poses: measured to grow linearly with the angle that the triple spans.
  [[nodiscard]] double posesOf(int i, int j, int k, double span) const
  {
    return allowed(i) * inRange(j) * inRange(k) * (0.03 + 0.13 * span);
  }

  /// Share of the poses that two of the other bearings do not contradict. A narrow triple leaves wide gates.
  [[nodiscard]] double survival(double span) const
  {
    const double others = static_cast<double>(bearings_.size()) - 3;
    const double chance = std::min(1.0, density_.chance * (2 + 1.2 / span));
    return std::min(1.0, 0.5 * others * (others - 1) * std::pow(chance, std::max(0.0, others - 2)));
  }

  std::span<const ScanBearing> bearings_;
  const SearchDensity& density_;
  std::vector<Pair> pairs_;
  std::vector<double> in_range_;  // landmarks that a bearing may show
};
}  // namespace

std::vector<DetectionTriple> tripleCandidates(std::span<const ScanBearing> bearings, const SearchDensity& density)
{
  const TripleCost cost(bearings, density);
  const int count = static_cast<int>(std::min(bearings.size(), kMaxBearings));
  const auto usable = [&](int i, int j)
  {
    const ScanBearing &a = bearings[static_cast<std::size_t>(i)], &b = bearings[static_cast<std::size_t>(j)];
    return a.scan == b.scan &&
           std::abs(a.direction.x() * b.direction.y() - a.direction.y() * b.direction.x()) > kLeastSine;
  };
  std::vector<DetectionTriple> triples;
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
    {
      if (!usable(i, j)) continue;
      for (int k = j + 1; k < count; ++k)
        if (usable(i, k) && usable(j, k)) triples.push_back(cost(i, j, k));
    }
  return triples;
}
}  // namespace mrpt_ext
