// How a ParticleFilter judges itself.
#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
void ParticleFilter::checkAgreement(const Frame& frame, bool learn)
{
  double explained = 0, expected = 0, promised = 0;
  std::size_t detections = 0;
  for (const Reading& reading : scoredReadings(frame))
  {
    const double share = reliability_.observe(reading, map_, particles_, options_.learn_reliability && learn);
    explained += share * static_cast<double>(reading.detections.size());
    const LandmarkClutter clutter = reliability_.clutter(reading.model.clutter_probability);
    for (const Detection& detection : reading.detections)
    {
      if (!mayShowAny(detection, map_)) continue;  // not in the map: no pose could explain it
      const auto known = map_.indexOf(detection.id);
      expected += 1 - (known ? clutter[*known] : reading.model.clutter_probability);
      promised += 1 - reading.model.clutter_probability;
      ++detections;
    }
  }
  if (detections == 0) return;
  const auto count = static_cast<double>(detections);
  monitor_.observe(explained / count, expected / count, detections);
  trust_.observe(explained / count, promised / count, detections);
  surprise_.observe(explained / count, promised / count, detections);
}

VerdictWithReason ParticleFilter::judgeStep(const FilterStep& step) const
{
  const double effective = step.effective_ratio * static_cast<double>(particles_.size());
  const bool surprised = surprise_.suspicious() || monitor_.suspicious();
  const double share = surprised ? std::min(surprise_.average(), monitor_.average()) : trust_.average();
  return judge(step.modes, {share, monitor_.lost(), effective}, options_.verdict);
}
}  // namespace mrpt_ext
