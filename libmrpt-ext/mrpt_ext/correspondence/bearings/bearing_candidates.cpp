#include "mrpt_ext/correspondence/bearings/bearing_candidates.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/correspondence/bearings/bearing_search.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kCapacity = 500000;  // proposals of one round that are kept
constexpr double kLargestFreedom = 0.5;    // of the range: how far a pose to be judged may be off
constexpr double kAreaMargin = 0.5;        // [m] a triple's pose may lie outside though the refined one does not
constexpr std::size_t kSampledLandmarks = 16;
constexpr int kSplits = 3;  // of a box of poses in which every reading may be explained in several ways
}  // namespace

BearingCandidates::BearingCandidates(const LandmarkIndex& map, std::span<const Scan> places,
                                     const PoseSearchOptions& options, std::span<const ScanBearing> readings,
                                     const BearingSearch& owner)
    : map_(map), places_(places), options_(options), readings_(readings)
{
  for (std::size_t p = 0; p < places_.size(); ++p)
  {
    std::vector<ScanBearing> own;
    for (const ScanBearing& r : readings_)
      if (r.place == static_cast<int>(p)) own.push_back(r);
    tables_.emplace_back(own, options_.gate);
    lists_.push_back(own.empty() ? nullptr : owner.listsFor(rangeLimit(places_[p])));
  }
  for (const ScanBearing& r : readings_) neighbours_.push_back(owner.neighboursOf(r.kind));
}

TripleRound BearingCandidates::roundOf(const ReadingTriple& triple) const
{
  const int place = readings_[static_cast<std::size_t>(triple.reading[0])].place;
  TripleRound round;
  round.map = &map_;
  round.readings = readings_;
  round.triple = triple;
  for (std::size_t n = 0; n < 2; ++n)
    round.neighbours[n] = neighbours_[static_cast<std::size_t>(triple.reading[n + 1])].get();
  round.views = viewsFrom(place, bitsOf(place, triple));
  round.max_range = rangeLimit(places_[static_cast<std::size_t>(place)]);
  round.gate = options_.gate;
  round.area = areaOfSensor(place);
  round.max_tested = options_.max_tested - std::min(options_.max_tested, work_.tested);
  return round;
}

int BearingCandidates::proposeFrom(const ReadingTriple& triple, int floor, int least)
{
  const int place = readings_[static_cast<std::size_t>(triple.reading[0])].place;
  const TripleRound round = roundOf(triple);
  ProposalStore store(floor, kCapacity);
  const TripleRound::Work work = round.run(store);
  ++work_.rounds;
  work_.tested += work.tested;
  finished_ = work.finished;
  possible_ += static_cast<double>(work.possible);
  ++rounds_;
  for (const PoseProposal& p : store.takeSorted()) refine(p.sensor, place, round.views, least);
  return store.floor();
}

void BearingCandidates::proposeFrom(std::span<const PanoramaHit> boxes, const PanoramaIndex& index, int place,
                                    int least)
{
  const std::vector<BoundingScan> views = viewsFrom(place, 0);
  for (const PanoramaHit& box : boxes) refineBox(poseOf(box, index, options_.gate), place, views, least, kSplits);
}

TripleEffort BearingCandidates::sampleEffort(const ReadingTriple& triple)
{
  const auto place = static_cast<std::size_t>(readings_[static_cast<std::size_t>(triple.reading[0])].place);
  const std::size_t stride = std::max<std::size_t>(1, map_.size() / kSampledLandmarks);
  const TripleRound::Work sample = roundOf(triple).sample(stride);
  const auto scale = static_cast<double>(stride);
  possible_ += scale * static_cast<double>(sample.possible);
  ++rounds_;
  return {scale * static_cast<double>(sample.tested), scale * static_cast<double>(sample.possible),
          lists_[place]->meanCount()};
}

std::vector<BoundingScan> BearingCandidates::viewsFrom(int place, std::uint32_t used) const
{
  const Pose2 T_tested_robot = inverse(places_[static_cast<std::size_t>(place)].T_robot_sensor);
  std::vector<BoundingScan> views;
  for (std::size_t p = 0; p < places_.size(); ++p)
    if (lists_[p])
    {
      BoundingScan& view = views.emplace_back();
      view.table = &tables_[p];
      view.lists = lists_[p].get();
      view.T_tested_sensor = compose(T_tested_robot, places_[p].T_robot_sensor);
      if (static_cast<int>(p) == place) view.used = used;
    }
  return views;
}

/// Bits of a triple's readings in the table of their place.
std::uint32_t BearingCandidates::bitsOf(int place, const ReadingTriple& triple) const
{
  std::uint32_t bits = 0;
  std::size_t position = 0;
  for (std::size_t r = 0; r < readings_.size(); ++r)
  {
    if (readings_[r].place != place) continue;
    const bool used =
        std::find(triple.reading.begin(), triple.reading.end(), static_cast<int>(r)) != triple.reading.end();
    if (used && position < ReadingTable::kMaxReadings) bits |= 1U << position;
    ++position;
  }
  return bits;
}

std::optional<Box2> BearingCandidates::areaOfSensor(int place) const
{
  if (!options_.area) return std::nullopt;
  const double margin = kAreaMargin + places_[static_cast<std::size_t>(place)].T_robot_sensor.position().norm();
  return Box2{options_.area->min - Vector2d::Constant(margin), options_.area->max + Vector2d::Constant(margin)};
}

void BearingCandidates::refine(const GaussianPose& sensor, int place, std::span<const BoundingScan> views, int least)
{
  const RefinedPose tight = refineOnInliers(sensor, views, options_.gate, least, scratch_);
  if (tight.explained >= least) wait(tight, place);
}

/// A box in which too many readings can be explained in several ways, or in which some were explained in a wrong way,
/// is split into eight until they cannot.
void BearingCandidates::refineBox(const GaussianPose& sensor, int place, std::span<const BoundingScan> views, int least,
                                  int splits)
{
  if (boundOfBox(sensor, views.front(), options_.gate) < least) return;
  const RefinedPose tight = refineOnInliers(sensor, views, options_.gate, least, scratch_);
  if (!tight.plausible) return;
  const bool explained = tight.explained >= least;
  if (explained && (tight.refined || splits == 0)) return wait(tight, place);
  if (splits == 0) return;
  // A quarter of the box's extent, as poseOf made the deviations of it.
  const Vector3d reach = options_.gate * sensor.covariance.diagonal().cwiseSqrt();
  const Vector3d quarter(reach.x() / 4, reach.y() / 4, reach.z() / std::sqrt(8.0));
  for (int part = 0; part < 8; ++part)
  {
    const auto side = [&](int bit) { return (part >> bit & 1) != 0 ? 1.0 : -1.0; };
    GaussianPose eighth{sensor.mean, sensor.covariance / 4};
    eighth.mean.x += side(0) * quarter.x();
    eighth.mean.y += side(1) * quarter.y();
    eighth.mean.phi = wrap(eighth.mean.phi + side(2) * quarter.z());
    refineBox(eighth, place, views, least, splits - 1);
  }
}

void BearingCandidates::wait(const RefinedPose& tight, int place)
{
  if (!isFixed(tight.sensor, place)) return;
  const Pose2 T_sensor_robot = inverse(places_[static_cast<std::size_t>(place)].T_robot_sensor);
  const auto level = static_cast<std::size_t>(tight.explained);
  if (waiting_.size() <= level) waiting_.resize(level + 1);
  waiting_[level].push_back(compound(tight.sensor, T_sensor_robot));
}

/// False for a pose that is so much free to move that everything in sight would explain its readings.
bool BearingCandidates::isFixed(const GaussianPose& sensor, int place) const
{
  const double reach =
      std::min(rangeLimit(places_[static_cast<std::size_t>(place)]), (map_.high() - map_.low()).norm());
  return options_.gate * std::sqrt(sensor.covariance.topLeftCorner<2, 2>().trace()) < kLargestFreedom * reach;
}
}  // namespace mrpt_ext
