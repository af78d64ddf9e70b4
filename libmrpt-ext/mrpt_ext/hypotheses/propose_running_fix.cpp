#include <cmath>

#include "mrpt_ext/hypotheses/pose_proposals.h"

namespace mrpt_ext
{
std::vector<HeadingPrior> headingsToTry(const std::optional<CompassRecord>& compass, std::size_t points)
{
  if (compass) return {{compass->heading, compass->std_heading}};
  const double spacing = kTwoPi / static_cast<double>(points);
  std::vector<HeadingPrior> headings;
  for (std::size_t k = 0; k < points; ++k) headings.push_back({wrap(spacing * static_cast<double>(k)), spacing / 2});
  return headings;
}

HypothesisSet proposeFromRunningFixes(const Frame& frame, const LandmarkTable& map, std::size_t points)
{
  const std::vector<HeadingPrior> headings = headingsToTry(frame.compass, points);
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
