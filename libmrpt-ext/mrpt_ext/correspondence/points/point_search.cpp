#include "mrpt_ext/correspondence/points/point_search.h"

#include <algorithm>
#include <limits>

#include "mrpt_ext/correspondence/points/false_alarms_points.h"
#include "mrpt_ext/correspondence/points/point_fit.h"
#include "mrpt_ext/correspondence/pose_verification.h"
#include "mrpt_ext/correspondence/scan_bearing.h"
#include "mrpt_ext/correspondence/triple_schedule.h"
#include "mrpt_ext/correspondence/unsearched_evidence.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kNearPoints = 4;    // a triangle is made of a point and two of its nearest
constexpr std::size_t kMaxJudged = 2000;  // poses; each costs some ten microseconds
constexpr std::size_t kMaxWaiting = 50000;
constexpr std::size_t kMaxPairs = 15;  // widest first: they fix the heading best
/// So few landmarks seen need not be near neighbours of one another, as those of the index are.
constexpr int kFewMatches = 3;
constexpr double kDoubt =
    0.05;  // probability of unlisted poses, or expected number of false ones, that calls for pairs
constexpr double kPlaneGate = 1.15;  // a gate in the plane reaches further than one on a line for the same share
constexpr double kSamePose = 0.5;    // standard deviations
constexpr double kNothing = -std::numeric_limits<double>::infinity();

class PointSearchRun
{
 public:
  PointSearchRun(const LandmarkIndex& map, const TriangleIndex& triangles, std::span<const Scan> places,
                 const PoseSearchOptions& options, std::vector<ReadingPoint> points)
      : map_(map),
        triangles_(triangles),
        places_(places),
        options_(options),
        points_(std::move(points)),
        chance_(chancePoints(map, points_, options.gate))
  {
  }

  PoseSearchResult run()
  {
    const int count = static_cast<int>(points_.size());
    if (count >= 3) searchTriangles(std::max(3, (count + 1) / 2));
    if (best_matched_ < 3 && count > 4) searchTriangles(3);
    if (best_matched_ <= kFewMatches || !isConvincing()) searchPairs();
    finish();
    return std::move(result_);
  }

 private:
  // ---- triangles

  [[nodiscard]] std::array<double, 3> tolerances(const Triangle& t) const
  {
    const auto tolerance = [&](std::size_t a, std::size_t b)
    {
      return options_.gate * std::hypot(points_[static_cast<std::size_t>(t.corner[a])].std,
                                        points_[static_cast<std::size_t>(t.corner[b])].std);
    };
    return {tolerance(0, 1), tolerance(0, 2), tolerance(1, 2)};
  }

  /// The forms under which the index may hold the triangle: with errors, another side may be the longest.
  [[nodiscard]] std::vector<Triangle> formsOf(const Triangle& triangle) const
  {
    std::vector<Triangle> forms{triangle};
    Triangle next = triangle;
    for (int turn = 0; turn < 2; ++turn)
    {
      next = rotated(next);
      if (next.side[2] + 2 * tolerances(next)[2] >= triangle.side[2]) forms.push_back(next);
    }
    return forms;
  }

  [[nodiscard]] std::optional<Triangle> triangleOf(const std::array<int, 3>& names) const
  {
    std::array<Vector2d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = points_[static_cast<std::size_t>(names[k])].in_robot;
    return makeTriangle(corners, names);
  }

  [[nodiscard]] std::vector<int> nearestPoints(int to) const
  {
    const auto distance2 = [&](int i)
    {
      return (points_[static_cast<std::size_t>(i)].in_robot - points_[static_cast<std::size_t>(to)].in_robot)
          .squaredNorm();
    };
    std::vector<int> others;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i)
      if (i != to) others.push_back(i);
    std::sort(others.begin(), others.end(), [&](int a, int b) { return distance2(a) < distance2(b); });
    if (others.size() > kNearPoints) others.resize(kNearPoints);
    return others;
  }

  /// Triangles of near points, with the number of entries that looking them up will cost.
  [[nodiscard]] std::vector<ReadingTriple> triangleCandidates() const
  {
    std::vector<ReadingTriple> candidates;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i)
    {
      const std::vector<int> near = nearestPoints(i);
      for (std::size_t j = 0; j < near.size(); ++j)
        for (std::size_t k = 0; k < j; ++k)
        {
          const auto triangle = triangleOf({i, near[j], near[k]});
          if (!triangle || triangle->corner[0] != i) continue;
          double cost = 0;
          for (const Triangle& form : formsOf(*triangle))
            cost += static_cast<double>(triangles_.countNear(form.side, tolerances(form)));
          candidates.push_back({{i, near[j], near[k]}, cost});
        }
    }
    return candidates;
  }

  /// Tries triangles until no pose that explains as many points as the best, and at least `least`, can be missing.
  void searchTriangles(int least)
  {
    least_ = least;
    TripleSchedule cover(triangleCandidates());
    while (cover.tolerated() < static_cast<int>(points_.size()) - std::max(least_, best_matched_))
    {
      const std::optional<ReadingTriple> triple = cover.next();
      if (!triple || !withinWork()) break;
      tryTriangle(*triangleOf(triple->reading));
      ++result_.work.rounds;
      judgeWaiting();
    }
  }

  void tryTriangle(const Triangle& triangle)
  {
    const std::vector<ReadingPoint> others = pointsBeside({triangle.corner.begin(), triangle.corner.end()});
    for (const Triangle& form : formsOf(triangle))
    {
      std::array<const ReadingPoint*, 3> seen{};
      for (std::size_t k = 0; k < 3; ++k) seen[k] = &points_[static_cast<std::size_t>(form.corner[k])];
      triangles_.forEachNear(form.side, tolerances(form),
                             [&](const std::array<std::uint32_t, 3>& landmarks) {
                               weigh<3>(seen, {landmarks[0], landmarks[1], landmarks[2]}, others);
                             });
    }
  }

  // ---- pairs

  void searchPairs()
  {
    least_ = std::max(2, best_matched_);
    std::vector<std::pair<double, std::array<int, 2>>> pairs;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i)
      for (int j = 0; j < i; ++j)
        pairs.push_back(
            {(points_[static_cast<std::size_t>(i)].in_robot - points_[static_cast<std::size_t>(j)].in_robot).norm(),
             {i, j}});
    std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    if (pairs.size() > kMaxPairs) pairs.resize(kMaxPairs);
    for (const auto& [distance, names] : pairs)
    {
      if (!withinWork()) break;
      tryPair(names, distance);
      ++result_.work.rounds;
    }
    judgeWaiting();
  }

  void tryPair(const std::array<int, 2>& names, double distance)
  {
    const std::array<const ReadingPoint*, 2> seen{&points_[static_cast<std::size_t>(names[0])],
                                                  &points_[static_cast<std::size_t>(names[1])]};
    const double tolerance = options_.gate * std::hypot(seen[0]->std, seen[1]->std);
    const std::vector<ReadingPoint> others = pointsBeside({names.begin(), names.end()});
    for (std::size_t i = 0; i < map_.size() && withinWork(); ++i)
      if (map_.mayShow(seen[0]->kind, i))
        map_.forEachNear(map_.position(i), distance + tolerance,
                         [&](std::size_t j)
                         {
                           const double apart = (map_.position(i) - map_.position(j)).norm();
                           if (j != i && apart >= distance - tolerance) weigh<2>(seen, {i, j}, others);
                         });
  }

  // ---- candidates

  /// The points that a constellation does not use, nearest first: they confirm or reject it soonest.
  [[nodiscard]] std::vector<ReadingPoint> pointsBeside(const std::vector<int>& used) const
  {
    Vector2d centre(0, 0);
    for (const int u : used) centre += points_[static_cast<std::size_t>(u)].in_robot / static_cast<double>(used.size());
    std::vector<ReadingPoint> others;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i)
      if (std::find(used.begin(), used.end(), i) == used.end()) others.push_back(points_[static_cast<std::size_t>(i)]);
    std::sort(others.begin(), others.end(),
              [&](const ReadingPoint& a, const ReadingPoint& b)
              { return (a.in_robot - centre).squaredNorm() < (b.in_robot - centre).squaredNorm(); });
    return others;
  }

  template <std::size_t Count>
  void weigh(const std::array<const ReadingPoint*, Count>& seen, const std::array<std::size_t, Count>& landmarks,
             std::span<const ReadingPoint> others)
  {
    ++result_.work.tested;
    std::array<PointMatch, Count> matches;
    for (std::size_t k = 0; k < Count; ++k)
    {
      if (!map_.mayShow(seen[k]->kind, landmarks[k])) return;
      matches[k] = {seen[k], map_.position(landmarks[k])};
    }
    const int least = leastExplained();
    const GrownFit grown = growFit(map_, matches, others, kPlaneGate * options_.gate, least);
    if (grown.explained < least) return;
    if (waiting_.size() < kMaxWaiting)
      waiting_.push_back(grown);
    else
      result_.finished = false;
  }

  /// A pose that explains one point less at first may explain as much as the best when refined.
  [[nodiscard]] int leastExplained() const { return std::max(least_, best_explained_ - 1); }

  /// True when a pose that was judged already is as good as the same. The candidate's own, larger, uncertainty does not
  /// count: a rival that lies within it would be lost.
  [[nodiscard]] bool alreadyFound(const GaussianPose& candidate) const
  {
    const auto same = [&](const ConsistentPose& found)
    {
      const Vector3d e(candidate.mean.x - found.pose.mean.x, candidate.mean.y - found.pose.mean.y,
                       wrap(candidate.mean.phi - found.pose.mean.phi));
      for (Eigen::Index k = 0; k < 3; ++k)
        if (square(e(k)) > square(kSamePose) * found.pose.covariance(k, k)) return false;
      return true;
    };
    return std::any_of(result_.poses.begin(), result_.poses.end(), same);
  }

  void judgeWaiting()
  {
    std::stable_sort(waiting_.begin(), waiting_.end(),
                     [](const GrownFit& a, const GrownFit& b) { return a.explained > b.explained; });
    for (const GrownFit& candidate : waiting_)
    {
      if (candidate.explained < leastExplained()) break;
      const GaussianPose pose = candidate.fit.pose();
      if (alreadyFound(pose)) continue;
      if (result_.work.judged >= kMaxJudged)
      {
        result_.finished = false;
        break;
      }
      ++result_.work.judged;
      auto judged = verifyPose(map_, places_, options_, pose, 2);
      if (!judged) continue;
      best_explained_ = std::max(best_explained_, candidate.explained);
      best_matched_ = std::max(best_matched_, std::min(judged->matched, static_cast<int>(points_.size())));
      result_.poses.push_back(std::move(*judged));
    }
    waiting_.clear();
  }

  [[nodiscard]] bool withinWork()
  {
    if (result_.work.tested >= options_.max_tested) result_.finished = false;
    return result_.finished;
  }

  /// Log of the evidence of the poses that explain less than the best.
  [[nodiscard]] double missedEvidence() const
  {
    return logEvidenceOfUnsearched(map_, places_, areaOrMap(map_, options_.area), best_matched_);
  }

  /// False when the best pose may be chance: the right one may have been seen by no triangle of the index.
  [[nodiscard]] bool isConvincing() const
  {
    double best = kNothing;
    for (const ConsistentPose& pose : result_.poses) best = std::max(best, pose.log_evidence);
    return missedEvidence() < best + std::log(kDoubt) && expectedFalsePoses(chance_, best_matched_) < kDoubt;
  }

  void finish()
  {
    double missed = kNothing;
    if (!result_.poses.empty())
    {
      missed = missedEvidence();
      result_.expected_false = expectedFalsePoses(chance_, best_matched_);
    }
    rankPoses(result_, options_, missed, best_matched_);
    result_.unique = result_.unique && result_.finished;
  }

  const LandmarkIndex& map_;
  const TriangleIndex& triangles_;
  std::span<const Scan> places_;
  const PoseSearchOptions& options_;
  std::vector<ReadingPoint> points_;
  FalseAlarmPoints chance_;
  std::vector<GrownFit> waiting_;
  PoseSearchResult result_;
  int best_matched_ = 0;    // by a judged pose
  int best_explained_ = 0;  // before it was judged
  int least_ = 2;
};
}  // namespace

PoseSearchResult PointSearch::search(std::span<const Scan> places, const PoseSearchOptions& options) const
{
  PoseSearchResult nothing;
  if (!areUsable(places)) nothing.status = SolveStatus::bad_input;
  if (nothing.status == SolveStatus::bad_input) return nothing;
  std::vector<ReadingPoint> points = gatherPoints(places, options.gate);
  if (points.size() < 2) return nothing;
  if (map_.size() < 2)
  {
    nothing.status = SolveStatus::none;
    return nothing;
  }
  return PointSearchRun(map_, triangles_, places, options, std::move(points)).run();
}
}  // namespace mrpt_ext
