#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "mrpt_ext/calibration/block_tridiagonal_solver.h"
#include "mrpt_ext/calibration/outlier_model.h"
#include "mrpt_ext/calibration/trajectory_model.h"

namespace mrpt_ext
{
/// Zero of a function that falls by 2 at most and hardly less than by a quarter of its argument, by the secant of the
/// last two values. The logarithm of misfit over redundancy is one of the scatter's: by 2 where the residuals are all
/// redundant; where the poses follow most of them, steps of that size would take dozens of rounds.
class SecantSearch
{
 public:
  /// What to add to `x`, where the function is `value`.
  [[nodiscard]] double step(double x, double value)
  {
    constexpr double kSteepest = -2, kFlattest = -0.25;
    const double slope =
        last_ && x != last_->x ? std::clamp((value - last_->value) / (x - last_->x), kSteepest, kFlattest) : kSteepest;
    last_ = {x, value};
    return -value / slope;
  }

 private:
  struct Point
  {
    double x = 0, value = 0;
  };
  std::optional<Point> last_;
};

/// Robust adjustment of the poses and the unknowns of a recording, step by step; calibrate() runs the steps.
class TrajectoryAdjustment
{
 public:
  /// `problem` must outlive it.
  TrajectoryAdjustment(const CalibrationProblem& problem, std::vector<CalibrationUnknown> unknowns);

  /// Gauss-Newton steps until nothing moves, at most this many; a step that makes it worse is shortened. False when
  /// something is undetermined.
  [[nodiscard]] bool descend(int most_steps);
  /// From now on a reading counts by its probability of being no outlier, at the share of outliers that the readings
  /// show. To begin with that would trust what the first guess happens to fit.
  void tellOutliers();
  /// Estimates the scatters from the residuals; false when something is undetermined.
  [[nodiscard]] bool estimateScatters();
  [[nodiscard]] double cost() const;
  /// Of the unknowns.
  struct Uncertainty
  {
    Eigen::MatrixXd covariance;  ///< by the normal equations
    /// The larger of normal equations and sandwich estimator over blocks of time. What landmarks share is told by their
    /// number: their offsets are random, and a block of time shows all of them.
    Eigen::VectorXd std;
  };
  [[nodiscard]] std::optional<Uncertainty> uncertainty() const;

  [[nodiscard]] const TrajectoryModel& model() const { return model_; }
  [[nodiscard]] const std::vector<SensorScatter>& scatters() const { return scatters_; }
  /// Standard deviations of the scatters of odometry; infinite where nothing tells one. Variance components: the
  /// derivative of their restricted likelihood is the misfit of odometry over what is expected of it, minus its
  /// redundancy (Patterson and Thompson, Biometrika 58(3), 1971). The curvature, in which the poses follow the
  /// scatters, and the disagreement of blocks of time both bound them.
  [[nodiscard]] PerMotionNoise<double> odometryScatterStd() const;
  [[nodiscard]] const PerMotionNoise<double>& odometryRedundancy() const { return odometry_redundancy_; }
  [[nodiscard]] int steps() const { return steps_; }
  /// Residual of each reading over its standard deviation, with the scatter found.
  [[nodiscard]] std::vector<double> misfits() const;

  /// Continues from the poses and scatters of `start`, with other values of the unknowns.
  void restart(const TrajectoryAdjustment& start, const Eigen::VectorXd& errors);
  /// Continues from the unknowns and scatters of `start`, which has other poses.
  void continueFrom(const TrajectoryAdjustment& start);

 private:
  [[nodiscard]] double scatterOf(const CalibrationReading& reading) const;
  [[nodiscard]] double assumedScatterOf(const CalibrationReading& reading) const;
  /// Of a residual over the declared deviation.
  [[nodiscard]] ReadingLoss lossOf(const CalibrationReading& reading, double residual) const;
  void estimateOutlierShares();
  [[nodiscard]] double priorOf(const CalibrationUnknown& unknown) const;
  /// Errors that landmarks have by themselves, of one kind.
  struct LandmarkErrors
  {
    std::size_t sensor = 0;
    bool of_map = false;  // else their offsets
    bool operator<(const LandmarkErrors& other) const
    {
      return std::tie(sensor, of_map) < std::tie(other.sensor, other.of_map);
    }
  };
  struct LandmarkVariance
  {
    double std = 0;   // [m]
    double told = 0;  // number of them that readings tell
  };
  [[nodiscard]] static LandmarkErrors landmarkErrorsOf(const CalibrationUnknown& unknown);
  /// By how much the errors of landmarks differ: a variance component (restricted maximum likelihood).
  void estimateLandmarkStds(const ChainSolution& solution);
  [[nodiscard]] PoseChainSystem linearized() const;
  /// What each noise of odometry has in the squared residual of each link, and in its redundancy: a column per link.
  struct LinkFits
  {
    using ByLink = Eigen::Matrix<double, motion_noises, Eigen::Dynamic>;
    ByLink misfit, redundancy;
  };
  [[nodiscard]] LinkFits linkFits(const ChainSolution& solution) const;
  /// Derivatives of the logarithm of the restricted likelihood by those of the scatters: a column per block of time.
  [[nodiscard]] std::optional<LinkFits::ByLink> scatterScores(const PerMotionNoise<double>& scatter) const;
  void move(const ChainSolution& solution, double share, const std::vector<Pose2>& from, const Eigen::VectorXd& errors);
  [[nodiscard]] Eigen::MatrixXd scoresByBlock(const ChainSolution& solution, double& curvature) const;

  const CalibrationProblem& problem_;
  TrajectoryModel model_;
  std::vector<Pose2> poses_;
  std::vector<SensorScatter> scatters_;
  std::map<LandmarkErrors, LandmarkVariance> landmark_errors_;
  OutlierModel outliers_;
  PerMotionNoise<SecantSearch> search_;  // of the scatters of odometry
  PerMotionNoise<double> odometry_redundancy_{0, 0};
  int steps_ = 0;
};
}  // namespace mrpt_ext
