#include "mrpt_ext/filter/observation_model.h"

#include "mrpt_ext/filter/integrity/sensor_monitors.h"
#include "mrpt_ext/filter/particles/particle_blocks.h"
#include "mrpt_ext/likelihood/compass_likelihood.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/facing_likelihood.h"
#include "mrpt_ext/likelihood/reading_scorer.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
ObservationModel::ObservationModel(const LandmarkTable& map, const MotionModel& motion,
                                   double reliability_prior_strength, bool learn, unsigned threads)
    : map_(map),
      reliability_(map.size(), reliability_prior_strength),
      decorrelator_(motion, map),
      learns_(learn),
      threads_(threads)
{
}

Frame ObservationModel::select(const Frame& frame, bool modes_compete)
{
  Frame selected = frame;
  for (Reading& reading : selected.readings) reading = decorrelator_.withoutCorrelatedBearings(reading);
  if (!modes_compete) selected.readings = frame.readings;
  return selected;
}

void ObservationModel::weight(const Frame& frame, ParticleSet& particles) const
{
  for (const Reading& reading : scoredReadings(frame))
  {
    const LandmarkClutter clutter = learns_ ? reliability_.clutter(reading) : LandmarkClutter{};
    const ReadingScorer scorer(reading, map_, clutter, particles.origin);
    const PoseBatch poses = particles.poses();
    const std::span<float> log_weight = particles.log_weight;
    forEachBlock(particles.size(), threads_,
                 [&](std::size_t first, std::size_t count)
                 { scorer.addTo(poses.block(first, count), log_weight.subspan(first, count)); });
    addFacingLogLikelihood(reading, map_, poses, log_weight);
  }
  if (frame.compass) addCompassLogLikelihood(*frame.compass, particles.poses(), particles.log_weight);
}

InlierReport ObservationModel::countInliers(const Frame& frame, const ParticleSet& particles, bool learn)
{
  InlierReport report;
  for (const Reading& reading : scoredReadings(frame))
  {
    const double ratio = reliability_.observe(reading, map_, particles, learns_ && learn, threads_);
    const LandmarkClutter clutter = reliability_.clutter(reading.model.clutter_probability);
    SensorInliers counts{.sensor = sensorKey(reading),
                         .inliers = ratio * static_cast<double>(reading.detections.size())};
    for (const Detection& detection : reading.detections)
    {
      if (!mayShowAny(detection, map_)) continue;  // not in the map: an inlier of no pose
      const auto known = map_.indexOf(detection.id);
      counts.expected += 1 - (known ? clutter[*known] : reading.model.clutter_probability);
      counts.expected_by_sensor += 1 - reading.model.clutter_probability;
      ++counts.detections;
    }
    report.push_back(std::move(counts));
  }
  return report;
}
}  // namespace mrpt_ext
