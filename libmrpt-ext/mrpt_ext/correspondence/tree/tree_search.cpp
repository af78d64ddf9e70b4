#include "mrpt_ext/correspondence/tree/tree_search.h"

#include <algorithm>
#include <limits>

#include "mrpt_ext/correspondence/false_alarms_bearings.h"
#include "mrpt_ext/correspondence/pose_verification.h"
#include "mrpt_ext/correspondence/tree/interpretation_tree.h"
#include "mrpt_ext/correspondence/tree/tree_input.h"
#include "mrpt_ext/correspondence/unsearched_evidence.h"

namespace mrpt_ext
{
namespace
{
constexpr int kLeastMatches = 4;          // three bearings are explained by every constellation
constexpr double kPosesPerTriple = 0.25;  // share of landmark triples that can be seen so from within the map

void judgeAll(const Interpretations& found, const LandmarkIndex& map, std::span<const Scan> places,
              const PoseSearchOptions& options, const TreeInput& question, PoseSearchResult& search)
{
  search.poses.clear();
  for (const Interpretation& interpretation : found.solutions)
  {
    const GaussianPose robot = robotPose(interpretation.pose, question.place->T_robot_sensor);
    if (auto pose = verifyPose(map, places, options, robot, kLeastMatches)) search.poses.push_back(std::move(*pose));
  }
  search.work.judged += found.solutions.size();
  for (const std::uint64_t tested : found.tested_by_depth) search.work.tested += tested;
  search.finished = found.finished;
}

FalseAlarmModel chanceMatches(const LandmarkIndex& map, const TreeInput& question, double gate)
{
  const auto n = static_cast<double>(map.size());
  double allowed = 0;
  for (const AnonymousBearing& b : question.bearings)
    allowed += (b.candidates.empty() ? n : static_cast<double>(b.candidates.size())) /
               static_cast<double>(question.bearings.size());
  return {kPosesPerTriple * allowed * std::max(0.0, allowed - 1) * std::max(0.0, allowed - 2),
          static_cast<int>(question.bearings.size()),
          chanceOfMatch(gate * question.std_bearing, std::max(0.0, allowed - 3))};
}
}  // namespace

PoseSearchResult searchByTree(const LandmarkIndex& map, std::span<const Scan> places, const PoseSearchOptions& options)
{
  PoseSearchResult search;
  const TreeInput question = scanWithMostBearings(map, places);
  const int count = static_cast<int>(question.bearings.size());
  if (count < kLeastMatches) return search;

  InterpretationOptions tree = treeOptions(question, options);
  int unmatched = 0;
  for (int found_at = count; unmatched <= std::min(found_at + 1, count - kLeastMatches); ++unmatched)
  {
    tree.max_unmatched = unmatched;
    const Interpretations found = interpretBearings(map.positions(), question.bearings, tree);
    if (found.status == SolveStatus::bad_input)
    {
      search.status = found.status;
      return search;
    }
    const bool better = found.finished || search.poses.empty();
    if (better) judgeAll(found, map, places, options, question, search);
    search.finished = found.finished;
    ++search.work.rounds;
    if (!found.finished) break;
    if (!search.poses.empty()) found_at = std::min(found_at, unmatched);
  }
  const int searched = count - unmatched + 1;
  double missed = -std::numeric_limits<double>::infinity();
  if (!search.poses.empty())
  {
    const auto best = std::max_element(search.poses.begin(), search.poses.end(),
                                       [](const ConsistentPose& a, const ConsistentPose& b)
                                       { return a.log_evidence < b.log_evidence; });
    const FalseAlarmModel chance = chanceMatches(map, question, options.gate);
    const int matched = std::min(best->matched, count);
    missed = logEvidenceOfUnsearched(map, places, areaOrMap(map, options.area), searched);
    search.expected_false = expectedFalsePoses(chance, matched);
  }
  rankPoses(search, options, missed, searched);
  return search;
}
}  // namespace mrpt_ext
