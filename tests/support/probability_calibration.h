#pragma once

#include <Eigen/Cholesky>
#include <array>

#include "global_search_scene.h"
#include "mrpt_ext/correspondence/binomial.h"
#include "mrpt_ext/correspondence/pose_search_result.h"

namespace mrpt_ext
{
/// True when `pose` is the mode of the truth: within 0.1 m and 1 deg, or its error is consistent with its covariance
/// (three degrees of freedom, 99.99 %), or it matches every detection as the truth does. A right pose from few or
/// coarse readings may be known to worse than 0.1 m.
inline bool isTruthsMode(const ConsistentPose& pose, const SceneScan& view)
{
  constexpr double kQuantile = 21.1;  // chi-square, 3 degrees of freedom
  const Pose2& p = pose.pose.mean;
  const Vector3d e(p.x - view.robot.x, p.y - view.robot.y, wrap(p.phi - view.robot.phi));
  return isAtTruth(p, view.robot) || pose.assignment == view.truth ||
         e.dot(pose.pose.covariance.ldlt().solve(e)) < kQuantile;
}

/// Stated probabilities and observed frequencies, in ten bins.
struct ProbabilityCalibration
{
  struct Bin
  {
    int trials = 0, hits = 0;
    double stated = 0;  ///< sum

    [[nodiscard]] double meanStated() const { return trials > 0 ? stated / trials : 0; }
    [[nodiscard]] double hitRate() const { return trials > 0 ? static_cast<double>(hits) / trials : 0; }
    [[nodiscard]] bool isEnough() const { return trials >= 30; }
    /// In the 99 % binomial interval of the mean stated probability.
    [[nodiscard]] bool isInside() const
    {
      const double p = meanStated();
      const double above = binomialTail(trials, hits, p), below = 1 - binomialTail(trials, hits + 1, p);
      return std::min(above, below) > 0.005;
    }
  };
  std::array<Bin, 10> bins;

  void add(double probability, bool hit)
  {
    Bin& bin = bins[static_cast<std::size_t>(std::clamp(10 * probability, 0.0, 9.0))];
    ++bin.trials;
    bin.hits += hit;
    bin.stated += probability;
  }
};
}  // namespace mrpt_ext
