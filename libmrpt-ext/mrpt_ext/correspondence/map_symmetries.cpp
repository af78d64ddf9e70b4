#include "mrpt_ext/correspondence/map_symmetries.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mrpt_ext/correspondence/points/point_fit.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kPairs = 40;
constexpr double kOfSpacing = 0.125, kMostTolerance = 0.25;  // [m]
constexpr double kGateOfPoint = 3;  // standard deviations, of which one is a third of the tolerance
constexpr std::size_t kFirstLook = 16, kOfFirstLook = 6;  // landmarks, and how many of these must be matched
constexpr int kMostFits = 10;

/// A landmark of the map and another one that a motion brings to its place, by index.
using Match = std::pair<std::size_t, std::size_t>;

/// Search for the symmetries of one map.
class SymmetrySearch
{
 public:
  explicit SymmetrySearch(const LandmarkTable& map)
      : map_(map),
        index_(positionsOf(map)),
        tolerance_(toleranceOf(index_)),
        centre_((index_.low() + index_.high()) / 2)
  {
    for (const Vector2d& position : index_.positions())
      points_.push_back({position, tolerance_ / kGateOfPoint, square(tolerance_)});
  }

  std::vector<MapSymmetry> run()
  {
    RandomStream random(1);
    const std::size_t n = map_.size();
    if (n * (n - 1) / 2 <= kPairs)
      for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = a + 1; b < n; ++b) bringElsewhere(a, b);
    else
      for (std::size_t k = 0; k < kPairs; ++k)
      {
        const std::size_t a = random.below(n), b = random.below(n - 1);
        bringElsewhere(a, b < a ? b : b + 1);
      }
    std::stable_sort(found_.begin(), found_.end(), [](const auto& a, const auto& b) { return a.matched > b.matched; });
    if (found_.size() > kMostSymmetries) found_.resize(kMostSymmetries);
    for (MapSymmetry& symmetry : found_) symmetry.image = imageBy(symmetry.motion);
    return std::move(found_);
  }

 private:
  static std::vector<Vector2d> positionsOf(const LandmarkTable& map)
  {
    std::vector<Vector2d> positions;
    for (const Landmark& landmark : map.all()) positions.emplace_back(landmark.position.head<2>());
    return positions;
  }

  static double toleranceOf(const LandmarkIndex& index)
  {
    const Vector2d extent = index.high() - index.low();
    const auto n = static_cast<double>(index.size());
    // A row of landmarks has no area, but it has a spacing.
    const double spacing = std::max(std::sqrt(extent.prod() / n), extent.norm() / n);
    return std::min(kOfSpacing * spacing, kMostTolerance);
  }

  void bringElsewhere(std::size_t a, std::size_t b)
  {
    const double length = (index_.position(b) - index_.position(a)).norm();
    if (!(length > 2 * tolerance_)) return;  // tells no direction
    for (std::size_t c = 0; c < map_.size(); ++c)
      for (std::size_t d = 0; d < map_.size(); ++d)
      {
        const bool same = c == d || (c == a && d == b);
        if (same || std::abs((index_.position(d) - index_.position(c)).norm() - length) > 2 * tolerance_) continue;
        test({PointMatch{&points_[a], index_.position(c)}, PointMatch{&points_[b], index_.position(d)}});
      }
  }

  void test(const std::array<PointMatch, 2>& pair)
  {
    if (map_.size() > 2 * kFirstLook)
    {
      const std::span<const ScanPoint> some = firstLook();
      if (growFit(index_, pair, some, kGateOfPoint, kOfFirstLook).inliers < static_cast<int>(kOfFirstLook)) return;
    }
    const auto least = static_cast<int>(std::max<std::size_t>(2, (map_.size() + 1) / 2));
    // The pair is among all points, and counts twice.
    const GrownFit grown = growFit(index_, pair, points_, kGateOfPoint, least);
    if (grown.inliers < least) return;
    Pose2 motion = grown.fit.pose().mean;
    std::vector<Match> matches = matchedBy(motion);
    for (int k = 0; k < kMostFits && matches.size() >= 2; ++k)
    {
      motion = fitted(matches);
      std::vector<Match> refined = matchedBy(motion);
      if (refined == matches) break;
      matches = std::move(refined);
    }
    // A motion that leaves most landmarks where they are moves the others only.
    const auto moved = static_cast<std::size_t>(
        std::count_if(matches.begin(), matches.end(), [](const Match& match) { return match.first != match.second; }));
    if (static_cast<int>(moved) >= least) keep({motion, moved, {}});
  }

  /// Every n-th landmark.
  std::span<const ScanPoint> firstLook()
  {
    if (some_.empty())
      for (std::size_t k = 0; k < kFirstLook; ++k) some_.push_back(points_[k * points_.size() / kFirstLook]);
    return some_;
  }

  /// One to one: the nearest landmark of which none is nearer.
  [[nodiscard]] std::vector<Match> matchedBy(const Pose2& motion) const
  {
    const Pose2 back = inverse(motion);
    std::vector<Match> matches;
    for (std::size_t k = 0; k < map_.size(); ++k)
      if (const auto to = nearest(transform(motion, index_.position(k))))
        if (nearest(transform(back, index_.position(*to))) == k) matches.emplace_back(*to, k);
    return matches;
  }

  /// The landmark within the tolerance of `place`.
  [[nodiscard]] std::optional<std::size_t> nearest(const Vector2d& place) const
  {
    double least = tolerance_;
    std::optional<std::size_t> result;
    index_.forEachNear(place, tolerance_,
                       [&](std::size_t landmark)
                       {
                         const double distance = (index_.position(landmark) - place).norm();
                         if (distance > least) return;
                         least = distance;
                         result = landmark;
                       });
    return result;
  }

  [[nodiscard]] Pose2 fitted(const std::vector<Match>& matches) const
  {
    std::vector<PointMatch> points;
    for (const auto& [to, from] : matches) points.push_back({&points_[from], index_.position(to)});
    return fitPoints(points).pose().mean;
  }

  /// The farthest that the two motions bring a landmark apart.
  [[nodiscard]] double apart(const Pose2& a, const Pose2& b) const
  {
    const double reach = (index_.high() - centre_).norm();
    return (transform(a, centre_) - transform(b, centre_)).norm() + 2 * reach * std::abs(std::sin((a.phi - b.phi) / 2));
  }

  void keep(MapSymmetry symmetry)
  {
    if (apart(symmetry.motion, {}) < 2 * tolerance_) return;
    const auto known =
        std::find_if(found_.begin(), found_.end(),
                     [&](const MapSymmetry& other) { return apart(symmetry.motion, other.motion) < 2 * tolerance_; });
    if (known == found_.end())
      found_.push_back(std::move(symmetry));
    else if (known->matched < symmetry.matched)
      *known = std::move(symmetry);
  }

  [[nodiscard]] LandmarkTable imageBy(const Pose2& motion) const
  {
    const Pose2 back = inverse(motion);
    std::vector<Landmark> image = map_.all();
    for (Landmark& landmark : image) landmark.position.head<2>() = transform(back, landmark.position.head<2>());
    for (const auto& [to, from] : matchedBy(motion)) image[to].position.head<2>() = index_.position(from);
    return LandmarkTable(std::move(image));
  }

  const LandmarkTable& map_;
  LandmarkIndex index_;
  double tolerance_;
  Vector2d centre_;
  std::vector<ScanPoint> points_, some_;
  std::vector<MapSymmetry> found_;
};
}  // namespace

std::vector<MapSymmetry> mapSymmetries(const LandmarkTable& map)
{
  if (map.size() < 2 || map.size() > kMostForSymmetries) return {};
  return SymmetrySearch(map).run();
}
}  // namespace mrpt_ext
