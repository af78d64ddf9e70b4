#pragma once

#include <vector>

#include "mrpt_ext/filter/integrity/independent_detections.h"
#include "mrpt_ext/filter/integrity/inlier_report.h"
#include "mrpt_ext/filter/integrity/landmark_reliability.h"
#include "mrpt_ext/filter/particles/particle_set.h"

namespace mrpt_ext
{
/// p(z_t | x_t) of a frame for all particles (likelihood/reading_scorer.h), with a clutter probability per landmark
/// that is learned from the inliers, and the choice of the detections that count.
class ObservationModel
{
 public:
  ObservationModel(const LandmarkTable& map, const MotionModel& motion, double reliability_prior_strength, bool learn,
                   unsigned threads);

  /// Forgets which detections were made.
  void restart() { decorrelator_.clear(); }
  /// The robot has moved.
  void move(const OdometryMotion& motion) { decorrelator_.move(motion); }
  /// The frame with the detections that count. While modes compete, no correlated anonymous bearings: many wrong poses
  /// fit them as well as the right one. Within one mode they tell how the robot turns.
  [[nodiscard]] Frame select(const Frame& frame, bool modes_compete);
  /// Adds the log-likelihood of the frame to the log weights.
  void weight(const Frame& frame, ParticleSet& particles) const;
  /// Inliers of the frame under the posterior (normalised particles). With `learn`, the clutter probabilities of the
  /// landmarks learn from them, if this model learns at all.
  InlierReport countInliers(const Frame& frame, const ParticleSet& particles, bool learn);

  [[nodiscard]] const LandmarkTable& map() const { return map_; }
  [[nodiscard]] const LandmarkReliability& reliability() const { return reliability_; }

 private:
  LandmarkTable map_;
  LandmarkReliability reliability_;
  DetectionDecorrelator decorrelator_;
  bool learns_;
  unsigned threads_;
};
}  // namespace mrpt_ext
