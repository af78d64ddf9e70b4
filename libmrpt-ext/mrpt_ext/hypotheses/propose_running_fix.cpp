#include <cmath>

#include "mrpt_ext/hypotheses/pose_proposals.h"
#include "mrpt_ext/solvers/running_fix_pose.h"

namespace mrpt_ext
{
HypothesisSet proposeFromRunningFixes(const Frame& frame, const LandmarkTable& map, std::size_t points)
{
  std::vector<HeadingPrior> headings;
  if (frame.compass)
    headings.push_back({frame.compass->heading, frame.compass->std_heading});
  else
    for (std::size_t k = 0; k < points; ++k)
    {
      const double spacing = kTwoPi / static_cast<double>(points);
      headings.push_back({wrap(spacing * static_cast<double>(k)), spacing / 2});
    }
  HypothesisSet result;
  for (RunningFixReading fix : frame.fixes)
  {
    const auto known = map.indexOf(fix.id);
    if (!known || !reduceToHorizontal(fix, map[*known].position.z())) continue;
    for (const HeadingPrior& heading : headings)
      for (const RunningFixPose& candidate : runningFixPoses(fix, map[*known].position.head<2>(), heading).candidates)
        result.push_back({.pose = candidate.pose, .source = "running_fix"});
  }
  return result;
}
}  // namespace mrpt_ext
