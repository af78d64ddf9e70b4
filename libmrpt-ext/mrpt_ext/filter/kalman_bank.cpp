#include "mrpt_ext/filter/kalman_bank.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/formatted.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSeedInflation = 2.0;            // of the standard deviations of a proposal
constexpr double kClearWeight = 0.9;              // of one hypothesis, or of all that are lost
constexpr double kPrecise = 0.5;                  // of the standard deviations that the verdict `ok` allows
constexpr double kMaxWait = 15;                   // [s] after which filters start from what there is
constexpr double kMaxReseedInterval = 8;          // [s]
constexpr double kMinWeight = 1e-6;               // lighter hypotheses are dropped
constexpr std::size_t kHeadings = 30;             // filters for a pose of unknown heading: each narrow enough to start
constexpr std::size_t kMinJudgedDetections = 12;  // that a filter has to agree with before it is trusted

double logVolume(const Matrix3d& covariance) { return 0.5 * std::log(std::max(covariance.determinant(), 1e-30)); }

/// A hypothesis of unknown heading (ranges alone) as one Gaussian per sector of the circle.
HypothesisSet withHeadings(const HypothesisSet& proposals, std::size_t sectors)
{
  HypothesisSet result;
  for (PoseHypothesis proposal : proposals)
  {
    const std::size_t headings = proposal.heading_known ? 1 : sectors;
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

/// The readings that a proposal rests on may be those of the frame: it is widened, so that they hardly count twice.
void widen(KalmanHypothesis& filter) { filter.state.covariance.topLeftCorner<3, 3>() *= square(kSeedInflation); }
}  // namespace

KalmanBank::KalmanBank(KalmanBankOptions options, const LandmarkTable& map)
    : options_(std::move(options)),
      map_(map),
      recovery_(options_.recovery, kMaxReseedInterval),
      consider_(options_.motion, options_.biases, map, options_.start)
{
}

KalmanStep KalmanBank::process(const Frame& whole, const HypothesisSource& propose)
{
  const std::size_t filters = std::max(hypotheses_.size(), options_.max_hypotheses);
  const std::optional<Frame> affordable = affordableToUpdate(whole, map_, filters);
  const Frame frame = consider_.withExcess(affordable ? *affordable : whole);
  KalmanStep step;
  if (hypotheses_.empty())
    initialize(frame, propose);
  else
    track(frame, propose, step);
  step.modes = modesOf(hypotheses_);
  if (!hypotheses_.empty())
  {
    consider_.follow(hypotheses_.front().state, frame, true);
    step.modes.modes.front().pose.covariance += consider_.added();
  }
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
          .fast_ratio = InlierRatioMonitor::fast(options_.recovery),
          .slow_ratio = InlierRatioMonitor::slow(options_.recovery)};
}

KalmanHypotheses KalmanBank::filtersFor(const HypothesisSet& proposals) const
{
  KalmanHypotheses filters;
  for (const PoseHypothesis& proposal : withHeadings(proposals, options_.heading_observable ? kHeadings : 1))
  {
    if (!isFinite(proposal.pose.mean) || !proposal.pose.covariance.allFinite()) continue;
    GaussianPose pose = proposal.pose;
    pose.covariance.diagonal() += kMinSeedStd.cwiseAbs2();
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
  return C(0, 0) + C(1, 1) <= square(kPrecise * options_.verdict.max_std_xy) &&
         C(2, 2) <= square(kPrecise * options_.verdict.max_std_phi);
}

bool KalmanBank::mayInitialize(const KalmanHypotheses& filters, bool complete) const
{
  if (filters.empty()) return false;
  if (waited_ > kMaxWait) return true;
  double precise = 0;
  for (const KalmanHypothesis& filter : filters)
    if (isPrecise(filter)) precise += std::exp(filter.log_weight);
  if (!(precise > kClearWeight)) return false;
  const bool clear = std::exp(filters.front().log_weight) > kClearWeight;
  return options_.max_hypotheses > 1 || clear || complete;
}

void KalmanBank::initialize(const Frame& frame, const HypothesisSource& propose)
{
  if (options_.start)
  {
    hypotheses_ = {filterAt(*options_.start, 0)};
    update(hypotheses_.front(), updated(hypotheses_.front().state, frame), frame);
    hypotheses_.front().detections = kMinJudgedDetections;  // a known start is trusted
    recovery_.start();
    return rank(hypotheses_);
  }
  const Proposal proposal = propose ? propose() : Proposal{};
  KalmanHypotheses filters = filtersFor(proposal.hypotheses);
  waited_ += frame.motion.duration;
  if (!mayInitialize(filters, proposal.complete)) return;
  prune(filters, options_.max_hypotheses, 0);
  for (KalmanHypothesis& filter : filters)
  {
    const double weight = filter.log_weight;
    widen(filter);
    update(filter, updated(filter.state, frame), frame);
    filter.log_weight = weight;
  }
  hypotheses_ = std::move(filters);
  recovery_.start();
}

void KalmanBank::track(const Frame& frame, const HypothesisSource& propose, KalmanStep& step)
{
  for (KalmanHypothesis& h : hypotheses_) h.state = predict(h.state, options_.biases, options_.motion, frame.motion);
  const Recovery recovery = decideRecovery(frame.motion.duration);
  if (recovery.due()) step.restarted = inject(recovery.prior, propose);
  std::size_t best = 0;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i)
  {
    KalmanUpdate result = updated(hypotheses_[i].state, frame);
    update(hypotheses_[i], result, frame);
    if (i > 0 && !(hypotheses_[i].log_weight > hypotheses_[best].log_weight)) continue;
    best = i;
    step.best = std::move(result);
  }
  if (best != 0 || (step.restarted && options_.max_hypotheses == 1)) consider_.restart();
  rank(hypotheses_);
  merge(hypotheses_);
  prune(hypotheses_, options_.max_hypotheses, kMinWeight);
}

Recovery KalmanBank::decideRecovery(double elapsed)
{
  const KalmanHypothesis& best = hypotheses_.front();
  const bool suspicious = best.fast_ratio.suspicious();
  if (!suspicious && best.detections >= kMinJudgedDetections) recovery_.resetReseeding();
  // A single filter gives its hypothesis up: only when it is lost.
  const bool may_replace = options_.max_hypotheses > 1 || best.fast_ratio.lost();
  return recovery_.decide({.suspicious = suspicious && may_replace}, elapsed);
}

bool KalmanBank::inject(double prior, const HypothesisSource& propose)
{
  KalmanHypotheses filters = filtersFor(propose ? propose().hypotheses : HypothesisSet{});
  std::erase_if(filters, [this](const KalmanHypothesis& filter) { return !isPrecise(filter); });
  if (filters.empty()) return false;
  rank(filters);
  for (KalmanHypothesis& filter : filters) widen(filter);
  if (options_.max_hypotheses == 1)
  {
    filters.resize(1, filters.front());
    filters.front().log_weight = 0;
    hypotheses_ = std::move(filters);
    return true;
  }
  for (KalmanHypothesis& h : hypotheses_) h.log_weight += std::log1p(-prior);
  for (KalmanHypothesis& filter : filters)
  {
    filter.log_weight += std::log(prior);
    hypotheses_.push_back(std::move(filter));
  }
  return true;
}

void KalmanBank::judgeStep(KalmanStep& step) const
{
  if (hypotheses_.empty())
  {
    step.verdict = Verdict::lost;
    step.reason = "not initialized: the measurements do not constrain the pose yet";
    return;
  }
  const KalmanHypothesis& best = hypotheses_.front();
  const double ratio = best.fast_ratio.suspicious() ? best.fast_ratio.average() : best.slow_ratio.average();
  double lost_weight = 0;
  for (const KalmanHypothesis& h : hypotheses_)
    if (h.fast_ratio.lost()) lost_weight += std::exp(h.log_weight);
  const bool lost = lost_weight > kClearWeight;
  VerdictWithReason verdict = judge(step.modes, {.inlier_ratio = ratio, .lost = lost}, options_.verdict);
  if (verdict.verdict == Verdict::ok && best.detections < kMinJudgedDetections)
    verdict = {Verdict::ambiguous, formatted("one mode, but only %zu detections so far", best.detections)};
  step.verdict = verdict.verdict;
  step.reason = verdict.reason;
}
}  // namespace mrpt_ext
