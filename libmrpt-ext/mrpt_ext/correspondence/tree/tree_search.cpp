#include "mrpt_ext/correspondence/tree/tree_search.h"

#include <algorithm>
#include <limits>

#include "mrpt_ext/correspondence/false_alarms_bearings.h"
#include "mrpt_ext/correspondence/pose_verification.h"
#include "mrpt_ext/correspondence/search_input.h"
#include "mrpt_ext/correspondence/tree/interpretation_tree.h"
#include "mrpt_ext/correspondence/tree/tree_input.h"
#include "mrpt_ext/correspondence/unsearched_evidence.h"

namespace mrpt_ext
{
namespace
{
constexpr double kPosesPerTriple = 0.25;  // share of landmark triples that can be seen so from within the map

void verifyAll(const Interpretations& found, const LandmarkIndex& map, std::span<const Scan> scans,
               const PoseSearchOptions& options, const TreeInput& input, PoseSearchResult& search)
{
  search.poses.clear();
  for (const Interpretation& interpretation : found.solutions)
  {
    if (options.budget != nullptr && options.budget->exhausted()) break;
    const GaussianPose robot = robotPose(interpretation.pose, input.scan->T_robot_sensor);
    if (auto pose = verifyPose(map, scans, options, robot, kLeastMatches)) search.poses.push_back(std::move(*pose));
  }
  search.work.verified += found.solutions.size();
  for (const std::uint64_t tested : found.tested_by_depth) search.work.tested += tested;
  search.finished = found.finished;
}

BearingFalseAlarmModel falseAlarmModel(const LandmarkIndex& map, const TreeInput& input, double gate)
{
  const auto n = static_cast<double>(map.size());
  double allowed = 0;
  for (const AnonymousBearing& b : input.bearings)
    allowed += (b.candidates.empty() ? n : static_cast<double>(b.candidates.size())) /
               static_cast<double>(input.bearings.size());
  return {kPosesPerTriple * allowed * std::max(0.0, allowed - 1) * std::max(0.0, allowed - 2),
          static_cast<int>(input.bearings.size()),
          chanceMatchProbability(gate * input.std_bearing, std::max(0.0, allowed - 3))};
}
}  // namespace

PoseSearchResult searchByTree(const LandmarkIndex& map, std::span<const Scan> scans, const PoseSearchOptions& options)
{
  PoseSearchResult search;
  const TreeInput input = scanWithMostBearings(map, scans);
  const int count = static_cast<int>(input.bearings.size());
  if (count < kLeastMatches) return search;

  InterpretationOptions tree = treeOptions(input, options);
  int unmatched = 0;
  for (int found_at = count; unmatched <= std::min(found_at + 1, count - kLeastMatches); ++unmatched)
  {
    tree.max_unmatched = unmatched;
    const Interpretations found = interpretBearings(map.positions(), input.bearings, tree);
    if (found.status == SolveStatus::bad_input)
    {
      search.status = found.status;
      return search;
    }
    const bool better = found.finished || search.poses.empty();
    if (better) verifyAll(found, map, scans, options, input, search);
    search.finished = found.finished && (options.budget == nullptr || !options.budget->exhausted());
    ++search.work.rounds;
    if (!search.finished) break;
    if (!search.poses.empty()) found_at = std::min(found_at, unmatched);
  }
  const int searched = count - unmatched + 1;
  double missed = -std::numeric_limits<double>::infinity();
  if (!search.poses.empty())
  {
    const auto best = std::max_element(search.poses.begin(), search.poses.end(),
                                       [](const ConsistentPose& a, const ConsistentPose& b)
                                       { return a.log_evidence < b.log_evidence; });
    const BearingFalseAlarmModel false_alarms = falseAlarmModel(map, input, options.gate);
    const int matched = std::min(best->matched, count);
    missed = logEvidenceOfUnsearched(map, scans, areaOrMap(map, options.area), searched);
    search.expected_false = expectedFalsePoses(false_alarms, matched);
  }
  rankPoses(search, options, missed, searched);
  search.unique = search.unique && search.finished;
  return search;
}
}  // namespace mrpt_ext
