#pragma once

#include <algorithm>
#include <vector>

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"

namespace mrpt_ext
{
/// How a landmark behaved under the posterior so far.
struct LandmarkHistory
{
  double seen = 0;         ///< identified detections of it, or expected number of unidentified ones
  double associated = 0;   ///< expected number that really were it
  double named = 0;        ///< identified detections of it
  double false_named = 0;  ///< expected number of those that were not it
  double residual_weight = 0, residual_sum = 0, residual_sum2 = 0;  ///< normalised residuals of the inliers
};

/// Learns, per landmark, which share of its detections is false, so that a lying beacon loses its say.
/// The share is the mean of a Beta posterior: the sensor's clutter probability counts like `prior_strength` detections
/// (at least one). Unidentified detections do not enter: a false one of them cannot be laid at one landmark's door.
class LandmarkReliability
{
 public:
  LandmarkReliability(std::size_t landmarks, double prior_strength, double max_clutter)
      : histories_(landmarks), prior_strength_(std::max(prior_strength, 1.0)), max_clutter_(max_clutter)
  {
  }

  /// Clutter probability of every landmark for a sensor with this prior clutter probability.
  [[nodiscard]] LandmarkClutter clutter(double sensor_clutter) const;

  /// Share of the reading's detections that landmarks explain, averaged over the posterior (normalised particles);
  /// with `learn`, the histories are updated too.
  double observe(const Reading& reading, const LandmarkTable& map, const ParticleSet& particles, bool learn,
                 unsigned threads = 1);

  [[nodiscard]] const std::vector<LandmarkHistory>& histories() const { return histories_; }

 private:
  std::vector<LandmarkHistory> histories_;
  double prior_strength_;
  double max_clutter_;
};
}  // namespace mrpt_ext
