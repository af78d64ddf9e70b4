#include "mrpt_ext/hypotheses/map_symmetries.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "mrpt_ext/correspondence/points/point_fit.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kPlaces = 40, kAllPairs = 12;  // landmarks from which motions grow; in small maps by all pairs
constexpr std::size_t kSeconds = 6;                  // landmarks of which one is the second of a pair
constexpr double kOfSpacing = 0.25, kMostTolerance = 0.25;  // [m]
constexpr double kGateOfPoint = 3;  // standard deviations, of which one is a third of the tolerance
constexpr std::size_t kPlacesOfPattern = 3, kPattern = 4 * kMostSymmetries;
constexpr std::size_t kFewestMatched = 5;  // landmarks matched; four are by chance in most maps
constexpr std::size_t kFirstLook = 8;
constexpr int kOfFirstLook = 4;      // of a pair and the nearest others
constexpr double kSamePlace = 0.01;  // [m] several landmarks on one post
constexpr int kMostFits = 10;
constexpr double kClearlyMoved = 4;  // times the tolerance

/// A landmark of the map and another one that a motion brings to its place, by index.
using Match = std::pair<std::size_t, std::size_t>;

/// Search for the symmetries of one map.
class SymmetrySearch
{
 public:
  explicit SymmetrySearch(const LandmarkTable& map)
      : map_(map),
        index_(map),
        tolerance_(toleranceOf(index_)),
        least_(static_cast<int>(std::min((map.size() + 1) / 2, std::max(kFewestMatched, (map.size() + 3) / 4)))),
        centre_((index_.low() + index_.high()) / 2)
  {
    for (const Vector2d& position : index_.positions())
      points_.push_back({position, tolerance_ / kGateOfPoint, square(tolerance_)});
  }

  std::vector<MapSymmetry> run()
  {
    RandomStream random(1);
    const std::size_t n = map_.size();
    for (std::size_t k = 0; k < std::min(n, kPlaces); ++k)
    {
      // In a regular pattern every motion is found from nearly every place.
      if (k >= kPlacesOfPattern && found_.size() >= kPattern) break;
      const std::size_t a = n <= kPlaces ? k : random.below(n);
      const std::vector<ScanPoint> others = othersByDistance(a);
      const std::size_t near = std::min(kSeconds, others.size());
      if (others.empty()) continue;
      if (n <= kAllPairs)
        for (const ScanPoint& b : others) bringElsewhere(points_[a], b, others);
      else
        bringElsewhere(points_[a], others[random.below(near)], others);
    }
    // Of those that match as many, the nearest ones.
    std::stable_sort(
        found_.begin(), found_.end(),
        [&](const MapSymmetry& a, const MapSymmetry& b)
        { return a.matched != b.matched ? a.matched > b.matched : apart(a.motion, {}) < apart(b.motion, {}); });
    if (found_.size() > kMostSymmetries) found_.resize(kMostSymmetries);
    for (MapSymmetry& symmetry : found_) symmetry.image = imageBy(symmetry.motion);
    return std::move(found_);
  }

 private:
  /// By the distance to the nearest other landmark, which half of them exceed.
  static double toleranceOf(const LandmarkIndex& index)
  {
    std::vector<double> nearest(index.size(), std::numeric_limits<double>::infinity());
    for (std::size_t a = 0; a < index.size(); ++a)
      for (std::size_t b = 0; b < index.size(); ++b)
      {
        const double distance = (index.position(a) - index.position(b)).norm();
        if (distance > kSamePlace) nearest[a] = std::min(nearest[a], distance);
      }
    return std::min(kOfSpacing * quantile(std::move(nearest), 0.5).value_or(0), kMostTolerance);
  }

  /// Half of the landmarks have a counterpart. Where the motion leads from one copy to the other, half of these are
  /// matched.
  [[nodiscard]] bool isSymmetry(const std::vector<Match>& matches) const
  {
    std::vector<bool> has_counterpart(map_.size(), false);
    for (const auto& [to, from] : matches) has_counterpart[to] = has_counterpart[from] = true;
    const auto count = std::count(has_counterpart.begin(), has_counterpart.end(), true);
    return 2 * static_cast<std::size_t>(count) >= map_.size() && static_cast<int>(matches.size()) >= least_;
  }

  /// Without those that stay nearly where they are: a motion that leaves most of the map as it is moves the rest only.
  [[nodiscard]] std::vector<Match> thoseMoved(std::vector<Match> matches) const
  {
    std::erase_if(
        matches, [&](const Match& match)
        { return (index_.position(match.first) - index_.position(match.second)).norm() < kClearlyMoved * tolerance_; });
    return matches;
  }

  /// All other landmarks but those at the same place, the nearest first.
  [[nodiscard]] std::vector<ScanPoint> othersByDistance(std::size_t from) const
  {
    const Vector2d& origin = index_.position(from);
    const auto distance = [&](const ScanPoint& point) { return (point.in_robot - origin).norm(); };
    std::vector<ScanPoint> others;
    std::copy_if(points_.begin(), points_.end(), std::back_inserter(others),
                 [&](const ScanPoint& point) { return distance(point) > 2 * tolerance_; });
    std::sort(others.begin(), others.end(),
              [&](const ScanPoint& a, const ScanPoint& b) { return distance(a) < distance(b); });
    return others;
  }

  /// `others`: all landmarks but `a`, the nearest first, so that the fit grows from where it is precise.
  void bringElsewhere(const ScanPoint& a, const ScanPoint& b, std::span<const ScanPoint> others)
  {
    const double length = (b.in_robot - a.in_robot).norm();
    for (const Vector2d& c : index_.positions())
      for (const Vector2d& d : index_.positions())
        if (std::abs((d - c).norm() - length) < 2 * tolerance_ && !(c == a.in_robot && d == b.in_robot))
          test({PointMatch{&a, c}, PointMatch{&b, d}}, others);
  }

  void test(const std::array<PointMatch, 2>& pair, std::span<const ScanPoint> others)
  {
    // The second one of the pair is among the others, and counts twice.
    const auto grown = [&](std::span<const ScanPoint> some, int least)
    { return growFit(index_, pair, some, kGateOfPoint, least + 1); };
    const int of_nearest = std::min(least_, kOfFirstLook);
    if (grown(others.first(std::min(kFirstLook, others.size())), of_nearest).inliers <= of_nearest) return;
    const GrownFit whole = grown(others, least_);
    if (whole.inliers <= least_) return;
    Pose2 motion = whole.fit.pose().mean;
    std::vector<Match> matches = matchedBy(motion);
    for (int k = 0; k < kMostFits && matches.size() >= 2; ++k)
    {
      motion = fitted(matches);
      std::vector<Match> refined = matchedBy(motion);
      if (refined == matches) break;
      matches = std::move(refined);
    }
    const std::vector<Match> moved = thoseMoved(matches);
    if (!isSymmetry(moved)) return;
    keep({motion, moved.size(), {}});
    keep({inverse(motion), moved.size(), {}});
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
    for (const auto& [to, from] : matchedBy(motion))
    {
      image[to].position.head<2>() = index_.position(from);
      image[to].stddev = map_[from].stddev;
    }
    return LandmarkTable(std::move(image));
  }

  const LandmarkTable& map_;
  LandmarkIndex index_;
  double tolerance_;
  int least_;  // landmarks matched
  Vector2d centre_;
  std::vector<ScanPoint> points_;
  std::vector<MapSymmetry> found_;
};
}  // namespace

std::vector<MapSymmetry> mapSymmetries(const LandmarkTable& map)
{
  if (map.size() < 2 || map.size() > kMostForSymmetries) return {};
  return SymmetrySearch(map).run();
}
}  // namespace mrpt_ext
