#include "mrpt_ext/hypotheses/propose_from_association.h"

#include <algorithm>

#include "mrpt_ext/correspondence/tree/tree_input.h"
#include "mrpt_ext/hypotheses/scans.h"
#include "mrpt_ext/hypotheses/window_readings.h"
#include "mrpt_ext/hypotheses/window_scans.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kSource = "interpretation_tree";
constexpr std::size_t kEnoughPoints = 3;  // of a local map, to be searched without the bearings left over
constexpr double kGate = 3.3;             // standard deviations
}  // namespace

AssociationProposals proposeFromAssociation(std::span<const Reading> readings, const LandmarkTable& map,
                                            const GlobalPoseSearch& search, const PoseRegion& region,
                                            const PoseSearchOptions& limits)
{
  WorkBudget own = search.budget();
  PoseSearchOptions options = limits;
  if (options.budget == nullptr) options.budget = &own;
  std::vector<Scan> scans = windowScans(readings, map, search.index(), *options.budget);
  if (scans.empty()) return {};
  // With a local map of enough points, the detections left over are mostly clutter, repeated in many scans.
  const auto is_point = [](const AnonymousDetection& d) { return d.bearing && d.range; };
  const auto& points = scans.front().detections;
  if (isWindow(readings) && points.size() >= kEnoughPoints && std::all_of(points.begin(), points.end(), is_point))
    scans.resize(1);
  options.gate = kGate;
  options.area = Box2{region.low, region.low + region.extent()};
  const PoseSearchResult found = search.search(scans, options);

  AssociationProposals result{.status = found.status, .unique = found.unique};
  for (const ConsistentPose& pose : found.poses)
    if (region.contains(pose.pose.mean))
      result.hypotheses.push_back(
          {.pose = pose.pose, .log_score = pose.log_evidence, .weight = pose.probability, .source = kSource});
  if (result.hypotheses.empty() && result.status == SolveStatus::ok) result.status = SolveStatus::none;
  return result;
}

HypothesisSet proposeFromThreeBearings(std::span<const Reading> readings, const LandmarkTable& map,
                                       const GlobalPoseSearch& search, const PoseRegion& region,
                                       const PoseSearchOptions& limits)
{
  const LandmarkIndex& index = search.index();
  if (index.size() > kLargestTreeMap) return {};
  const std::vector<Scan> scans = scansOf(readings, map, index);
  const TreeInput input = scanWithMostBearings(index, scans);
  const std::size_t count = input.bearings.size();
  if (count < 3 || count > 4) return {};

  InterpretationOptions options =
      treeOptions(input, {.gate = kGate, .area = Box2{region.low, region.low + region.extent()}});
  options.allow_three = true;
  options.max_unmatched = static_cast<int>(count) - 3;
  options.max_tested = InterpretationOptions{}.max_tested;
  options.budget = limits.budget;
  HypothesisSet hypotheses;
  for (const Interpretation& interpretation : interpretBearings(index.positions(), input.bearings, options).solutions)
  {
    PoseHypothesis h{.pose = robotPose(interpretation.pose, input.scan->T_robot_sensor),
                     .log_score = interpretation.log_likelihood,
                     .source = kSource};
    if (region.contains(h.pose.mean)) hypotheses.push_back(std::move(h));
  }
  return hypotheses;
}
}  // namespace mrpt_ext
