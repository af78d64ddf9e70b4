#pragma once

#include <algorithm>
#include <vector>

#include "mrpt_ext/filter/integrity/outlier_memory.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"

namespace mrpt_ext
{
/// Statistics of one landmark under the posterior so far.
struct LandmarkHistory
{
  double seen = 0;              ///< identified detections of it, or expected number of anonymous ones
  double associated = 0;        ///< expected number of inliers among them
  double identified = 0;        ///< identified detections of it
  double false_identified = 0;  ///< expected number of outliers among those
  double residual_weight = 0, residual_sum = 0, residual_sum2 = 0;  ///< normalised residuals of the inliers
};

/// Learns, per landmark, which share of its detections is clutter, so that a faulty beacon loses its influence.
/// The share is the mean of a Beta posterior: the sensor's clutter probability counts like `prior_strength` detections
/// (at least one). Anonymous detections do not enter: a false one belongs to no particular landmark.
class LandmarkReliability
{
 public:
  LandmarkReliability(std::size_t landmarks, double prior_strength)
      : histories_(landmarks), memory_(landmarks), prior_strength_(std::max(prior_strength, 1.0))
  {
  }

  /// Clutter probability of every landmark for a sensor with this prior clutter probability; at most 0.7, or the
  /// sensor's own if that is more.
  [[nodiscard]] LandmarkClutter clutter(double sensor_clutter) const;
  /// ... for this reading, with the bursts of outliers that last.
  [[nodiscard]] LandmarkClutter clutter(const Reading& reading) const;

  /// Inlier ratio of the reading's detections, averaged over the posterior (normalised particles); with `learn`, the
  /// histories are updated too.
  double observe(const Reading& reading, const LandmarkTable& map, const ParticleSet& particles, bool learn,
                 unsigned threads = 1);

  [[nodiscard]] const std::vector<LandmarkHistory>& histories() const { return histories_; }

 private:
  void remember(const Reading& reading, const LandmarkTable& map, const LandmarkClutter& shares,
                const std::vector<double>& outliers);

  std::vector<LandmarkHistory> histories_;
  OutlierMemory memory_;
  double prior_strength_;
};
}  // namespace mrpt_ext
