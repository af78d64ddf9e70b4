#include "mrpt_ext/relocalization/trajectory_search.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/relocalization/grid_search.h"
#include "mrpt_ext/relocalization/window_bearings.h"

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

class TrajectorySearch
{
 public:
  TrajectorySearch(std::span<const TrajectoryStep> steps, const GlobalPoseSearch& search, const PoseRegion& region,
                   const TrajectorySearchOptions& options)
      : steps_(steps), search_(search), map_(search.index()), region_(region), options_(options)
  {
  }

  TrajectorySearchResult run(std::span<const GaussianPose> supposed)
  {
    if (!steps_.empty()) judge(proposedAs(supposed), steps_.size() - 1);
    for (const std::size_t birth : births())
    {
      std::vector<Candidate> tracks = proposed(birth);
      result_.proposed += tracks.size();
      judge(std::move(tracks), birth);
    }
    rank();
    return std::move(result_);
  }

 private:
  struct Candidate
  {
    HypothesisTrack track;
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

  static std::vector<Candidate> proposedAs(std::span<const GaussianPose> supposed)
  {
    std::vector<Candidate> tracks;
    for (const GaussianPose& pose : supposed) tracks.push_back({{pose, 0}, pose, {}});
    return tracks;
  }

  [[nodiscard]] std::vector<Candidate> proposed(std::size_t birth) const
  {
    PoseSearchOptions options;
    options.gate = options_.gate;
    options.area = Box2{region_.low, region_.low + region_.extent()};
    options.max_poses = kMostProposed;
    std::vector<Candidate> tracks;
    const auto add = [&](const GaussianPose& pose)
    {
      if (region_.contains(pose.mean)) tracks.push_back({{pose, 0}, pose, {}});
    };
    const std::vector<Scan>& seen = steps_[birth].seen;
    if (pointCount(seen) >= 2)
      for (const ConsistentPose& pose : search_.search(seen, options).poses) add(pose.pose);
    else
      for (const GaussianPose& pose : gridMaxima(windowBearings(steps_, birth), map_, region_)) add(pose);
    return tracks;
  }

  [[nodiscard]] static std::size_t pointCount(std::span<const Scan> seen)
  {
    std::size_t points = 0;
    for (const Scan& place : seen)
      points += static_cast<std::size_t>(std::count_if(place.detections.begin(), place.detections.end(),
                                                       [](const auto& d) { return d.bearing && d.range; }));
    return points;
  }

  // ---- tracks

  /// Forward to the end of the way, then back from the look that proposed them to its beginning.
  void follow(std::vector<Candidate>& tracks, std::size_t birth) const
  {
    for (Candidate& t : tracks) update(t.track, map_, steps_[birth].seen, options_.gate);
    prune(tracks);
    for (std::size_t k = birth + 1; k < steps_.size(); ++k)
    {
      for (Candidate& t : tracks)
      {
        predict(t.track, steps_[k]);
        update(t.track, map_, steps_[k].seen, options_.gate);
      }
      if (!steps_[k].seen.empty()) prune(tracks);
    }
    for (Candidate& t : tracks) t.track.pose = t.first;
    for (std::size_t k = birth + 1; k-- > 0;)
    {
      for (Candidate& t : tracks)
      {
        t.landmarks.push_back(update(t.track, map_, steps_[k].seen, options_.gate));
        if (k > 0) retrodict(t.track, steps_[k]);
      }
      if (!steps_[k].seen.empty()) prune(tracks);
    }
    if (tracks.size() > kMostTracks) tracks.resize(kMostTracks);
  }

  /// Best first, without those that have fallen behind, left the region, or met a better one.
  void prune(std::vector<Candidate>& tracks) const
  {
    std::stable_sort(tracks.begin(), tracks.end(),
                     [](const Candidate& a, const Candidate& b)
                     { return a.track.log_evidence > b.track.log_evidence; });
    const double best = tracks.empty() ? 0 : tracks.front().track.log_evidence;
    std::vector<Candidate> kept;
    for (Candidate& t : tracks)
    {
      if (t.track.log_evidence < best - options_.keep_log_units || kept.size() >= kMostFollowed) break;
      if (std::none_of(kept.begin(), kept.end(),
                       [&](const Candidate& k) { return samePose(k.track.pose, t.track.pose); }))
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

  void judge(std::vector<Candidate> tracks, std::size_t birth)
  {
    if (tracks.empty()) return;
    follow(tracks, birth);
    for (Candidate& track : tracks) judgeFromBeginning(std::move(track), birth);
  }

  void judgeFromBeginning(Candidate track, std::size_t birth)
  {
    HypothesisTrack again{track.track.pose, 0};
    again.pose.covariance = kHardlyKnown.cwiseAbs2().asDiagonal();
    for (std::size_t k = 0; k < steps_.size(); ++k)
    {
      if (k > 0) predict(again, steps_[k]);
      if (k <= birth)
        updateAssociated(again, map_, steps_[k].seen, track.landmarks[birth - k]);
      else
        update(again, map_, steps_[k].seen, options_.gate);
    }
    if (region_.contains(again.pose.mean) && again.pose.covariance.allFinite()) judged_.push_back(again);
  }

  void rank()
  {
    if (judged_.empty() && result_.proposed == 0) return;
    result_.status = SolveStatus::none;
    std::stable_sort(judged_.begin(), judged_.end(),
                     [](const HypothesisTrack& a, const HypothesisTrack& b)
                     { return a.log_evidence > b.log_evidence; });
    std::vector<HypothesisTrack> distinct;
    for (const HypothesisTrack& track : judged_)
    {
      if (track.log_evidence < judged_.front().log_evidence - options_.keep_log_units) break;
      if (std::none_of(distinct.begin(), distinct.end(),
                       [&](const HypothesisTrack& d) { return samePlace(d.pose, track.pose); }))
        distinct.push_back(track);
    }
    if (distinct.empty()) return;
    double expected = std::log(options_.missed);
    for (const TrajectoryStep& step : steps_) expected += expectedEvidence(map_, step.seen);
    // What it costs every pose not to have been known at first.
    expected -= kHardlyKnown.array().log().sum() - 0.5 * std::log(distinct.front().pose.covariance.determinant());
    const double best = distinct.front().log_evidence;
    double total = std::exp(expected - best);
    if (!(total < 1e300)) total = 1e300;
    for (const HypothesisTrack& track : distinct) total += std::exp(track.log_evidence - best);
    double known = 0;
    for (const HypothesisTrack& track : distinct)
    {
      const double weight = std::exp(track.log_evidence - best) / total;
      known += weight;
      result_.hypotheses.push_back(
          {.pose = track.pose, .log_score = track.log_evidence, .weight = weight, .source = "travel_search"});
    }
    result_.probability_elsewhere = std::max(0.0, 1 - known);
    result_.status = SolveStatus::ok;
  }

  /// Within four standard deviations of the better one.
  [[nodiscard]] static bool samePlace(const GaussianPose& better, const GaussianPose& other)
  {
    const Vector3d e(other.mean.x - better.mean.x, other.mean.y - better.mean.y,
                     wrap(other.mean.phi - better.mean.phi));
    return e.dot(better.covariance.ldlt().solve(e)) < 16;
  }

  std::span<const TrajectoryStep> steps_;
  const GlobalPoseSearch& search_;
  const LandmarkIndex& map_;
  const PoseRegion& region_;
  const TrajectorySearchOptions& options_;
  std::vector<HypothesisTrack> judged_;
  TrajectorySearchResult result_;
};
}  // namespace

TrajectorySearchResult localizeOverTrajectory(std::span<const TrajectoryStep> oldest_first,
                                              const GlobalPoseSearch& search, const PoseRegion& region,
                                              std::span<const GaussianPose> supposed,
                                              const TrajectorySearchOptions& options)
{
  return TrajectorySearch(oldest_first, search, region, options).run(supposed);
}
}  // namespace mrpt_ext
