#include "mrpt_ext/experiment/oracle_trajectories.h"

#include <algorithm>

#include "mrpt_ext/evaluation/scoring.h"

namespace mrpt_ext
{
void OracleTrajectories::add(const MethodTrajectory& method, const Estimate& estimate, double time)
{
  if (truth_.empty()) return;
  const std::string name = "oracle_" + method.name;
  auto entry =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.trajectory.name == name; });
  if (entry != entries_.end()) entry->trajectory.frames_offered = method.frames_offered;
  if (estimate.candidates.empty()) return;
  if (entry == entries_.end())
  {
    entry = entries_.insert(entries_.end(), {{.name = name, .continuous = method.continuous, .oracle = true}, false});
    entry->trajectory.frames_offered = method.frames_offered;
  }
  entry->several = entry->several || estimate.candidates.size() > 1;
  const auto truth = interpolate(truth_, time, kMaxTruthGap);
  if (!truth) return;
  const auto distance = [&](const PoseHypothesis& h)
  { return (h.pose.mean.position() - truth->pose.position()).norm(); };
  const auto nearest = std::min_element(estimate.candidates.begin(), estimate.candidates.end(),
                                        [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  ++entry->trajectory.frames_answered;
  entry->trajectory.points.push_back({.time = time,
                                      .pose = nearest->pose,
                                      .heading_known = nearest->heading_known,
                                      .modes = static_cast<int>(estimate.candidates.size()),
                                      .best_weight = nearest->weight});
}

std::vector<MethodTrajectory> OracleTrajectories::take()
{
  std::vector<MethodTrajectory> trajectories;
  for (Entry& entry : entries_)
    if (entry.several) trajectories.push_back(std::move(entry.trajectory));
  return trajectories;
}
}  // namespace mrpt_ext
