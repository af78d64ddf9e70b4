#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/filter/integrity/filter_diagnostics.h"
#include "mrpt_ext/filter/kalman/kalman_state.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// The systematic errors of the only mode, by a Kalman filter of its pose and the errors that runs beside the
/// particles.
///
/// An error that does not change is learned from thousands of frames, and each resampling loses 1 / n of its variance
/// and moves its mean by chance, n the effective number of particles: after minutes the particles agree on a wrong
/// value (static parameters in particle filters: Kantas et al., Statistical Science 30(3), 2015). Given the pose the
/// errors are nearly linear and Gaussian, so they are marginalized: the particles keep the pose, and draw their errors
/// anew from the Kalman filter's conditional density (as Schoen, Gustafsson and Nordlund, IEEE Trans. Signal Process.
/// 53(7), 2005, but with one Kalman filter for all particles).
class BiasFilter
{
 public:
  BiasFilter(MotionModel motion, BiasModel biases);

  /// The particles have taken this frame. `now`: the moments of the only mode; nothing while there are several, or it
  /// is not compact. The filter starts from its pose and what is known of the errors: at first their prior, later what
  /// was learned before there were several modes. When the mode leaves the filter's estimate it starts again from the
  /// prior.
  void follow(const std::optional<KalmanState>& now, const Frame& frame, const LandmarkTable& map);

  /// Draws the errors of the particles of the mode, given their poses; without effect while it follows none.
  void draw(ParticleSet& particles, RandomStream& random) const;

  /// In the order of the model; absent while it follows no mode.
  [[nodiscard]] std::optional<std::vector<BiasEstimate>> estimates() const;

 private:
  void start(const KalmanState& now);

  MotionModel motion_;
  BiasModel biases_;
  KalmanState state_;       // its pose is that of the mode while it follows one
  bool following_ = false;  // a mode
};
}  // namespace mrpt_ext
