#include "mrpt_ext/calibration/range_bias_calibration.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/calibration/block_tridiagonal_solver.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/solvers/pose_from_landmarks.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kLeastEpochs = 10, kLeastRanges = 4;
constexpr int kMostIterations = 60;
constexpr double kLossScale = 2;        // standard deviations
constexpr double kOutlier = 4;          // scatters
constexpr double kConverged = 1e-7;     // [m]
constexpr double kUndetermined = 1e-9;  // of the largest information
constexpr double kPosePrior = 1e-9;     // keeps a pose with ranges in line solvable
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// An epoch with its estimated pose.
struct EpochWithPose
{
  const RadioEpoch* ranges;
  Pose2 pose;
};

double horizontal(const RadioRange& r, double range)
{
  return std::sqrt(std::max(square(range) - square(r.height), 0.0));
}

std::vector<EpochWithPose> startingPoses(const std::vector<RadioEpoch>& epochs, double std_range)
{
  std::vector<EpochWithPose> started;
  for (const RadioEpoch& epoch : epochs)
  {
    std::vector<PoseMeasurement> rows;
    for (const RadioRange& r : epoch)
      rows.push_back({PoseMeasurement::Kind::range,
                      r.position,
                      horizontal(r, r.range),
                      std_range,
                      {r.offset.x(), r.offset.y(), 0}});
    if (rows.size() < kLeastRanges) continue;
    const IdentifiedPose solution = solvePoseFromLandmarks(rows);
    if (solution.candidates.empty() || !solution.candidates.front().heading_known) continue;
    started.push_back({&epoch, solution.candidates.front().pose.mean});
  }
  return started;
}

/// The common unknowns: range biases of the sensors, then of the landmarks.
class Adjustment
{
 public:
  Adjustment(std::vector<EpochWithPose> epochs, std::size_t sensors, std::size_t landmarks, double std_range)
      : epochs_(std::move(epochs)),
        sensors_(static_cast<Eigen::Index>(sensors)),
        biases_(Vector::Zero(static_cast<Eigen::Index>(sensors + landmarks))),
        scale_(kLossScale * std_range)
  {
  }

  /// One Gauss-Newton step; false when some bias is undetermined.
  bool step(double& change)
  {
    PoseChainSystem system(epochs_.size(), biases_.size());
    // The biases of the landmarks sum to zero: their mean is part of those of the sensors.
    Eigen::RowVectorXd landmarks = Eigen::RowVectorXd::Zero(biases_.size());
    landmarks.tail(biases_.size() - sensors_).setOnes();
    system.addPrior(-landmarks.dot(biases_), landmarks, static_cast<double>(epochs_.size()));
    for (std::size_t k = 0; k < epochs_.size(); ++k) addEpoch(k, system);
    const std::optional<ChainSolution> solution = system.solve();
    if (!solution) return false;
    information_ = solution->shared_information;
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(information_, Eigen::EigenvaluesOnly);
    if (!(eigen.eigenvalues().minCoeff() > kUndetermined * eigen.eigenvalues().maxCoeff())) return false;
    biases_ += solution->shared_step;
    for (std::size_t k = 0; k < epochs_.size(); ++k) epochs_[k].pose = added(epochs_[k].pose, solution->steps[k]);
    change = solution->shared_step.cwiseAbs().maxCoeff();
    return true;
  }

  /// Measured minus predicted [m].
  [[nodiscard]] double residual(const RadioRange& r, const Pose2& pose) const
  {
    const double flat = predictRange(pose, r.position, {r.offset.x(), r.offset.y(), 0});
    return r.range - std::hypot(flat, r.height) - biases_[sensorOf(r)] - biases_[landmarkOf(r)];
  }
  [[nodiscard]] const std::vector<EpochWithPose>& epochs() const { return epochs_; }
  [[nodiscard]] const Vector& biases() const { return biases_; }
  [[nodiscard]] Vector standardDeviations(double scatter) const
  {
    return scatter * information_.inverse().diagonal().cwiseMax(0).cwiseSqrt();
  }

 private:
  [[nodiscard]] static Eigen::Index sensorOf(const RadioRange& r) { return static_cast<Eigen::Index>(r.sensor); }
  [[nodiscard]] Eigen::Index landmarkOf(const RadioRange& r) const
  {
    return sensors_ + static_cast<Eigen::Index>(r.landmark);
  }

  void addEpoch(std::size_t k, PoseChainSystem& system) const
  {
    const Pose2& pose = epochs_[k].pose;
    Eigen::RowVectorXd biases = Eigen::RowVectorXd::Zero(biases_.size());
    for (int axis = 0; axis < 3; ++axis) system.addReading(k, 0, JacobianRow::Unit(axis), biases, kPosePrior);
    for (const RadioRange& r : *epochs_[k].ranges)
    {
      const double e = residual(r, pose), flat = predictRange(pose, r.position, {r.offset.x(), r.offset.y(), 0});
      const JacobianRow own = flat / std::hypot(flat, r.height) * rangeJacobian(pose, r.position, r.offset);
      biases[sensorOf(r)] = biases[landmarkOf(r)] = 1;
      system.addReading(k, e, own, biases, 1 / (1 + square(e / scale_)));
      biases[sensorOf(r)] = biases[landmarkOf(r)] = 0;
    }
  }

  std::vector<EpochWithPose> epochs_;
  Eigen::Index sensors_;
  Vector biases_;
  double scale_;
  Matrix information_;
};

void describeResiduals(const Adjustment& adjustment, std::size_t landmarks, RangeBiases& result)
{
  std::vector<double> sizes;
  for (const EpochWithPose& epoch : adjustment.epochs())
    for (const RadioRange& r : *epoch.ranges) sizes.push_back(std::abs(adjustment.residual(r, epoch.pose)));
  result.scatter = 1.4826 * upperMedian(std::move(sizes));
  std::vector<double> count(landmarks), outliers(landmarks);
  for (const EpochWithPose& epoch : adjustment.epochs())
    for (const RadioRange& r : *epoch.ranges)
    {
      ++count[r.landmark];
      outliers[r.landmark] += std::abs(adjustment.residual(r, epoch.pose)) > kOutlier * result.scatter;
    }
  for (std::size_t j = 0; j < landmarks; ++j) result.outlier_share.push_back(count[j] > 0 ? outliers[j] / count[j] : 0);
}
}  // namespace

RangeBiases estimateRangeBiases(const std::vector<RadioEpoch>& epochs, double std_range)
{
  RangeBiases result;
  std::size_t sensors = 0, landmarks = 0;
  for (const RadioEpoch& epoch : epochs)
    for (const RadioRange& r : epoch)
    {
      if (!std::isfinite(r.range) || !r.position.allFinite() || !r.offset.allFinite() || !std::isfinite(r.height))
        result.status = SolveStatus::bad_input;
      sensors = std::max(sensors, r.sensor + 1);
      landmarks = std::max(landmarks, r.landmark + 1);
    }
  if (!(std_range > 0)) result.status = SolveStatus::bad_input;
  if (result.status == SolveStatus::bad_input) return result;
  std::vector<EpochWithPose> started = startingPoses(epochs, std_range);
  result.epochs = started.size();
  if (started.size() < kLeastEpochs || sensors < 2) return result;

  Adjustment adjustment(std::move(started), sensors, landmarks, std_range);
  result.status = SolveStatus::degenerate;
  double change = 1;
  for (int k = 0; k < kMostIterations && change > kConverged; ++k)
    if (!adjustment.step(change)) return result;
  describeResiduals(adjustment, landmarks, result);
  const Vector &biases = adjustment.biases(), stds = adjustment.standardDeviations(result.scatter);
  const auto ns = static_cast<Eigen::Index>(sensors);
  result.sensor.assign(biases.data(), biases.data() + ns);
  result.landmark.assign(biases.data() + ns, biases.data() + biases.size());
  result.std_sensor.assign(stds.data(), stds.data() + ns);
  result.std_landmark.assign(stds.data() + ns, stds.data() + stds.size());
  result.status = SolveStatus::ok;
  return result;
}
}  // namespace mrpt_ext
