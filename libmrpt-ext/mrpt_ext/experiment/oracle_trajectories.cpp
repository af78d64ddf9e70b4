#include "mrpt_ext/experiment/oracle_tracks.h"

#include <algorithm>

#include "mrpt_ext/evaluation/scoring.h"

namespace mrpt_ext
{
void OracleTracks::add(const MethodTrajectory& method, const Estimate& estimate, double time)
{
  if (truth_.empty()) return;
  const std::string name = "oracle_" + method.name;
  auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.track.name == name; });
  if (entry != entries_.end()) entry->track.frames_offered = method.frames_offered;
  if (estimate.candidates.empty()) return;
  if (entry == entries_.end())
  {
    entry = entries_.insert(entries_.end(), {{.name = name, .continuous = method.continuous, .oracle = true}, false});
    entry->track.frames_offered = method.frames_offered;
  }
  entry->several = entry->several || estimate.candidates.size() > 1;
  const auto truth = interpolate(truth_, time, kMaxTruthGap);
  if (!truth) return;
  const auto distance = [&](const PoseHypothesis& h)
  { return (h.pose.mean.position() - truth->pose.position()).norm(); };
  const auto nearest = std::min_element(estimate.candidates.begin(), estimate.candidates.end(),
                                        [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  ++entry->track.frames_answered;
  entry->track.points.push_back({.time = time,
                                 .pose = nearest->pose,
                                 .heading_known = nearest->heading_known,
                                 .modes = static_cast<int>(estimate.candidates.size()),
                                 .best_weight = nearest->weight});
}

std::vector<MethodTrajectory> OracleTracks::take()
{
  std::vector<MethodTrajectory> tracks;
  for (Entry& entry : entries_)
    if (entry.several) tracks.push_back(std::move(entry.track));
  return tracks;
}
}  // namespace mrpt_ext
