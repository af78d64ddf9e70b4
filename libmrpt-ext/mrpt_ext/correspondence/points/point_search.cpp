#include "mrpt_ext/correspondence/points/point_search.h"

#include <algorithm>
#include <limits>

#include "mrpt_ext/correspondence/points/false_alarms_points.h"
#include "mrpt_ext/correspondence/points/point_fit.h"
#include "mrpt_ext/correspondence/pose_verification.h"
#include "mrpt_ext/correspondence/scan_bearing.h"
#include "mrpt_ext/correspondence/search_input.h"
#include "mrpt_ext/correspondence/triple_schedule.h"
#include "mrpt_ext/correspondence/unsearched_evidence.h"
#include "mrpt_ext/geometry/log_probability.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kNearPoints = 4;          // a triangle is made of a point and two of its nearest
constexpr std::size_t kMaxVerifiedFits = 2000;  // poses; each costs some ten microseconds
constexpr std::size_t kMaxPending = 50000;
constexpr std::size_t kMostPoints = 100;                                 // of a scan
constexpr std::uint64_t kCostOfCandidate = 20, kCostOfPairOfPoints = 6;  // operations, besides growing it
constexpr std::size_t kMaxPairs = 15;                                    // widest first: they fix the heading best
/// So few inliers need not be near neighbours of one another, as the triangles of the index are.
constexpr int kFewMatches = 3;
constexpr double kDoubtful =
    0.05;  // probability elsewhere, or expected number of false poses, from which on pairs are tried
constexpr double kPlaneGate = 1.15;  // a gate in the plane reaches further than one on a line for the same share
constexpr double kSamePose = 0.5;    // standard deviations

class PointSearchRun
{
 public:
  PointSearchRun(const LandmarkIndex& map, const TriangleIndex& triangles, std::span<const Scan> scans,
                 const PoseSearchOptions& options, std::vector<ScanPoint> points, WorkBudget& budget)
      : map_(map),
        triangles_(triangles),
        scans_(scans),
        options_(options),
        points_(std::move(points)),
        budget_(budget),
        proposing_(budget, kProposingShare),
        false_alarms_(pointFalseAlarmModel(map, points_, options.gate))
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

  [[nodiscard]] std::optional<Triangle> triangleOf(const std::array<int, 3>& indices) const
  {
    std::array<Vector2d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = points_[static_cast<std::size_t>(indices[k])].in_robot;
    return makeTriangle(corners, indices);
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

  /// Triangles of near points, with the number of index entries to look up.
  [[nodiscard]] std::vector<DetectionTriple> triangleCandidates() const
  {
    std::vector<DetectionTriple> candidates;
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

  /// Tries triangles until no pose with as many inliers as the best, and at least `least`, can be missing.
  void searchTriangles(int least)
  {
    least_ = least;
    TripleSchedule schedule(triangleCandidates(), proposing_);
    while (schedule.tolerated() < static_cast<int>(points_.size()) - std::max(least_, best_matched_))
    {
      const std::optional<DetectionTriple> triple = schedule.next();
      if (!withinWork() || !triple) break;
      tryTriangle(*triangleOf(triple->detection));
      ++result_.work.rounds;
      verifyPending();
    }
  }

  void tryTriangle(const Triangle& triangle)
  {
    const std::vector<ScanPoint> others = otherPoints({triangle.corner.begin(), triangle.corner.end()});
    for (const Triangle& form : formsOf(triangle))
    {
      std::array<const ScanPoint*, 3> seen{};
      for (std::size_t k = 0; k < 3; ++k) seen[k] = &points_[static_cast<std::size_t>(form.corner[k])];
      triangles_.forEachNear(form.side, tolerances(form),
                             [&](const std::array<std::uint32_t, 3>& landmarks)
                             {
                               if (proposing_.spend(kCostOfCandidate))
                                 evaluate<3>(seen, {landmarks[0], landmarks[1], landmarks[2]}, others);
                             });
      if (!proposing_.spend(triangles_.countNear(form.side, tolerances(form)))) return;
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
    for (const auto& [distance, indices] : pairs)
    {
      if (!withinWork()) break;
      tryPair(indices, distance);
      ++result_.work.rounds;
    }
    verifyPending();
  }

  void tryPair(const std::array<int, 2>& indices, double distance)
  {
    const std::array<const ScanPoint*, 2> seen{&points_[static_cast<std::size_t>(indices[0])],
                                               &points_[static_cast<std::size_t>(indices[1])]};
    const double tolerance = options_.gate * std::hypot(seen[0]->std, seen[1]->std);
    const double least2 = square(std::max(0.0, distance - tolerance));
    const std::vector<ScanPoint> others = otherPoints({indices.begin(), indices.end()});
    const auto evaluate_pair = [&](std::size_t i, std::size_t j)
    {
      const double apart2 = (map_.position(i) - map_.position(j)).squaredNorm();
      const bool fits = j != i && apart2 >= least2;
      if (proposing_.spend(fits ? kCostOfCandidate : kCostOfPairOfPoints) && fits) evaluate<2>(seen, {i, j}, others);
    };
    for (std::size_t i = 0; i < map_.size() && withinWork(); ++i)
      if (map_.mayShow(seen[0]->category, i))
        map_.forEachNear(map_.position(i), distance + tolerance, [&](std::size_t j) { evaluate_pair(i, j); });
  }

  // ---- candidates

  /// The points outside a constellation, nearest first: they confirm or reject it soonest.
  [[nodiscard]] std::vector<ScanPoint> otherPoints(const std::vector<int>& used) const
  {
    Vector2d centre(0, 0);
    for (const int u : used) centre += points_[static_cast<std::size_t>(u)].in_robot / static_cast<double>(used.size());
    std::vector<ScanPoint> others;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i)
      if (std::find(used.begin(), used.end(), i) == used.end()) others.push_back(points_[static_cast<std::size_t>(i)]);
    std::sort(others.begin(), others.end(),
              [&](const ScanPoint& a, const ScanPoint& b)
              { return (a.in_robot - centre).squaredNorm() < (b.in_robot - centre).squaredNorm(); });
    return others;
  }

  template <std::size_t Count>
  void evaluate(const std::array<const ScanPoint*, Count>& seen, const std::array<std::size_t, Count>& landmarks,
                std::span<const ScanPoint> others)
  {
    ++result_.work.tested;
    std::array<PointMatch, Count> matches;
    for (std::size_t k = 0; k < Count; ++k)
    {
      if (!map_.mayShow(seen[k]->category, landmarks[k])) return;
      matches[k] = {seen[k], map_.position(landmarks[k])};
    }
    const int least = leastInliers();
    const GrownFit grown = growFit(map_, matches, others, kPlaneGate * options_.gate, least);
    proposing_.spend(grown.operations);
    if (grown.inliers < least) return;
    if (pending_.size() < kMaxPending)
      pending_.push_back(grown);
    else
      result_.finished = false;
  }

  /// A pose with one inlier less may reach the best after its refinement.
  [[nodiscard]] int leastInliers() const { return std::max(least_, most_inliers_ - 1); }

  /// True when a verified pose is nearly the same. The candidate's own, larger, uncertainty does not count: a
  /// different pose within it would be lost.
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

  void verifyPending()
  {
    std::stable_sort(pending_.begin(), pending_.end(),
                     [](const GrownFit& a, const GrownFit& b) { return a.inliers > b.inliers; });
    for (const GrownFit& candidate : pending_)
    {
      if (candidate.inliers < leastInliers()) break;
      const GaussianPose pose = candidate.fit.pose();
      if (alreadyFound(pose)) continue;
      if (result_.work.verified >= kMaxVerifiedFits || !budget_.spend(result_.poses.size()))
      {
        result_.finished = false;
        break;
      }
      ++result_.work.verified;
      auto verified = verifyPose(map_, scans_, options_, pose, 2);
      if (!verified) continue;
      most_inliers_ = std::max(most_inliers_, candidate.inliers);
      best_matched_ = std::max(best_matched_, std::min(verified->matched, static_cast<int>(points_.size())));
      result_.poses.push_back(std::move(*verified));
    }
    pending_.clear();
  }

  [[nodiscard]] bool withinWork()
  {
    if (proposing_.exhausted()) result_.finished = false;
    return result_.finished;
  }

  /// Log of the evidence of the poses with fewer inliers than the best.
  [[nodiscard]] double unsearchedEvidence() const
  {
    return logEvidenceOfUnsearched(map_, scans_, areaOrMap(map_, options_.area), best_matched_);
  }

  /// False when the best pose may be a false alarm: the true one may have no triangle in the index.
  [[nodiscard]] bool isConvincing() const
  {
    double best = kLogZero;
    for (const ConsistentPose& pose : result_.poses) best = std::max(best, pose.log_evidence);
    return unsearchedEvidence() < best + std::log(kDoubtful) &&
           expectedFalsePoses(false_alarms_, best_matched_) < kDoubtful;
  }

  void finish()
  {
    if (budget_.exhausted()) result_.finished = false;
    double missed = kLogZero;
    if (!result_.poses.empty())
    {
      missed = unsearchedEvidence();
      result_.expected_false = expectedFalsePoses(false_alarms_, best_matched_);
    }
    rankPoses(result_, options_, missed, best_matched_);
    result_.unique = result_.unique && result_.finished;
  }

  const LandmarkIndex& map_;
  const TriangleIndex& triangles_;
  std::span<const Scan> scans_;
  const PoseSearchOptions& options_;
  std::vector<ScanPoint> points_;
  WorkBudget& budget_;
  WorkBudget proposing_;
  PointFalseAlarmModel false_alarms_;
  std::vector<GrownFit> pending_;
  PoseSearchResult result_;
  int best_matched_ = 0;  // of a verified pose
  int most_inliers_ = 0;  // before the verification
  int least_ = 2;
};
}  // namespace

PoseSearchResult PointSearch::search(std::span<const Scan> scans, const PoseSearchOptions& options) const
{
  const SearchInput input(scans, kMostPoints);
  std::vector<ScanPoint> points = gatherPoints(input.scans(), options.gate);
  if (const auto nothing = input.resultWithoutSearch(points.size(), 2, map_.size())) return *nothing;
  WorkBudget own;
  WorkBudget budget =
      WorkBudget::partOf(options.budget != nullptr ? *options.budget : own, mostSearchWork(map_.size()));
  PoseSearchOptions within = options;
  within.budget = &budget;
  PoseSearchResult result = PointSearchRun(map_, triangles_, input.scans(), within, std::move(points), budget).run();
  input.restore(result);
  return result;
}
}  // namespace mrpt_ext
