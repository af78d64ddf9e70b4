#pragma once

#include <optional>

#include "mrpt_ext/filter/integrity/filter_verdict.h"
#include "mrpt_ext/filter/integrity/recovery_options.h"
#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/filter/particles/kld_size.h"
#include "mrpt_ext/filter/particles/resampling.h"
#include "mrpt_ext/hypotheses/pose_region.h"

namespace mrpt_ext
{
/// How the first particles are drawn.
enum class InitialMode
{
  analytic,  ///< from a mixture of the uniform prior and the hypotheses of the first frames
  uniform,   ///< uniform over the region
  gaussian   ///< around a known pose
};

struct ParticleFilterOptions
{
  std::size_t particles = 2000;           ///< of a filter with one mode (adaptive_size: only at the start, see kld)
  std::size_t verified_particles = 100;   ///< of one that is verified and narrow enough to be taken for a Gaussian
  std::size_t initial_particles = 20000;  ///< of global localization
  PoseRegion region;                      ///< where the robot can start, and be found again
  InitialMode initial_mode = InitialMode::analytic;
  GaussianPose initial_pose;           ///< for InitialMode::gaussian
  bool initial_pose_measured = false;  ///< ... by the same sensors, of which it shares the errors that last
  MotionModel motion;
  BiasModel biases;                ///< systematic errors estimated with the pose
  bool heading_observable = true;  ///< false: neither sensors nor motion tell the heading; position alone is estimated
  ResamplingMethod resampling = ResamplingMethod::systematic;
  double resample_below = 0.5;  ///< effective sample ratio
  bool adaptive_size = false;   ///< KLD sample size
  KldOptions kld;
  ModeOptions modes;
  RecoveryOptions recovery;
  VerdictOptions verdict;
  bool mode_kalman_filters = true;              ///< divide the weight between compact modes (mode_mixture.h)
  std::size_t kalman_proposal_below_ess = 400;  ///< effective particles; fewer: gaussian_proposal.h
  bool learn_reliability = true;                ///< estimate the clutter probability of every landmark
  double reliability_prior_strength = 30;       ///< [detections]
  unsigned threads = 1;                         ///< the result does not depend on it

  /// The first pose where it is known, and not from the sensors.
  [[nodiscard]] std::optional<GaussianPose> givenStart() const
  {
    if (initial_mode != InitialMode::gaussian || initial_pose_measured) return std::nullopt;
    return initial_pose;
  }
};
}  // namespace mrpt_ext
