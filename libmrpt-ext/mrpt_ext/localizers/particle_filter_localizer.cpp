#include "mrpt_ext/localizers/particle_filter_localizer.h"

#include "mrpt_ext/hypotheses/bias_inflation.h"

namespace mrpt_ext
{
namespace
{
// Of an interpretation tree where another proposal follows: before the start and, every half second, of a robot that is
// lost, whom the search along the way finds as well. It does not stand still for the search meanwhile.
constexpr std::uint64_t kFewNodes = 20'000;
}  // namespace

ParticleFilterLocalizer::ParticleFilterLocalizer(const ParticleFilterOptions& options, const LandmarkTable& map,
                                                 double seed_window, std::uint64_t seed, std::uint64_t stream,
                                                 std::shared_ptr<const GlobalPoseSearch> search)
    : map_(map),
      search_(search ? std::move(search) : std::make_shared<const GlobalPoseSearch>(map)),
      region_(options.region),
      biases_(options.biases),
      filter_(options, map, seed, stream),
      joiner_(seed_window, options.motion),
      history_(options.motion),
      way_(map, search_, options.region, options.motion)
{
}

Estimate ParticleFilterLocalizer::process(const Frame& frame)
{
  joiner_.add(frame);
  history_.add(frame);
  way_.add(frame);
  const auto propose = [&]
  {
    Frame joined = joiner_.joined();
    std::vector<Reading> readings = joined.readings;
    joined.readings = withBiasUncertainty(std::move(joined.readings), biases_);
    ProposalOptions options{.region = region_};
    if (!filter_.particles().empty() || !joiner_.full()) options.max_tree_nodes = kFewNodes;
    Proposal proposal(proposePoses(joined, map_, *search_, options));
    if (filter_.particles().empty() && joiner_.full())
    {
      const HypothesisSet along = way_.search({});
      proposal.hypotheses.insert(proposal.hypotheses.end(), along.begin(), along.end());
    }
    proposal.joined_readings = std::move(readings);
    proposal.complete = joiner_.full();
    return proposal;
  };
  const bool was_ok = step_.verdict == Verdict::ok;
  ParticleFilter::TrajectoryHypotheses along_way;
  if (way_.isApplicable()) along_way = [&] { return way_.search(step_.modes); };
  step_ = filter_.process(frame, propose, history_.readings(), along_way);
  if (step_.verdict != Verdict::ambiguous) history_.end();
  if (was_ok && step_.verdict != Verdict::ok) way_.resetInterval();
  return estimateFrom(step_, frame.time);
}

std::vector<LandmarkHistory> ParticleFilterLocalizer::landmarkHistories() const
{
  return filter_.reliability().histories();
}
}  // namespace mrpt_ext
