#include "mrpt_ext/relocalization/trajectory_search.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/relocalization/window_bearings.h"
#include "mrpt_ext/relocalization/grid_search.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostProposed = 500;  // by one look
constexpr std::size_t kMostFollowed = 400;
constexpr std::size_t kMostTracks = 40;  // judged from the beginning
constexpr double kSamePose = 1;          // standard deviations in each coordinate
// Spread of a pose that is judged from the beginning: more than the looks leave open, and no more than a Kalman filter
// can start from; beyond it, a few bearings in a narrow view would throw the mean out of where it is linear.
const Vector3d kHardlyKnown(1.0, 1.0, degToRad(20.0));
constexpr std::size_t kApart = 3;  // looks between two that propose

class WaySearch
{
 public:
  WaySearch(std::span<const TravelStep> steps, const LostRobotSearch& search, const PoseRegion& region,
            const TravelSearchOptions& options)
      : steps_(steps), search_(search), map_(search.index()), region_(region), options_(options)
  {
  }

  TravelSearch run(std::span<const GaussianPose> supposed)
  {
    if (!steps_.empty()) judge(proposedAs(supposed), steps_.size() - 1);
    for (const std::size_t birth : births())
    {
      std::vector<Travelled> tracks = proposed(birth);
      result_.proposed += tracks.size();
      judge(std::move(tracks), birth);
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
      if (detections(k) >= (pointCount(steps_[k].seen) > 0 ? 2 : 1)) order.push_back(k);
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

  static std::vector<Travelled> proposedAs(std::span<const GaussianPose> supposed)
  {
    std::vector<Travelled> tracks;
    for (const GaussianPose& pose : supposed) tracks.push_back({{pose, 0}, pose, {}});
    return tracks;
  }

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
      for (const GaussianPose& pose : likelyPoses(joinedBearings(steps_, birth), map_, region_)) add(pose);
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

  // ---- tracks

  /// Forward to the end of the way, then back from the look that proposed them to its beginning.
  void follow(std::vector<Travelled>& tracks, std::size_t birth) const
  {
    for (Travelled& t : tracks) confront(t.track, map_, steps_[birth].seen, options_.gate);
    prune(tracks);
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
    const double best = tracks.empty() ? 0 : tracks.front().track.log_evidence;
    std::vector<Travelled> kept;
    for (Travelled& t : tracks)
    {
      if (t.track.log_evidence < best - options_.keep_log_units || kept.size() >= kMostFollowed) break;
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

  void judge(std::vector<Travelled> tracks, std::size_t birth)
  {
    if (tracks.empty()) return;
    follow(tracks, birth);
    for (Travelled& track : tracks) judgeFromBeginning(std::move(track), birth);
  }

  void judgeFromBeginning(Travelled track, std::size_t birth)
  {
    PoseTrack again{track.track.pose, 0};
    again.pose.covariance = kHardlyKnown.cwiseAbs2().asDiagonal();
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
    if (judged_.empty() && result_.proposed == 0) return;
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
    // What it costs every pose not to have been known at first.
    expected -= kHardlyKnown.array().log().sum() - 0.5 * std::log(distinct.front().pose.covariance.determinant());
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
                            const PoseRegion& region, std::span<const GaussianPose> supposed,
                            const TravelSearchOptions& options)
{
  return WaySearch(oldest_first, search, region, options).run(supposed);
}
}  // namespace mrpt_ext
