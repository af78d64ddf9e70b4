#include "mrpt_ext/filter/kalman/kalman_bank.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kSeedInflation = 2.0;      // of the deviations of a proposal
constexpr double kClearWeight = 0.9;        // of one place, or of all that are lost
constexpr double kSharp = 0.5;              // of the deviations that the verdict `ok` allows
constexpr double kPatience = 15;            // [s] after which filters start from what there is
constexpr double kLongestPause = 8;         // [s] between two looks elsewhere
constexpr double kMinWeight = 1e-6;         // lighter hypotheses are dropped
constexpr std::size_t kHeadings = 30;       // filters for a place with any heading: each sharp enough to start
constexpr std::size_t kMinDetections = 12;  // a filter that started by itself has to agree with before it is trusted

double logVolume(const Matrix3d& covariance) { return 0.5 * std::log(std::max(covariance.determinant(), 1e-30)); }

/// A place that ranges alone tell has any heading: one Gaussian for each sector of the circle.
HypothesisSet withHeadings(const HypothesisSet& proposals)
{
  HypothesisSet result;
  for (PoseHypothesis proposal : proposals)
  {
    const std::size_t headings = proposal.heading_known ? 1 : kHeadings;
    const double spacing = kTwoPi / static_cast<double>(headings);
    if (!proposal.heading_known) proposal.pose.covariance(2, 2) = square(spacing / 4);  // widened later
    for (std::size_t k = 0; k < headings; ++k)
    {
      result.push_back(proposal);
      result.back().pose.mean.phi = wrap(proposal.pose.mean.phi + spacing * static_cast<double>(k));
    }
  }
  return result;
}

/// So that a proposal's own readings, where they are the frame's, do not count for much twice.
void widen(KalmanHypothesis& filter) { filter.state.covariance.topLeftCorner<3, 3>() *= square(kSeedInflation); }
}  // namespace

KalmanStep KalmanBank::process(const Frame& frame, const HypothesisSource& propose)
{
  KalmanStep step;
  if (hypotheses_.empty())
    start(frame, propose);
  else
    track(frame, propose, step);
  step.modes = modesOf(hypotheses_);
  judgeStep(step);
  return step;
}

KalmanUpdate KalmanBank::updated(const KalmanState& state, const Frame& frame) const
{
  return options_.iterated ? updateIterated(state, frame, map_, options_.biases)
                           : updateExtended(state, frame, map_, options_.biases);
}

KalmanHypothesis KalmanBank::filterAt(const GaussianPose& pose, double log_weight) const
{
  return {.state = startingState(pose, options_.biases),
          .log_weight = log_weight,
          .quick = InlierRatioMonitor(options_.recovery),
          .trust = InlierRatioMonitor(slowRatioOptions(options_.recovery))};
}

KalmanHypotheses KalmanBank::filtersFor(const HypothesisSet& proposals) const
{
  KalmanHypotheses filters;
  for (const PoseHypothesis& proposal : withHeadings(proposals))
  {
    if (!isFinite(proposal.pose.mean) || !proposal.pose.covariance.allFinite()) continue;
    GaussianPose pose = proposal.pose;
    pose.covariance.diagonal() += options_.seed_min_std.cwiseAbs2();
    filters.push_back(filterAt(pose, proposal.log_score + logVolume(pose.covariance)));
  }
  rank(filters);
  merge(filters);
  prune(filters, std::max<std::size_t>(options_.max_hypotheses, 2), kMinWeight);
  return filters;
}

bool KalmanBank::isPrecise(const KalmanHypothesis& filter) const
{
  const Matrix3d C = filter.state.gaussianPose().covariance;
  return C(0, 0) + C(1, 1) <= square(kSharp * options_.verdict.max_std_xy) &&
         C(2, 2) <= square(kSharp * options_.verdict.max_std_phi);
}

bool KalmanBank::mayStart(const KalmanHypotheses& filters, bool complete) const
{
  if (filters.empty()) return false;
  if (waited_ > kPatience) return true;
  double sharp = 0;
  for (const KalmanHypothesis& filter : filters)
    if (isPrecise(filter)) sharp += std::exp(filter.log_weight);
  if (!(sharp > kClearWeight)) return false;
  const bool clear = std::exp(filters.front().log_weight) > kClearWeight;
  return options_.max_hypotheses > 1 || clear || complete;
}

void KalmanBank::start(const Frame& frame, const HypothesisSource& propose)
{
  if (options_.start)
  {
    hypotheses_ = {filterAt(*options_.start, 0)};
    update(hypotheses_.front(), updated(hypotheses_.front().state, frame), frame);
    hypotheses_.front().detections = kMinDetections;  // the start was told
    return rank(hypotheses_);
  }
  const Proposal proposal = propose ? propose() : Proposal{};
  KalmanHypotheses filters = filtersFor(proposal.hypotheses);
  waited_ += frame.motion.duration;
  if (!mayStart(filters, proposal.complete)) return;
  prune(filters, options_.max_hypotheses, 0);
  for (KalmanHypothesis& filter : filters)
  {
    const double weight = filter.log_weight;
    widen(filter);
    update(filter, updated(filter.state, frame), frame);
    filter.log_weight = weight;
  }
  hypotheses_ = std::move(filters);
  since_restart_ = 0;
}

void KalmanBank::track(const Frame& frame, const HypothesisSource& propose, KalmanStep& step)
{
  since_restart_ += frame.motion.duration;
  for (KalmanHypothesis& h : hypotheses_) h.state = predict(h.state, options_.biases, options_.motion, frame.motion);
  const KalmanHypothesis& first = hypotheses_.front();
  if (!first.quick.suspicious() && first.detections >= kMinDetections) pause_ = options_.recovery.min_interval;
  if (first.quick.suspicious() && since_restart_ >= pause_) lookElsewhere(propose, step);
  std::size_t best = 0;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i)
  {
    KalmanUpdate result = updated(hypotheses_[i].state, frame);
    update(hypotheses_[i], result, frame);
    if (i > 0 && !(hypotheses_[i].log_weight > hypotheses_[best].log_weight)) continue;
    best = i;
    step.best = std::move(result);
  }
  rank(hypotheses_);
  merge(hypotheses_);
  prune(hypotheses_, options_.max_hypotheses, kMinWeight);
}

void KalmanBank::lookElsewhere(const HypothesisSource& propose, KalmanStep& step)
{
  const bool single = options_.max_hypotheses == 1;
  if (single && !hypotheses_.front().quick.lost()) return;
  since_restart_ = 0;
  pause_ = std::min(2 * pause_, std::max(kLongestPause, options_.recovery.min_interval));
  KalmanHypotheses filters = filtersFor(propose ? propose().hypotheses : HypothesisSet{});
  std::erase_if(filters, [this](const KalmanHypothesis& filter) { return !isPrecise(filter); });
  if (filters.empty()) return;
  rank(filters);
  for (KalmanHypothesis& filter : filters) widen(filter);
  step.restarted = true;
  if (single)
  {
    filters.resize(1, filters.front());
    filters.front().log_weight = 0;
    hypotheses_ = std::move(filters);
    return;
  }
  const double jump = options_.recovery.relocalization_prior;
  for (KalmanHypothesis& h : hypotheses_) h.log_weight += std::log1p(-jump);
  for (KalmanHypothesis& filter : filters)
  {
    filter.log_weight += std::log(jump);
    hypotheses_.push_back(std::move(filter));
  }
}

void KalmanBank::judgeStep(KalmanStep& step) const
{
  if (hypotheses_.empty())
  {
    step.verdict = Verdict::lost;
    step.reason = "waiting for readings that narrow the place down";
    return;
  }
  const KalmanHypothesis& best = hypotheses_.front();
  const double share = best.quick.suspicious() ? best.quick.average() : best.trust.average();
  double lost_weight = 0;
  for (const KalmanHypothesis& h : hypotheses_)
    if (h.quick.lost()) lost_weight += std::exp(h.log_weight);
  const bool lost = lost_weight > kClearWeight;
  VerdictWithReason verdict = judge(step.modes, {.explained_share = share, .lost = lost}, options_.verdict);
  if (verdict.verdict == Verdict::ok && best.detections < kMinDetections)
    verdict = {Verdict::ambiguous, "one place, but known for " + std::to_string(best.detections) + " detections only"};
  step.verdict = verdict.verdict;
  step.reason = verdict.reason;
}
}  // namespace mrpt_ext
