#include "mrpt_ext/localizers/particle_filter_localizer.h"

#include "mrpt_ext/geometry/bounded_frame.h"
#include "mrpt_ext/hypotheses/bias_inflation.h"
#include "mrpt_ext/hypotheses/informative_readings.h"
#include "mrpt_ext/hypotheses/window_readings.h"

namespace mrpt_ext
{
namespace
{
// Of an interpretation tree if other proposals follow: before the start, and every half second during recovery, where
// the trajectory is searched too.
constexpr std::uint64_t kFewNodes = 20'000;
constexpr double kWindowShare = 0.6;  // of the work of a step; the trajectory gets the rest
}  // namespace

ParticleFilterLocalizer::ParticleFilterLocalizer(const ParticleFilterOptions& options, const LandmarkTable& map,
                                                 double seed_window, std::uint64_t seed, std::uint64_t stream,
                                                 std::shared_ptr<const GlobalPoseSearch> search)
    : map_(map),
      search_(search ? std::move(search) : std::make_shared<const GlobalPoseSearch>(map)),
      region_(options.region),
      biases_(options.biases),
      filter_(options, map, seed, stream),
      window_(seed_window, options.motion),
      range_only_start_(options.motion),
      relocalizer_(map, search_, options.region, options.motion)
{
}

Proposal ParticleFilterLocalizer::proposeFromWindow(WorkBudget& budget) const
{
  Frame evidence = window_.frame();
  if (isWindow(evidence.readings)) evidence.readings = informativeReadings(evidence.readings);
  if (auto bounded = boundedFrame(evidence, kMostJoined)) evidence = std::move(*bounded);
  std::vector<Reading> readings = evidence.readings;
  evidence.readings = withBiasUncertainty(std::move(evidence.readings), biases_);
  ProposalOptions options{.region = region_};
  WorkBudget share(budget, relocalizer_.isApplicable() ? kWindowShare : 1);
  options.limits.budget = &share;
  if (!filter_.particles().empty() || !window_.full()) options.limits.max_tree_nodes = kFewNodes;
  Proposal proposal(proposePoses(evidence, map_, *search_, options));
  proposal.window_readings = std::move(readings);
  proposal.complete = window_.full();
  return proposal;
}

Proposal ParticleFilterLocalizer::propose(WorkBudget& budget)
{
  Proposal proposal = proposeFromWindow(budget);
  // During recovery the filter asks for hypotheses of the trajectory by itself.
  if (!filter_.particles().empty() || !proposal.complete) return proposal;
  const HypothesisSet along = relocalizer_.search({}, budget);
  proposal.hypotheses.insert(proposal.hypotheses.end(), along.begin(), along.end());
  return proposal;
}

Estimate ParticleFilterLocalizer::process(const Frame& whole)
{
  const std::optional<Frame> bounded = boundedFrame(whole);
  const Frame& frame = bounded ? *bounded : whole;
  window_.add(frame);
  range_only_start_.add(frame);
  relocalizer_.add(frame);
  WorkBudget budget = search_->budget();
  HypothesisSources sources{.closed_forms = [&] { return propose(budget); },
                            .since_start = range_only_start_.readings()};
  if (relocalizer_.isApplicable()) sources.trajectory = [&] { return relocalizer_.search(step_.modes, budget); };
  const bool was_ok = step_.verdict == Verdict::ok;
  step_ = filter_.process(frame, sources);
  step_.search_operations = budget.spent();
  step_.search_stopped = budget.exhausted();
  step_.detections_left_out += detectionCount(whole) - detectionCount(frame);
  if (step_.verdict != Verdict::ambiguous) range_only_start_.end();
  if (was_ok && step_.verdict != Verdict::ok) relocalizer_.resetInterval();
  return estimateFrom(step_, frame.time);
}

std::vector<LandmarkHistory> ParticleFilterLocalizer::landmarkHistories() const
{
  return filter_.reliability().histories();
}
}  // namespace mrpt_ext
