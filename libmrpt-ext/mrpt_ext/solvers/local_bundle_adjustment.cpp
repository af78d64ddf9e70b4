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

/// An error of the robot's pose now moves a landmark in the robot frame.
Rows3 swingOf(const Vector2d& v)
{
  Rows3 swing;
  swing << Matrix2d::Identity(), perpendicular(v);
  return swing;
}

/// Places that differ by nothing but the sensor share their error.
struct Moments
{
  std::vector<int> of_place;
  std::vector<Matrix3d> covariance;  // of the way since, oldest first

  explicit Moments(std::span<const ScanPose> places)
  {
    for (const ScanPose& place : places)
    {
      const bool same = !covariance.empty() &&
                        (covariance.back() - place.odometry_covariance).norm() <= 1e-9 * covariance.back().norm();
      if (!same) covariance.push_back(place.odometry_covariance);
      of_place.push_back(static_cast<int>(covariance.size()) - 1);
    }
  }
  [[nodiscard]] Eigen::Index unknowns() const { return 3 * static_cast<Eigen::Index>(covariance.size()); }

  /// Information of odometry about the errors: independent pieces of way between the moments, the last up to now.
  [[nodiscard]] Eigen::MatrixXd information() const
  {
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(unknowns(), unknowns());
    for (std::size_t k = 0; k < covariance.size(); ++k)
    {
      const bool last = k + 1 == covariance.size();
      Matrix3d piece = covariance[k] - (last ? Matrix3d(Matrix3d::Zero()) : covariance[k + 1]);
      piece.diagonal().array() += 1e-12;  // [m^2], [rad^2]: a robot that stood still
      const Matrix3d W = piece.inverse();
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

/// One reading: its residual and how it depends on its landmark and on the error of its place [standard deviations].
struct Scalar
{
  double error = 0;
  Eigen::RowVector2d own;
  Eigen::RowVector3d shared;
};

/// Normal equations with the landmarks' blocks kept apart.
struct System
{
  Eigen::MatrixXd way;       // information of the errors
  Eigen::VectorXd way_side;  // gradient
  std::vector<Matrix2d> own;
  std::vector<Vector2d> own_side;
  std::vector<Block> mixed;
  std::vector<std::vector<Scalar>> scalars;  // of each sighting
  double chi2 = 0;
};

struct Problem
{
  std::span<const ScanPose> places;
  std::span<const LandmarkObservation> sightings;
  Moments moments;
  Eigen::MatrixXd prior;
  bool robust = false;

  [[nodiscard]] System linearise(const Eigen::VectorXd& errors, const std::vector<Vector2d>& landmarks) const
  {
    System system{prior, prior * errors, {}, {}, {}, {}, errors.dot(prior * errors)};
    system.own.assign(landmarks.size(), Matrix2d::Zero());
    system.own_side.assign(landmarks.size(), Vector2d::Zero());
    system.mixed.assign(landmarks.size(), Block::Zero(2, errors.size()));
    for (const LandmarkObservation& s : sightings)
    {
      const auto at = 3 * static_cast<Eigen::Index>(moments.of_place[s.place]);
      const Vector3d error = errors.segment<3>(at);
      const Rows3 swing = swingOf(landmarks[s.landmark]);
      const Vector2d d = landmarks[s.landmark] + swing * error - places[s.place].T_robot_sensor.position();
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
        system.way.block<3, 3>(at, at) += shared.transpose() * shared;
        system.way_side.segment<3>(at) += shared.transpose() * e;
      };
      const Pose2& sensor = places[s.place].T_robot_sensor;
      if (s.bearing)
        add(wrap(angleOf(d) - *s.bearing - sensor.phi) / s.std_bearing,
            perpendicular(d).transpose() / (r2 * s.std_bearing));
      if (s.range) add((r - *s.range) / s.std_range, d.transpose() / (r * s.std_range));
    }
    return system;
  }
};

/// The landmarks eliminated: what all sightings together say about the errors of the way.
struct Reduced
{
  Eigen::MatrixXd covariance;  // of the errors
  Eigen::VectorXd step;
  std::vector<Matrix2d> inverse_own;
};

std::optional<Reduced> reduce(const System& system)
{
  Reduced reduced;
  Eigen::MatrixXd way = system.way;
  Eigen::VectorXd side = system.way_side;
  for (std::size_t j = 0; j < system.own.size(); ++j)
  {
    const std::optional<Matrix2d> inverse = covarianceFromInformation(system.own[j]);
    if (!inverse) return std::nullopt;
    way -= system.mixed[j].transpose() * *inverse * system.mixed[j];
    side -= system.mixed[j].transpose() * (*inverse * system.own_side[j]);
    reduced.inverse_own.push_back(*inverse);
  }
  const Eigen::LLT<Eigen::MatrixXd> llt(way);
  if (llt.info() != Eigen::Success) return std::nullopt;
  reduced.covariance = llt.solve(Eigen::MatrixXd::Identity(way.rows(), way.cols()));
  reduced.step = -llt.solve(side);
  return reduced;
}

/// What is left of a reading's residual, over what its fit should have left of it (data snooping, Baarda 1968): a
/// reading that determines its landmark nearly alone hides its error from the plain residual.
double snooped(const Scalar& scalar, const Matrix2d& landmark, const Matrix3d& place, const Rows3& cross)
{
  constexpr double kLeast = 0.02;  // of the variance: below, nothing checks the reading
  const double explained = scalar.own * landmark * scalar.own.transpose() +
                           2.0 * scalar.own.dot(scalar.shared * cross.transpose()) +
                           scalar.shared.dot(scalar.shared * place);
  return square(scalar.error) / std::max(1 - explained, kLeast);
}

bool isUsableProblem(std::span<const ScanPose> places, std::span<const LandmarkObservation> sightings,
                     const std::vector<Vector2d>& start)
{
  const bool places_ok =
      std::all_of(places.begin(), places.end(),
                  [](const ScanPose& p) { return isFinite(p.T_robot_sensor) && p.odometry_covariance.allFinite(); });
  const auto usable = [&](const LandmarkObservation& s)
  {
    const bool bearing = !s.bearing || (std::isfinite(*s.bearing) && s.std_bearing > 0);
    const bool range = !s.range || (*s.range >= 0 && std::isfinite(*s.range) && s.std_range > 0);
    return s.place < places.size() && s.landmark < start.size() && bearing && range;
  };
  return places_ok && std::all_of(sightings.begin(), sightings.end(), usable) &&
         std::all_of(start.begin(), start.end(), [](const Vector2d& v) { return v.allFinite(); });
}

/// The place as it was: an error (x, y, phi) of the robot's pose now had moved it with everything else.
ScanPose corrected(const ScanPose& place, const Vector3d& error, const Matrix3d& covariance)
{
  return {compose(inverse({error.x(), error.y(), error.z()}), place.T_robot_sensor), covariance};
}
}  // namespace

BundleAdjustment adjustBundle(std::span<const ScanPose> places, std::span<const LandmarkObservation> sightings,
                              std::vector<Vector2d> start, bool robust)
{
  BundleAdjustment result;
  result.status = SolveStatus::bad_input;
  if (!isUsableProblem(places, sightings, start)) return result;
  int readings = 0;
  for (const LandmarkObservation& s : sightings) readings += (s.bearing ? 1 : 0) + (s.range ? 1 : 0);
  result.degrees = readings - 2 * static_cast<int>(start.size());
  result.status = SolveStatus::too_few;
  if (start.empty() || result.degrees < 0) return result;

  Problem problem{places, sightings, Moments(places), {}, robust};
  problem.prior = problem.moments.information();
  std::vector<Vector2d> landmarks = std::move(start);
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(problem.moments.unknowns());
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
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const auto at = 3 * static_cast<Eigen::Index>(problem.moments.of_place[k]);
    result.places.push_back(corrected(places[k], errors.segment<3>(at), reduced->covariance.block<3, 3>(at, at)));
  }
  for (std::size_t i = 0; i < sightings.size(); ++i)
  {
    const std::size_t j = sightings[i].landmark;
    const auto at = 3 * static_cast<Eigen::Index>(problem.moments.of_place[sightings[i].place]);
    const Rows3 cross = -reduced->inverse_own[j] * system.mixed[j] * reduced->covariance.middleCols<3>(at);
    const Matrix3d place = reduced->covariance.block<3, 3>(at, at);
    double misfit = 0;
    for (const Scalar& scalar : system.scalars[i])
      misfit += snooped(scalar, result.landmarks[j].covariance, place, cross);
    result.misfits.push_back(misfit);
  }
  result.chi2 = system.chi2;
  result.status = SolveStatus::ok;
  return result;
}
}  // namespace mrpt_ext
