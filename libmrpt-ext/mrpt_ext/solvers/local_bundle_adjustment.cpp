#include "mrpt_ext/solvers/local_bundle_adjustment.h"

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <algorithm>

#include "mrpt_ext/solvers/plane.h"
#include "mrpt_ext/solvers/pose_information.h"

namespace mrpt_ext
{
namespace
{
constexpr int kIterations = 20;
constexpr double kSettled = 1e-6;   // step [m], [rad]
constexpr double kCauchyScale = 3;  // standard deviations
using Rows3 = Eigen::Matrix<double, 2, 3>;
using Block = Eigen::Matrix<double, 2, Eigen::Dynamic>;

/// Derivative of a landmark in the robot frame by an error of the present pose.
Rows3 swingOf(const Vector2d& v)
{
  Rows3 swing;
  swing << Matrix2d::Identity(), perpendicular(v);
  return swing;
}

/// Errors of odometry (x, y, phi) since the scans, as unknowns. Scans of one time by several sensors share one error.
struct PoseErrors
{
  std::vector<int> of_scan;          // index of its error
  std::vector<Matrix3d> covariance;  // prior of each error, oldest first

  explicit PoseErrors(std::span<const ScanPose> poses)
  {
    for (const ScanPose& pose : poses)
    {
      const bool same = !covariance.empty() &&
                        (covariance.back() - pose.odometry_covariance).norm() <= 1e-9 * covariance.back().norm();
      if (!same) covariance.push_back(pose.odometry_covariance);
      of_scan.push_back(static_cast<int>(covariance.size()) - 1);
    }
  }
  [[nodiscard]] Eigen::Index unknowns() const { return 3 * static_cast<Eigen::Index>(covariance.size()); }

  /// Prior information: the motions between successive scans, and from the last scan to the present, are independent.
  [[nodiscard]] Eigen::MatrixXd information() const
  {
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(unknowns(), unknowns());
    for (std::size_t k = 0; k < covariance.size(); ++k)
    {
      const bool last = k + 1 == covariance.size();
      Matrix3d motion = covariance[k] - (last ? Matrix3d(Matrix3d::Zero()) : covariance[k + 1]);
      motion.diagonal().array() += 1e-12;  // [m^2], [rad^2]: invertible at standstill
      const Matrix3d W = motion.inverse();
      const auto i = 3 * static_cast<Eigen::Index>(k);
      information.block<3, 3>(i, i) += W;
      if (last) continue;
      information.block<3, 3>(i + 3, i + 3) += W;
      information.block<3, 3>(i, i + 3) -= W;
      information.block<3, 3>(i + 3, i) -= W;
    }
    return information;
  }
};

/// One scalar reading: its residual and its derivatives by the landmark and by the pose error of its scan, all divided
/// by its standard deviation.
struct Scalar
{
  double error = 0;
  Eigen::RowVector2d own;     // by the landmark
  Eigen::RowVector3d shared;  // by the pose error
};

/// Normal equations; the block of each landmark is stored separately.
struct System
{
  Eigen::MatrixXd shared;       // information about the pose errors
  Eigen::VectorXd shared_side;  // its gradient
  std::vector<Matrix2d> own;
  std::vector<Vector2d> own_side;
  std::vector<Block> mixed;
  std::vector<std::vector<Scalar>> scalars;  // of each observation
  double chi2 = 0;
};

struct BundleProblem
{
  std::span<const ScanPose> poses;
  std::span<const LandmarkObservation> observations;
  PoseErrors pose_errors;
  Eigen::MatrixXd prior;
  bool robust = false;

  [[nodiscard]] System linearise(const Eigen::VectorXd& errors, const std::vector<Vector2d>& landmarks) const
  {
    System system{prior, prior * errors, {}, {}, {}, {}, errors.dot(prior * errors)};
    system.own.assign(landmarks.size(), Matrix2d::Zero());
    system.own_side.assign(landmarks.size(), Vector2d::Zero());
    system.mixed.assign(landmarks.size(), Block::Zero(2, errors.size()));
    for (const LandmarkObservation& s : observations)
    {
      const auto at = 3 * static_cast<Eigen::Index>(pose_errors.of_scan[s.scan]);
      const Vector3d error = errors.segment<3>(at);
      const Rows3 swing = swingOf(landmarks[s.landmark]);
      const Vector2d d = landmarks[s.landmark] + swing * error - poses[s.scan].T_robot_sensor.position();
      const double r2 = std::max(d.squaredNorm(), 1e-12), r = std::sqrt(r2);
      Matrix2d turn;  // d (v + swing(v) error) / d v
      turn << 1, -error.z(), error.z(), 1;
      system.scalars.emplace_back();
      const auto add = [&](double error_in_stds, const Eigen::RowVector2d& row_in_stds)
      {
        const double weight = robust ? 1 / (1 + square(error_in_stds / kCauchyScale)) : 1;
        const double e = std::sqrt(weight) * error_in_stds;
        const Eigen::RowVector2d own = std::sqrt(weight) * row_in_stds * turn;
        const Eigen::RowVector3d shared = std::sqrt(weight) * row_in_stds * swing;
        system.scalars.back().push_back({error_in_stds, own, shared});
        system.chi2 += square(e);
        system.own[s.landmark] += own.transpose() * own;
        system.own_side[s.landmark] += own.transpose() * e;
        system.mixed[s.landmark].middleCols<3>(at) += own.transpose() * shared;
        system.shared.block<3, 3>(at, at) += shared.transpose() * shared;
        system.shared_side.segment<3>(at) += shared.transpose() * e;
      };
      const Pose2& sensor = poses[s.scan].T_robot_sensor;
      if (s.bearing)
        add(wrap(angleOf(d) - *s.bearing - sensor.phi) / s.std_bearing,
            perpendicular(d).transpose() / (r2 * s.std_bearing));
      if (s.range) add((r - *s.range) / s.std_range, d.transpose() / (r * s.std_range));
    }
    return system;
  }
};

/// Solution after eliminating the landmarks (Schur complement).
struct Reduced
{
  Eigen::MatrixXd covariance;  // of the pose errors
  Eigen::VectorXd step;
  std::vector<Matrix2d> inverse_own;
};

std::optional<Reduced> reduce(const System& system)
{
  Reduced reduced;
  Eigen::MatrixXd information = system.shared;
  Eigen::VectorXd side = system.shared_side;
  for (std::size_t j = 0; j < system.own.size(); ++j)
  {
    const std::optional<Matrix2d> inverse = covarianceFromInformation(system.own[j]);
    if (!inverse) return std::nullopt;
    information -= system.mixed[j].transpose() * *inverse * system.mixed[j];
    side -= system.mixed[j].transpose() * (*inverse * system.own_side[j]);
    reduced.inverse_own.push_back(*inverse);
  }
  const Eigen::LLT<Eigen::MatrixXd> llt(information);
  if (llt.info() != Eigen::Success) return std::nullopt;
  reduced.covariance = llt.solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
  reduced.step = -llt.solve(side);
  return reduced;
}

/// Squared residual of a reading over the variance that is expected after the fit (data snooping, Baarda 1968). The
/// plain residual is small, wrong or not, for a reading that determines its landmark nearly alone.
double snooped(const Scalar& scalar, const Matrix2d& landmark, const Matrix3d& pose_error, const Rows3& cross)
{
  constexpr double kLeast = 0.02;  // of the variance: below, no other reading checks this one
  const double explained = scalar.own * landmark * scalar.own.transpose() +
                           2.0 * scalar.own.dot(scalar.shared * cross.transpose()) +
                           scalar.shared.dot(scalar.shared * pose_error);
  return square(scalar.error) / std::max(1 - explained, kLeast);
}

bool isUsableProblem(std::span<const ScanPose> poses, std::span<const LandmarkObservation> observations,
                     const std::vector<Vector2d>& start)
{
  const bool poses_ok =
      std::all_of(poses.begin(), poses.end(),
                  [](const ScanPose& p) { return isFinite(p.T_robot_sensor) && p.odometry_covariance.allFinite(); });
  const auto usable = [&](const LandmarkObservation& s)
  {
    const bool bearing = !s.bearing || (std::isfinite(*s.bearing) && s.std_bearing > 0);
    const bool range = !s.range || (*s.range >= 0 && std::isfinite(*s.range) && s.std_range > 0);
    return s.scan < poses.size() && s.landmark < start.size() && bearing && range;
  };
  return poses_ok && std::all_of(observations.begin(), observations.end(), usable) &&
         std::all_of(start.begin(), start.end(), [](const Vector2d& v) { return v.allFinite(); });
}

/// The scan's pose without the error (x, y, phi) of the present pose, by which it was displaced.
ScanPose corrected(const ScanPose& pose, const Vector3d& error, const Matrix3d& covariance)
{
  return {compose(inverse({error.x(), error.y(), error.z()}), pose.T_robot_sensor), covariance};
}
}  // namespace

BundleAdjustment adjustBundle(std::span<const ScanPose> poses, std::span<const LandmarkObservation> observations,
                              std::vector<Vector2d> start, bool robust)
{
  BundleAdjustment result;
  result.status = SolveStatus::bad_input;
  if (!isUsableProblem(poses, observations, start)) return result;
  int readings = 0;
  for (const LandmarkObservation& s : observations) readings += (s.bearing ? 1 : 0) + (s.range ? 1 : 0);
  result.degrees = readings - 2 * static_cast<int>(start.size());
  result.status = SolveStatus::too_few;
  if (start.empty() || result.degrees < 0) return result;

  BundleProblem problem{poses, observations, PoseErrors(poses), {}, robust};
  problem.prior = problem.pose_errors.information();
  std::vector<Vector2d> landmarks = std::move(start);
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(problem.pose_errors.unknowns());
  result.status = SolveStatus::degenerate;
  for (int iteration = 0; iteration < kIterations; ++iteration)
  {
    const System system = problem.linearise(errors, landmarks);
    const std::optional<Reduced> reduced = reduce(system);
    if (!reduced) return result;
    double largest = reduced->step.cwiseAbs().maxCoeff();
    errors += reduced->step;
    for (std::size_t j = 0; j < landmarks.size(); ++j)
    {
      const Vector2d step = -reduced->inverse_own[j] * (system.own_side[j] + system.mixed[j] * reduced->step);
      landmarks[j] += step;
      largest = std::max(largest, step.norm());
    }
    if (!std::isfinite(largest)) return result;
    if (largest < kSettled) break;
  }
  const System system = problem.linearise(errors, landmarks);
  const std::optional<Reduced> reduced = reduce(system);
  if (!reduced) return result;
  for (std::size_t j = 0; j < landmarks.size(); ++j)
  {
    const Block pull = reduced->inverse_own[j] * system.mixed[j];
    result.landmarks.push_back({landmarks[j], reduced->inverse_own[j] + pull * reduced->covariance * pull.transpose()});
  }
  for (std::size_t k = 0; k < poses.size(); ++k)
  {
    const auto at = 3 * static_cast<Eigen::Index>(problem.pose_errors.of_scan[k]);
    result.poses.push_back(corrected(poses[k], errors.segment<3>(at), reduced->covariance.block<3, 3>(at, at)));
  }
  for (std::size_t i = 0; i < observations.size(); ++i)
  {
    const std::size_t j = observations[i].landmark;
    const auto at = 3 * static_cast<Eigen::Index>(problem.pose_errors.of_scan[observations[i].scan]);
    const Rows3 cross = -reduced->inverse_own[j] * system.mixed[j] * reduced->covariance.middleCols<3>(at);
    const Matrix3d pose_error = reduced->covariance.block<3, 3>(at, at);
    double misfit = 0;
    for (const Scalar& scalar : system.scalars[i])
      misfit += snooped(scalar, result.landmarks[j].covariance, pose_error, cross);
    result.misfits.push_back(misfit);
  }
  result.chi2 = system.chi2;
  result.status = SolveStatus::ok;
  return result;
}
}  // namespace mrpt_ext
