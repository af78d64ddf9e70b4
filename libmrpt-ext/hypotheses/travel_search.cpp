#include "mrpt_ext/hypotheses/travel_search.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

#include "mrpt_ext/correspondence/interpretation_tree.h"
#include "mrpt_ext/correspondence/tree_search.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStdParallax = degToRad(1.5);  // of bearings taken within a look, from one place to the other
constexpr std::size_t kMostProposed = 500;      // by one look
constexpr std::size_t kMostTracks = 40;         // judged from the beginning
constexpr double kSamePose = 1;                 // standard deviations in each coordinate
constexpr std::size_t kApart = 3;               // looks between two that propose

class WaySearch
{
 public:
  WaySearch(std::span<const TravelStep> steps, const LostRobotSearch& search, const PoseRegion& region,
            const TravelSearchOptions& options)
      : steps_(steps), search_(search), map_(search.index()), region_(region), options_(options)
  {
  }

  TravelSearch run()
  {
    for (const std::size_t birth : births())
    {
      std::vector<Travelled> tracks = proposed(birth);
      result_.proposed += tracks.size();
      follow(tracks, birth);
      for (Travelled& track : tracks) judgeFromBeginning(std::move(track), birth);
    }
    rank();
    return std::move(result_);
  }

 private:
  struct Travelled
  {
    PoseTrack track;
    GaussianPose first;                       // at the look that proposed it
    std::vector<std::vector<int>> landmarks;  // taken in on the way back, newest look first
  };

  [[nodiscard]] std::size_t detections(std::size_t step) const { return detectionCount(steps_[step].seen); }

  /// The fullest looks, not next to each other.
  [[nodiscard]] std::vector<std::size_t> births() const
  {
    std::vector<std::size_t> order, chosen;
    for (std::size_t k = 0; k < steps_.size(); ++k)
      if (detections(k) >= 2) order.push_back(k);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return detections(a) > detections(b); });
    for (const std::size_t k : order)
    {
      const bool near =
          std::any_of(chosen.begin(), chosen.end(), [&](std::size_t c) { return (c > k ? c - k : k - c) < kApart; });
      if (!near) chosen.push_back(k);
      if (chosen.size() >= options_.births) break;
    }
    return chosen;
  }

  // ---- proposals

  [[nodiscard]] std::vector<Travelled> proposed(std::size_t birth) const
  {
    PoseSearchOptions options;
    options.gate = options_.gate;
    options.area = MapArea{region_.low, region_.low + region_.extent()};
    options.max_poses = kMostProposed;
    std::vector<Travelled> tracks;
    const auto add = [&](const GaussianPose& pose)
    {
      if (region_.contains(pose.mean)) tracks.push_back({{pose, 0}, pose, {}});
    };
    const std::vector<SensorPlace>& seen = steps_[birth].seen;
    if (pointCount(seen) >= 2)
      for (const ConsistentPose& pose : search_.search(seen, options).poses) add(pose.pose);
    else
      for (const GaussianPose& pose : fromBearings(seen, options)) add(pose);
    return tracks;
  }

  [[nodiscard]] static std::size_t pointCount(std::span<const SensorPlace> seen)
  {
    std::size_t points = 0;
    for (const SensorPlace& place : seen)
      points += static_cast<std::size_t>(std::count_if(place.detections.begin(), place.detections.end(),
                                                       [](const auto& d) { return d.bearing && d.range; }));
    return points;
  }

  /// The bearings of a look as if all were taken from its last place; the tree gives all poses of three or more.
  [[nodiscard]] std::vector<GaussianPose> fromBearings(std::span<const SensorPlace> seen,
                                                       const PoseSearchOptions& options) const
  {
    std::vector<UnidentifiedBearing> bearings;
    double std = 0;
    const SensorPlace& last = seen.back();
    for (const SensorPlace& place : seen)
      for (const UnidentifiedDetection& d : place.detections)
      {
        if (!d.bearing || d.kind == kNoSuchKind || bearings.size() >= kMostBearings) continue;
        const bool here = &place == &last;
        bearings.push_back(
            {wrap(*d.bearing + place.T_robot_sensor.phi - last.T_robot_sensor.phi), landmarksOfKind(d.kind)});
        std = std::max(std, here ? d.std_bearing : std::hypot(d.std_bearing, kStdParallax));
      }
    if (bearings.size() < 3 || map_.size() > kLargestTreeMap) return {};
    InterpretationOptions tree;
    tree.gate = InterpretationGate::covariance;
    tree.max_residual = options_.gate * std;
    tree.std_bearing = std;
    tree.allow_three = true;
    tree.max_unmatched = static_cast<int>(bearings.size()) - 3;
    if (tree.max_unmatched > 1) tree.max_unmatched = 1;
    tree.area = options.area;
    if (last.model.max_range) tree.max_range = 1.3 * *last.model.max_range;
    std::vector<Interpretation> solutions = interpretBearings(map_.positions(), bearings, tree).solutions;
    std::stable_sort(solutions.begin(), solutions.end(),
                     [](const Interpretation& a, const Interpretation& b)
                     { return a.log_likelihood > b.log_likelihood; });
    if (solutions.size() > kMostProposed) solutions.resize(kMostProposed);
    std::vector<GaussianPose> poses;
    const Pose2 back = inverse(last.T_robot_sensor);
    for (const Interpretation& solution : solutions)
    {
      const Matrix3d J = composeJacobianFirst(solution.pose.mean, back);
      poses.push_back({compose(solution.pose.mean, back), J * solution.pose.covariance * J.transpose()});
    }
    return poses;
  }

  /// Empty: any.
  [[nodiscard]] std::vector<int> landmarksOfKind(int kind) const
  {
    std::vector<int> landmarks;
    if (kind == kAnyKind || map_.kindCount() < 2) return landmarks;
    for (std::size_t l = 0; l < map_.size(); ++l)
      if (map_.kind(l) == kind) landmarks.push_back(static_cast<int>(l));
    return landmarks;
  }

  // ---- tracks

  /// Forward to the end of the way, then back from the look that proposed them to its beginning.
  void follow(std::vector<Travelled>& tracks, std::size_t birth) const
  {
    for (std::size_t k = birth + 1; k < steps_.size(); ++k)
    {
      for (Travelled& t : tracks)
      {
        moveForward(t.track, steps_[k]);
        confront(t.track, map_, steps_[k].seen, options_.gate);
      }
      if (!steps_[k].seen.empty()) prune(tracks);
    }
    for (Travelled& t : tracks) t.track.pose = t.first;
    for (std::size_t k = birth + 1; k-- > 0;)
    {
      for (Travelled& t : tracks)
      {
        t.landmarks.push_back(confront(t.track, map_, steps_[k].seen, options_.gate));
        if (k > 0) moveBack(t.track, steps_[k]);
      }
      if (!steps_[k].seen.empty()) prune(tracks);
    }
    if (tracks.size() > kMostTracks) tracks.resize(kMostTracks);
  }

  /// Best first, without those that have fallen behind, left the region, or met a better one.
  void prune(std::vector<Travelled>& tracks) const
  {
    std::stable_sort(tracks.begin(), tracks.end(),
                     [](const Travelled& a, const Travelled& b)
                     { return a.track.log_evidence > b.track.log_evidence; });
    std::vector<Travelled> kept;
    for (Travelled& t : tracks)
    {
      if (t.track.log_evidence < tracks.front().track.log_evidence - options_.keep_log_units) break;
      if (std::none_of(kept.begin(), kept.end(),
                       [&](const Travelled& k) { return samePose(k.track.pose, t.track.pose); }))
        kept.push_back(std::move(t));
    }
    tracks = std::move(kept);
  }

  /// Neither lies outside the other's uncertainty.
  [[nodiscard]] static bool samePose(const GaussianPose& a, const GaussianPose& b)
  {
    const Vector3d e(a.mean.x - b.mean.x, a.mean.y - b.mean.y, wrap(a.mean.phi - b.mean.phi));
    for (Eigen::Index k = 0; k < 3; ++k)
      if (square(e(k)) > square(kSamePose) * std::min(a.covariance(k, k), b.covariance(k, k))) return false;
    return true;
  }

  // ---- judgement

  void judgeFromBeginning(Travelled track, std::size_t birth)
  {
    PoseTrack again{track.track.pose, 0};
    const Vector2d extent = region_.extent();
    again.pose.covariance = Vector3d(square(extent.x()), square(extent.y()), square(kTwoPi)).asDiagonal();
    for (std::size_t k = 0; k < steps_.size(); ++k)
    {
      if (k > 0) moveForward(again, steps_[k]);
      if (k <= birth)
        confrontAs(again, map_, steps_[k].seen, track.landmarks[birth - k]);
      else
        confront(again, map_, steps_[k].seen, options_.gate);
    }
    if (region_.contains(again.pose.mean) && again.pose.covariance.allFinite()) judged_.push_back(again);
  }

  void rank()
  {
    if (result_.proposed == 0) return;
    result_.status = SolveStatus::none;
    std::stable_sort(judged_.begin(), judged_.end(),
                     [](const PoseTrack& a, const PoseTrack& b) { return a.log_evidence > b.log_evidence; });
    std::vector<PoseTrack> distinct;
    for (const PoseTrack& track : judged_)
    {
      if (track.log_evidence < judged_.front().log_evidence - options_.keep_log_units) break;
      if (std::none_of(distinct.begin(), distinct.end(),
                       [&](const PoseTrack& d) { return samePlace(d.pose, track.pose); }))
        distinct.push_back(track);
    }
    if (distinct.empty()) return;
    double expected = std::log(options_.missed);
    for (const TravelStep& step : steps_) expected += expectedEvidence(map_, step.seen);
    const double best = distinct.front().log_evidence;
    double total = std::exp(expected - best);
    if (!(total < 1e300)) total = 1e300;
    for (const PoseTrack& track : distinct) total += std::exp(track.log_evidence - best);
    double known = 0;
    for (const PoseTrack& track : distinct)
    {
      const double weight = std::exp(track.log_evidence - best) / total;
      known += weight;
      result_.hypotheses.push_back(
          {.pose = track.pose, .log_score = track.log_evidence, .weight = weight, .source = "travel_search"});
    }
    result_.elsewhere = std::max(0.0, 1 - known);
    result_.status = SolveStatus::ok;
  }

  /// Within four standard deviations of the better one.
  [[nodiscard]] static bool samePlace(const GaussianPose& better, const GaussianPose& other)
  {
    const Vector3d e(other.mean.x - better.mean.x, other.mean.y - better.mean.y,
                     wrap(other.mean.phi - better.mean.phi));
    return e.dot(better.covariance.ldlt().solve(e)) < 16;
  }

  static constexpr std::size_t kMostBearings = 5;

  std::span<const TravelStep> steps_;
  const LostRobotSearch& search_;
  const LandmarkIndex& map_;
  const PoseRegion& region_;
  const TravelSearchOptions& options_;
  std::vector<PoseTrack> judged_;
  TravelSearch result_;
};
}  // namespace

TravelSearch searchAlongWay(std::span<const TravelStep> oldest_first, const LostRobotSearch& search,
                            const PoseRegion& region, const TravelSearchOptions& options)
{
  return WaySearch(oldest_first, search, region, options).run();
}
}  // namespace mrpt_ext
