#include "mrpt_ext/correspondence/bearings/bearing_candidates.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kCapacity = 500000;  // poses of one round that are kept
constexpr double kLargestFreedom = 0.5;    // of the range: largest position uncertainty of a candidate
constexpr double kAreaMargin = 0.5;        // [m] a triple's pose may be outside though the refined one is not
constexpr std::size_t kSampledLandmarks = 16;
constexpr double kSampleShare = 0.05;                            // of the work, at most
constexpr int kSplits = 3;                                       // of a box of poses whose associations are ambiguous
constexpr double kCostOfBoxBound = 200, kCostOfBoxLandmark = 2;  // operations: of a box, for each landmark in view
}  // namespace

BearingCandidates::BearingCandidates(const LandmarkIndex& map, std::span<const Scan> scans,
                                     const PoseSearchOptions& options, std::span<const ScanBearing> bearings,
                                     const BearingSearchTables& tables, WorkBudget& budget)
    : map_(map), scans_(scans), options_(options), bearings_(bearings), budget_(budget)
{
  for (std::size_t p = 0; p < scans_.size(); ++p)
  {
    std::vector<ScanBearing> own;
    for (const ScanBearing& r : bearings_)
      if (r.scan == static_cast<int>(p)) own.push_back(r);
    tables_.emplace_back(own, options_.gate);
    visible_sets_.push_back(own.empty() ? nullptr : tables.visibleSets(rangeLimit(scans_[p])));
  }
  for (const ScanBearing& r : bearings_) neighbours_.push_back(tables.neighboursOf(r.category));
  double in_view = 0;
  for (const auto& sets : visible_sets_) in_view += sets ? sets->meanCount() : 0;
  cost_of_bound_ = static_cast<std::uint64_t>(kCostOfBoxBound + kCostOfBoxLandmark * in_view);
}

TripleHypotheses BearingCandidates::hypothesesOf(const DetectionTriple& triple) const
{
  const int scan = bearings_[static_cast<std::size_t>(triple.detection[0])].scan;
  TripleHypotheses hypotheses;
  hypotheses.map = &map_;
  hypotheses.bearings = bearings_;
  hypotheses.triple = triple;
  for (std::size_t n = 0; n < 2; ++n)
    hypotheses.neighbours[n] = neighbours_[static_cast<std::size_t>(triple.detection[n + 1])].get();
  hypotheses.scans = scansFrom(scan, bitsOf(scan, triple));
  hypotheses.max_range = rangeLimit(scans_[static_cast<std::size_t>(scan)]);
  hypotheses.gate = options_.gate;
  hypotheses.area = areaOfSensor(scan);
  hypotheses.budget = &budget_;
  return hypotheses;
}

int BearingCandidates::propose(const DetectionTriple& triple, int floor, int least)
{
  const int scan = bearings_[static_cast<std::size_t>(triple.detection[0])].scan;
  const TripleHypotheses hypotheses = hypothesesOf(triple);
  ProposalStore store(floor, kCapacity);
  const TripleHypotheses::Work work = hypotheses.run(store);
  ++work_.rounds;
  work_.tested += work.tested;
  possible_ += static_cast<double>(work.possible);
  ++rounds_;
  for (const PoseProposal& p : store.takeSorted())
  {
    if (budget_.exhausted()) break;
    refine(p.sensor, scan, hypotheses.scans, least);
  }
  return store.floor();
}

void BearingCandidates::propose(std::span<const PoseBox> boxes, const VisibilityGrid& index, int scan, int least)
{
  const std::vector<BoundingScan> scans = scansFrom(scan, 0);
  for (const PoseBox& box : boxes)
  {
    if (budget_.exhausted()) break;
    refineBox(poseOf(box, index, options_.gate), scan, scans, least, kSplits);
  }
}

TripleEffort BearingCandidates::sampleEffort(const DetectionTriple& triple)
{
  const auto scan = static_cast<std::size_t>(bearings_[static_cast<std::size_t>(triple.detection[0])].scan);
  const std::size_t stride = std::max<std::size_t>(1, map_.size() / kSampledLandmarks);
  TripleHypotheses hypotheses = hypothesesOf(triple);
  WorkBudget some(budget_, kSampleShare);
  hypotheses.budget = &some;
  const TripleHypotheses::Work sample = hypotheses.sample(stride);
  const double scale = static_cast<double>(map_.size()) / static_cast<double>(std::max<std::size_t>(1, sample.middles));
  possible_ += scale * static_cast<double>(sample.possible);
  ++rounds_;
  return {scale * static_cast<double>(sample.tested), scale * static_cast<double>(sample.possible),
          visible_sets_[scan]->meanCount()};
}

std::vector<BoundingScan> BearingCandidates::scansFrom(int scan, std::uint32_t used) const
{
  const Pose2 T_tested_robot = inverse(scans_[static_cast<std::size_t>(scan)].T_robot_sensor);
  std::vector<BoundingScan> bounding;
  for (std::size_t s = 0; s < scans_.size(); ++s)
    if (visible_sets_[s])
    {
      BoundingScan& other = bounding.emplace_back();
      other.table = &tables_[s];
      other.visible_sets = visible_sets_[s].get();
      other.T_tested_sensor = compose(T_tested_robot, scans_[s].T_robot_sensor);
      if (static_cast<int>(s) == scan) other.used = used;
    }
  return bounding;
}

/// Bits of a triple's bearings in the direction table of their scan.
std::uint32_t BearingCandidates::bitsOf(int scan, const DetectionTriple& triple) const
{
  std::uint32_t bits = 0;
  std::size_t position = 0;
  for (std::size_t r = 0; r < bearings_.size(); ++r)
  {
    if (bearings_[r].scan != scan) continue;
    const bool used =
        std::find(triple.detection.begin(), triple.detection.end(), static_cast<int>(r)) != triple.detection.end();
    if (used && position < DirectionTable::kMaxBearings) bits |= 1U << position;
    ++position;
  }
  return bits;
}

std::optional<Box2> BearingCandidates::areaOfSensor(int scan) const
{
  if (!options_.area) return std::nullopt;
  const double margin = kAreaMargin + scans_[static_cast<std::size_t>(scan)].T_robot_sensor.position().norm();
  return Box2{options_.area->min - Vector2d::Constant(margin), options_.area->max + Vector2d::Constant(margin)};
}

void BearingCandidates::refine(const GaussianPose& sensor, int scan, std::span<const BoundingScan> scans, int least)
{
  const RefinedPose refined_pose = refineOnInliers(sensor, scans, options_.gate, least, scratch_);
  budget_.spend(refined_pose.operations);
  if (refined_pose.inliers >= least) addPending(refined_pose, scan);
}

/// Splits a box into eight while too many of its bearings have several possible landmarks, or some a wrong one.
void BearingCandidates::refineBox(const GaussianPose& sensor, int scan, std::span<const BoundingScan> scans, int least,
                                  int splits)
{
  if (!budget_.spend(cost_of_bound_)) return;
  WorkCounter::add(cost_of_bound_);
  if (boundOfBox(sensor, scans.front(), options_.gate) < least) return;
  const RefinedPose refined_pose = refineOnInliers(sensor, scans, options_.gate, least, scratch_);
  budget_.spend(refined_pose.operations);
  if (!refined_pose.enough_at_start) return;
  const bool inliers = refined_pose.inliers >= least;
  if (inliers && (refined_pose.refined || splits == 0)) return addPending(refined_pose, scan);
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
    refineBox(eighth, scan, scans, least, splits - 1);
  }
}

void BearingCandidates::addPending(const RefinedPose& refined_pose, int scan)
{
  if (!isFixed(refined_pose.sensor, scan)) return;
  const Pose2 T_sensor_robot = inverse(scans_[static_cast<std::size_t>(scan)].T_robot_sensor);
  const auto level = static_cast<std::size_t>(refined_pose.inliers);
  if (pending_.size() <= level) pending_.resize(level + 1);
  pending_[level].push_back(compound(refined_pose.sensor, T_sensor_robot));
}

/// False for a pose so uncertain that any landmark in view would match its bearings.
bool BearingCandidates::isFixed(const GaussianPose& sensor, int scan) const
{
  const double reach = std::min(rangeLimit(scans_[static_cast<std::size_t>(scan)]), (map_.high() - map_.low()).norm());
  return options_.gate * std::sqrt(sensor.covariance.topLeftCorner<2, 2>().trace()) < kLargestFreedom * reach;
}
}  // namespace mrpt_ext
