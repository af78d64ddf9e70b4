#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <vector>

#include "mrpt_ext/solvers/pose_from_landmarks.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "random_scene.h"

namespace mrpt_ext
{
/// The measurements of a robot in a scene.
struct MeasurementSetup
{
  enum class What
  {
    bearings,
    ranges,
    ranges_and_bearings,  ///< both of every landmark
    mixed                 ///< one or both of each landmark in turn, by three sensors on the robot
  };
  What what = What::bearings;
  double std_bearing = 0;  ///< [rad]
  double std_range = 0;    ///< [m]
};

inline std::vector<PoseMeasurement> measureScene(const Scene& scene, const MeasurementSetup& setup,
                                                 RandomStream& random)
{
  using Kind = PoseMeasurement::Kind;
  using What = MeasurementSetup::What;
  const std::array<Pose2, 3> sensors{Pose2{0.3, 0.2, 0.5}, Pose2{-0.4, 0, kPi}, Pose2{0.1, -0.3, -1.5}};
  std::vector<PoseMeasurement> measurements;
  for (std::size_t i = 0; i < scene.landmarks.size(); ++i)
  {
    const Pose2 sensor = setup.what == What::mixed ? sensors[i % 3] : Pose2{};
    const auto add = [&](Kind what, double std)
    {
      PoseMeasurement m{what, scene.landmarks[i], 0, std, sensor};
      m.value = predict(m, scene.robot) + std * random.gaussian();
      m.value = what == Kind::range ? std::max(0.0, m.value) : wrap(m.value);
      measurements.push_back(m);
    };
    const bool bearing = setup.what != What::ranges && (setup.what != What::mixed || i % 4 != 1);
    const bool range = setup.what != What::bearings && (setup.what != What::mixed || i % 4 < 2);
    if (bearing) add(Kind::bearing, setup.std_bearing);
    if (range) add(Kind::range, setup.std_range);
  }
  return measurements;
}

/// Cramer-Rao bound of the position's standard deviation [m]; without a heading if it is not observable.
inline double positionBound(const std::vector<PoseMeasurement>& measurements, const Pose2& truth)
{
  const Matrix3d information = poseInformation(measurements, truth);
  const Matrix2d corner = information.topLeftCorner<2, 2>();
  const auto square_of = [](const auto& covariance)
  { return covariance ? covariance->template topLeftCorner<2, 2>().trace() : 1e18; };
  return std::sqrt(information(2, 2) > 0 ? square_of(covarianceFromInformation(information))
                                         : square_of(covarianceFromInformation(corner)));
}

/// Errors of the solver relative to the bound, over many scenes with many trials each.
struct CramerRaoTally
{
  static constexpr double kGood = 0.5;  ///< [m], 5 % of the side of the square
  std::vector<double> ratios;           ///< root mean square error / bound, of each good scene
  int scenes = 0, other_scenes = 0;
  int flagged_good = 0, flagged_other = 0;  ///< scenes with the degeneracy flag in most trials
  long trials = 0, degenerate_good = 0, ambiguous = 0, contradictory = 0;

  [[nodiscard]] double quantile(double p) const
  {
    std::vector<double> sorted = ratios;
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty() ? 0 : sorted[static_cast<std::size_t>(p * static_cast<double>(sorted.size() - 1))];
  }
};

inline CramerRaoTally tallyAgainstBound(const MeasurementSetup& setup, int landmarks, int scenes, int trials,
                                        const IdentifiedPoseOptions& options, RandomStream& random)
{
  CramerRaoTally tally;
  for (int s = 0; s < scenes; ++s)
  {
    const Scene scene = randomScene(random, landmarks);
    double bound = 0, squares = 0;
    int answers = 0, flagged = 0;
    for (int t = 0; t < trials; ++t)
    {
      const std::vector<PoseMeasurement> measurements = measureScene(scene, setup, random);
      if (t == 0) bound = positionBound(measurements, scene.robot);
      const IdentifiedPose solved = solvePoseFromLandmarks(measurements, options);
      ++tally.trials;
      flagged += solved.status == SolveStatus::degenerate;
      tally.contradictory += solved.status == SolveStatus::none;
      const bool ambiguous = solved.candidates.size() > 1;
      tally.ambiguous += ambiguous;
      if (solved.candidates.empty() || ambiguous) continue;
      ++answers;
      squares += (solved.candidates.front().pose.mean.position() - scene.robot.position()).squaredNorm();
    }
    ++tally.scenes;
    const bool mostly = 2 * flagged > trials;
    if (bound >= CramerRaoTally::kGood)
    {
      ++tally.other_scenes;
      tally.flagged_other += mostly;
      continue;
    }
    tally.flagged_good += mostly;
    tally.degenerate_good += flagged;
    if (answers > 0) tally.ratios.push_back(std::sqrt(squares / answers) / bound);
  }
  return tally;
}

/// Reliability of single solutions, over many scenes with one trial each.
struct TrustTally
{
  std::array<long, 6> status{};  ///< by SolveStatus
  long unique = 0;               ///< ok, and one candidate
  long confident_wrong = 0;      ///< ... of these: beyond six standard deviations of its own covariance
  long far_off = 0;              ///< ... of these: further than the side of the square
  double worst = 0;              ///< ... largest distance in standard deviations
  double mean_nees = 0;          ///< ... mean squared distance in standard deviations
};

inline void tallyTrust(TrustTally& tally, const Scene& scene, const IdentifiedPose& solved)
{
  ++tally.status[static_cast<std::size_t>(solved.status)];
  if (!solved.unique()) return;
  const PoseCandidate& best = solved.candidates.front();
  const Pose2& mean = best.pose.mean;
  const Vector3d e(mean.x - scene.robot.x, mean.y - scene.robot.y, wrap(mean.phi - scene.robot.phi));
  const Matrix2d position = best.pose.covariance.topLeftCorner<2, 2>();
  const double d2 = best.heading_known ? e.dot(best.pose.covariance.inverse() * e)
                                       : e.head<2>().dot(position.inverse() * e.head<2>());
  ++tally.unique;
  tally.confident_wrong += d2 > 36;
  tally.far_off += e.head<2>().norm() > 10;
  tally.worst = std::max(tally.worst, std::sqrt(d2));
  tally.mean_nees += (d2 - tally.mean_nees) / static_cast<double>(tally.unique);
}
}  // namespace mrpt_ext
