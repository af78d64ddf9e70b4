#include "mrpt_ext/relocalization/trajectory_search.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/correspondence/scan_matching.h"
#include "mrpt_ext/geometry/mahalanobis.h"
#include "mrpt_ext/hypotheses/pruning.h"
#include "mrpt_ext/relocalization/grid_search.h"
#include "mrpt_ext/relocalization/window_bearings.h"

namespace mrpt_ext
{
namespace
{
constexpr double kGate = 3.3;                 // standard deviations
constexpr std::size_t kMostSeedSteps = 6;     // steps that propose poses
constexpr std::size_t kSeedSpacing = 3;       // least number of steps from one to the next
constexpr std::size_t kMostProposed = 500;    // poses, by one seed step
constexpr std::size_t kMostTracks = 400;      // after the first update
constexpr std::size_t kMostSurvivors = 40;    // evaluated over the whole trajectory
constexpr double kKeepLogUnits = 25;          // tracks less likely than the best by more are pruned
constexpr double kProposals = 0.5;            // of the work of a seed step; the tracks get the rest
constexpr std::uint64_t kCostOfUpdate = 500;  // operations, per track and per detection
constexpr double kSameTrack = 1;              // standard deviations in each coordinate
constexpr double kSamePose = 4;               // standard deviations (Mahalanobis)
constexpr double kPriorNotProposed = 0.02;    // probability that no seed step proposes the right pose
constexpr double kMostLikelyElsewhere = 1e300;
// Initial standard deviations of the evaluation: wider than the associations leave open, yet narrow enough for a Kalman
// filter: beyond, a few bearings in a narrow field of view would move the mean out of the linear range.
const Vector3d kInitialStd(1.0, 1.0, degToRad(20.0));

double logEvidence(const HypothesisTrack& track) { return track.log_evidence; }

/// Neither mean is outside the uncertainty of the other.
bool sameTrack(const GaussianPose& a, const GaussianPose& b)
{
  return isWithin(a, b.mean, kSameTrack) && isWithin(b, a.mean, kSameTrack);
}

class TrajectorySearch
{
 public:
  TrajectorySearch(std::span<const TrajectoryStep> steps, const GlobalPoseSearch& search, const PoseRegion& region,
                   WorkBudget& budget)
      : steps_(steps), search_(search), map_(search.index()), region_(region), budget_(budget)
  {
    for (const TrajectoryStep& step : steps)
    {
      std::uint64_t& cost = cost_of_update_.emplace_back(kCostOfUpdate);
      for (const Scan& scan : step.scans) cost += costOfMatching(map_, scan) + kCostOfUpdate * scan.detections.size();
    }
  }

  TrajectorySearchResult run(std::span<const GaussianPose> current)
  {
    bool proposed = false;
    const std::vector<std::size_t> seed_steps = seedSteps();
    std::size_t left = seed_steps.size();
    if (!steps_.empty()) trackAndEvaluate(candidatesAt(current), steps_.size() - 1, shareOf(left + 1));
    for (const std::size_t seed_step : seed_steps)
    {
      WorkBudget share = shareOf(left--);
      std::vector<Candidate> candidates = candidatesAt(proposedAt(seed_step, share));
      proposed = proposed || !candidates.empty();
      trackAndEvaluate(std::move(candidates), seed_step, share);
    }
    TrajectorySearchResult result;
    if (!evaluated_.empty() || proposed) result = ranked();
    result.finished = finished_;
    return result;
  }

 private:
  struct Candidate
  {
    HypothesisTrack track;
    GaussianPose proposed;                    // at the seed step
    std::vector<std::vector<int>> landmarks;  // associated, from the seed step backward

    [[nodiscard]] double logEvidence() const { return track.log_evidence; }
  };

  // ---- 1. proposals

  [[nodiscard]] std::vector<std::size_t> seedSteps() const
  {
    const auto detections = [this](std::size_t k) { return detectionCount(steps_[k].scans); };
    std::vector<std::size_t> order, chosen;
    for (std::size_t k = 0; k < steps_.size(); ++k)
      if (detections(k) >= (pointCount(steps_[k].scans) > 0 ? 2 : 1)) order.push_back(k);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return detections(a) > detections(b); });
    for (const std::size_t k : order)
    {
      const bool near = std::any_of(chosen.begin(), chosen.end(),
                                    [&](std::size_t c) { return (c > k ? c - k : k - c) < kSeedSpacing; });
      if (!near) chosen.push_back(k);
      if (chosen.size() >= kMostSeedSteps) break;
    }
    return chosen;
  }

  [[nodiscard]] std::vector<GaussianPose> proposedAt(std::size_t seed_step, WorkBudget& share) const
  {
    const std::vector<Scan>& scans = steps_[seed_step].scans;
    std::vector<GaussianPose> poses;
    if (pointCount(scans) >= 2)
    {
      WorkBudget proposing(share, kProposals);
      PoseSearchOptions options;
      options.budget = &proposing;
      options.gate = kGate;
      options.area = Box2{region_.low, region_.low + region_.extent()};
      options.max_poses = kMostProposed;
      for (const ConsistentPose& found : search_.search(scans, options).poses) poses.push_back(found.pose);
    }
    else
      poses = gridMaxima(windowBearings(steps_, seed_step), map_, region_, share);
    std::erase_if(poses, [this](const GaussianPose& pose) { return !region_.contains(pose.mean); });
    return poses;
  }

  [[nodiscard]] static std::vector<Candidate> candidatesAt(std::span<const GaussianPose> poses)
  {
    std::vector<Candidate> candidates;
    for (const GaussianPose& pose : poses) candidates.push_back({{pose, 0}, pose, {}});
    return candidates;
  }

  // ---- 2. tracks

  [[nodiscard]] WorkBudget shareOf(std::size_t parts) const { return {budget_, 1 / static_cast<double>(parts)}; }

  void trackAndEvaluate(std::vector<Candidate> candidates, std::size_t seed_step, WorkBudget share)
  {
    trackForward(candidates, seed_step, share);
    for (Candidate& c : candidates) c.track.pose = c.proposed;
    trackBackward(candidates, seed_step, share);
    if (candidates.size() > kMostSurvivors) candidates.resize(kMostSurvivors);
    // Half evaluated, or half of them evaluated, the tracks could not be compared.
    const std::size_t before = evaluated_.size();
    for (const Candidate& candidate : candidates) evaluate(candidate, seed_step, share);
    if (share.exhausted()) evaluated_.resize(before);
    finished_ = finished_ && !share.exhausted();
  }

  void trackForward(std::vector<Candidate>& candidates, std::size_t seed_step, WorkBudget& share) const
  {
    for (std::size_t k = seed_step; k < steps_.size(); ++k)
    {
      if (!share.spend(candidates.size() * cost_of_update_[k])) return candidates.clear();
      for (Candidate& c : candidates)
      {
        if (k > seed_step) predict(c.track, steps_[k]);
        update(c.track, map_, steps_[k].scans, kGate);
      }
      if (k == seed_step || !steps_[k].scans.empty()) prune(candidates);
    }
  }

  void trackBackward(std::vector<Candidate>& candidates, std::size_t seed_step, WorkBudget& share) const
  {
    for (std::size_t k = seed_step + 1; k-- > 0;)
    {
      if (!share.spend(candidates.size() * cost_of_update_[k])) return candidates.clear();
      for (Candidate& c : candidates)
      {
        c.landmarks.push_back(update(c.track, map_, steps_[k].scans, kGate));
        if (k > 0) retrodict(c.track, steps_[k]);
      }
      if (!steps_[k].scans.empty()) prune(candidates);
    }
  }

  static void prune(std::vector<Candidate>& candidates)
  {
    sortByLogWeight(candidates, &Candidate::logEvidence);
    pruneUnlikely(candidates, kKeepLogUnits, &Candidate::logEvidence);
    mergeSame(
        candidates, [](const Candidate& a, const Candidate& b) { return sameTrack(a.track.pose, b.track.pose); },
        kMostTracks);
  }

  // ---- 3. evaluation over the whole trajectory

  void evaluate(const Candidate& candidate, std::size_t seed_step, WorkBudget& share)
  {
    HypothesisTrack track{candidate.track.pose, 0};
    track.pose.covariance = kInitialStd.cwiseAbs2().asDiagonal();
    for (std::size_t k = 0; k < steps_.size(); ++k)
    {
      if (!share.spend(cost_of_update_[k])) return;
      if (k > 0) predict(track, steps_[k]);
      if (k <= seed_step)
        updateAssociated(track, map_, steps_[k].scans, candidate.landmarks[seed_step - k]);
      else
        update(track, map_, steps_[k].scans, kGate);
    }
    if (region_.contains(track.pose.mean) && track.pose.covariance.allFinite()) evaluated_.push_back(track);
  }

  // ---- 4. ranking

  [[nodiscard]] TrajectorySearchResult ranked()
  {
    TrajectorySearchResult result{.status = SolveStatus::none};
    sortByLogWeight(evaluated_, logEvidence);
    pruneUnlikely(evaluated_, kKeepLogUnits, logEvidence);
    mergeSame(evaluated_, [](const HypothesisTrack& better, const HypothesisTrack& other)
              { return mahalanobis2(better.pose.mean, other.pose.mean, better.pose.covariance) < square(kSamePose); });
    if (evaluated_.empty()) return result;
    const double best = evaluated_.front().log_evidence;
    double total = std::exp(logEvidenceElsewhere() - best);
    if (!(total < kMostLikelyElsewhere)) total = kMostLikelyElsewhere;
    for (const HypothesisTrack& track : evaluated_) total += std::exp(track.log_evidence - best);
    double sum = 0;
    for (const HypothesisTrack& track : evaluated_)
    {
      const double weight = std::exp(track.log_evidence - best) / total;
      sum += weight;
      result.hypotheses.push_back(
          {.pose = track.pose, .log_score = track.log_evidence, .weight = weight, .source = "trajectory_search"});
    }
    result.probability_elsewhere = std::max(0.0, 1 - sum);
    result.status = SolveStatus::ok;
    return result;
  }

  /// Log-evidence expected of the right pose, times the probability that it was not proposed.
  [[nodiscard]] double logEvidenceElsewhere() const
  {
    double expected = std::log(kPriorNotProposed);
    for (const TrajectoryStep& step : steps_) expected += expectedEvidence(map_, step.scans);
    // The evaluated tracks have paid for their wide initial covariance (ratio of the volumes); so must this one.
    const Matrix3d& final_covariance = evaluated_.front().pose.covariance;
    return expected - (kInitialStd.array().log().sum() - 0.5 * std::log(final_covariance.determinant()));
  }

  std::span<const TrajectoryStep> steps_;
  const GlobalPoseSearch& search_;
  const LandmarkIndex& map_;
  const PoseRegion& region_;
  WorkBudget& budget_;
  std::vector<std::uint64_t> cost_of_update_;  // of a track with each step [operations]
  bool finished_ = true;
  std::vector<HypothesisTrack> evaluated_;
};
}  // namespace

TrajectorySearchResult localizeOverTrajectory(std::span<const TrajectoryStep> oldest_first,
                                              const GlobalPoseSearch& search, const PoseRegion& region,
                                              std::span<const GaussianPose> current, WorkBudget& budget)
{
  return TrajectorySearch(oldest_first, search, region, budget).run(current);
}

TrajectorySearchResult localizeOverTrajectory(std::span<const TrajectoryStep> oldest_first,
                                              const GlobalPoseSearch& search, const PoseRegion& region,
                                              std::span<const GaussianPose> current)
{
  WorkBudget budget = search.budget();
  return localizeOverTrajectory(oldest_first, search, region, current, budget);
}
}  // namespace mrpt_ext
