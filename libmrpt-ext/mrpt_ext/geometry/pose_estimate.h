#pragma once

#include <optional>

#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/verdict.h"

namespace mrpt_ext
{
/// One estimate of one method (a row of steps.csv).
struct PoseEstimate
{
  double time = 0;  ///< [s]
  GaussianPose pose;
  bool heading_known = true;
  int modes = 1;
  double best_weight = 1;                   ///< weight of the reported mode
  std::optional<double> effective_samples;  ///< share in [0, 1], filters only
  Verdict verdict = Verdict::ok;

  template <class Self, class Archive>
  static void archive(Self& p, Archive& fields)
  {
    fields(p.time, p.pose.mean, p.pose.covariance, p.heading_known, p.modes, p.best_weight, p.effective_samples,
           p.verdict);
  }
};
}  // namespace mrpt_ext
