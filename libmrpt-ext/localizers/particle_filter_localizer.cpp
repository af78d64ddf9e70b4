#include "mrpt_ext/localizers/particle_filter_localizer.h"

#include <algorithm>

#include "mrpt_ext/hypotheses/expected_errors.h"
#include "mrpt_ext/hypotheses/travel_search.h"
#include "mrpt_ext/localizers/travel_looks.h"

namespace mrpt_ext
{
namespace
{
constexpr double kTravelled = 45, kLook = 1;  // [s] of the way that is searched, and of what makes one look
constexpr double kBetweenSearches = 5;        // [s] they are costly

bool isNameless(const Reading& reading)
{
  return std::any_of(reading.detections.begin(), reading.detections.end(),
                     [](const Detection& d) { return d.id == kNoId; });
}
}  // namespace

ParticleFilterLocalizer::ParticleFilterLocalizer(const ParticleFilterOptions& options, const LandmarkTable& map,
                                                 double seed_window, std::uint64_t seed, std::uint64_t stream,
                                                 std::shared_ptr<const LostRobotSearch> search)
    : map_(map),
      search_(search ? std::move(search) : std::make_shared<const LostRobotSearch>(map)),
      region_(options.region),
      biases_(options.biases),
      filter_(options, map, seed, stream),
      joiner_(seed_window, options.motion),
      history_(options.motion),
      motion_(options.motion)
{
}

Estimate ParticleFilterLocalizer::process(const Frame& frame)
{
  joiner_.add(frame);
  history_.add(frame);
  remember(frame);
  const auto propose = [&]
  {
    Frame joined = joiner_.joined();
    std::vector<Reading> readings = joined.readings;
    joined.readings = withExpectedErrors(std::move(joined.readings), biases_);
    Proposal proposal(proposePoses(joined, map_, *search_, {.region = region_}));
    const HypothesisSet along = proposeAlongWay();
    proposal.hypotheses.insert(proposal.hypotheses.end(), along.begin(), along.end());
    proposal.joined_readings = std::move(readings);
    proposal.complete = joiner_.full();
    return proposal;
  };
  step_ = filter_.process(frame, propose, history_.readings());
  if (step_.verdict != Verdict::ambiguous) history_.end();
  return estimateFrom(step_, frame.time);
}

void ParticleFilterLocalizer::remember(const Frame& frame)
{
  const bool nameless = std::any_of(frame.readings.begin(), frame.readings.end(), isNameless);
  if (!nameless && recent_.empty()) return;
  recent_.push_back(frame);
  const auto kept = std::find_if(recent_.begin(), recent_.end(),
                                 [&](const Frame& old) { return frame.time - old.time <= kTravelled; });
  recent_.erase(recent_.begin(), kept);
}

HypothesisSet ParticleFilterLocalizer::proposeAlongWay()
{
  if (recent_.empty() || recent_.back().time - searched_at_ < kBetweenSearches) return {};
  searched_at_ = recent_.back().time;
  std::vector<Frame> way = recent_;
  way.front().motion = {};
  return searchAlongWay(travelLooks(way, motion_, map_, search_->index(), kLook), *search_, region_).hypotheses;
}

std::vector<LandmarkHistory> ParticleFilterLocalizer::landmarkHistories() const
{
  return filter_.reliability().histories();
}
}  // namespace mrpt_ext
