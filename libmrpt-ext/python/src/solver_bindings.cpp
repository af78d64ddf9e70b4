#include "bindings.h"
#include "mrpt_ext/evaluation/information_bound.h"
#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "mrpt_ext/solvers/bearing_pose_ml.h"
#include "mrpt_ext/solvers/pose_from_landmarks.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/range_position.h"
#include "mrpt_ext/solvers/running_fix.h"

namespace mrpt_ext::python
{
namespace py = pybind11;

namespace
{
std::vector<KnownBearing> bearingsOf(const Measured& all)
{
  std::vector<KnownBearing> bearings;
  for (Eigen::Index i = 0; i < all.values.size(); ++i)
    bearings.push_back({all.landmarks.row(i), all.values[i], all.stds[i]});
  return bearings;
}

py::dict answer(SolveStatus status)
{
  py::dict result;
  result["status"] = std::string(toString(status));
  return result;
}

py::dict bearingPoseLinear(const Eigen::MatrixX2d& landmarks, const Eigen::VectorXd& bearings)
{
  const BearingPoseLinear pose = solveBearingPoseLinear(bearingsOf(measured(landmarks, bearings, py::float_(1.0))));
  py::dict result = answer(pose.status);
  result["det_ratio"] = pose.det_ratio;
  if (pose.status == SolveStatus::ok) result["pose"] = arrayOf(pose.pose);
  return result;
}

py::dict bearingPoseMl(const Eigen::MatrixX2d& landmarks, const Eigen::VectorXd& bearings, const py::object& std)
{
  const PoseMl pose = solveBearingPoseMl(bearingsOf(measured(landmarks, bearings, std)));
  py::dict result = answer(pose.status);
  result["chi2"] = pose.chi2;
  if (pose.status != SolveStatus::ok) return result;
  addPose(result, pose.pose);
  return result;
}

py::dict rangePosition(const Eigen::MatrixX2d& landmarks, const Eigen::VectorXd& ranges, const py::object& std)
{
  const Measured all = measured(landmarks, ranges, std);
  std::vector<KnownRange> known;
  for (Eigen::Index i = 0; i < ranges.size(); ++i) known.push_back({all.landmarks.row(i), all.values[i], all.stds[i]});
  const RangePositions positions = solveRangePosition(known);
  py::dict result = answer(positions.status);
  py::list candidates;
  for (const RangePosition& candidate : positions.candidates)
  {
    py::dict one;
    one["position"] = candidate.position.mean;
    one["covariance"] = candidate.position.covariance;
    one["chi2"] = candidate.chi2;
    candidates.append(one);
  }
  result["candidates"] = candidates;
  return result;
}

py::dict runningFixOf(const Vector2d& landmark, const Vector2d& displacement, double first_range, double second_range,
                      double first_std, double second_std, const Matrix2d& displacement_covariance)
{
  const RunningFix fix = runningFix({.landmark = landmark,
                                     .displacement = displacement,
                                     .first_range = first_range,
                                     .second_range = second_range,
                                     .first_std = first_std,
                                     .second_std = second_std,
                                     .displacement_covariance = displacement_covariance});
  py::dict result = answer(fix.status);
  result["intersects"] = fix.intersects;
  py::list candidates;
  for (const RunningFixCandidate& candidate : fix.candidates)
  {
    py::dict one;
    one["first"] = candidate.first;
    one["second"] = candidate.second.mean;
    one["covariance"] = candidate.second.covariance;
    candidates.append(one);
  }
  result["candidates"] = candidates;
  return result;
}

std::vector<PoseMeasurement> measurementsOf(const Eigen::MatrixX2d& bearing_landmarks, const Eigen::VectorXd& bearings,
                                            const py::object& std_bearing, const Eigen::MatrixX2d& range_landmarks,
                                            const Eigen::VectorXd& ranges, const py::object& std_range)
{
  std::vector<PoseMeasurement> all;
  const auto add = [&](const Measured& some, PoseMeasurement::Kind kind)
  {
    for (Eigen::Index i = 0; i < some.values.size(); ++i)
      all.push_back({.kind = kind, .landmark = some.landmarks.row(i), .value = some.values[i], .std = some.stds[i]});
  };
  add(measured(bearing_landmarks, bearings, std_bearing), PoseMeasurement::Kind::bearing);
  add(measured(range_landmarks, ranges, std_range), PoseMeasurement::Kind::range);
  return all;
}

py::dict solvePose(const Eigen::MatrixX2d& bearing_landmarks, const Eigen::VectorXd& bearings,
                   const py::object& std_bearing, const Eigen::MatrixX2d& range_landmarks,
                   const Eigen::VectorXd& ranges, const py::object& std_range)
{
  const IdentifiedPose pose = solvePoseFromLandmarks(
      measurementsOf(bearing_landmarks, bearings, std_bearing, range_landmarks, ranges, std_range));
  py::dict result = answer(pose.status);
  result["consistency"] = pose.consistency;
  py::list candidates;
  for (const PoseCandidate& candidate : pose.candidates)
  {
    py::dict one;
    addPose(one, candidate.pose);
    one["heading_known"] = candidate.heading_known;
    one["probability"] = candidate.probability;
    candidates.append(one);
  }
  result["candidates"] = candidates;
  return result;
}

std::optional<Matrix3d> poseBound(const Vector3d& pose, const Eigen::MatrixX2d& bearing_landmarks,
                                  const py::object& std_bearing, const Eigen::MatrixX2d& range_landmarks,
                                  const py::object& std_range)
{
  const auto at = measurementsOf(bearing_landmarks, Eigen::VectorXd::Zero(bearing_landmarks.rows()), std_bearing,
                                 range_landmarks, Eigen::VectorXd::Zero(range_landmarks.rows()), std_range);
  return covarianceFromInformation(poseInformation(at, poseOf(pose)));
}
}  // namespace

void bindSolvers(py::module_& module)
{
  const Eigen::MatrixX2d none(0, 2);
  const Eigen::VectorXd nothing(0);
  module.def(
      "bearing_pose_linear", &bearingPoseLinear, py::arg("landmarks"), py::arg("bearings"),
      "Linear least squares of Lee and Chung: (n, 2) landmarks [m], (n,) bearings [rad, CCW from the forward axis]."
      "\n\nReturns a dict: status, det_ratio (quality of the geometry), and with status 'ok' pose (x, y, phi).");
  module.def("bearing_pose_ml", &bearingPoseMl, py::arg("landmarks"), py::arg("bearings"), py::arg("std"),
             "Maximum likelihood pose from n >= 3 bearings; std [rad], one for all or (n,).\n\n"
             "Returns a dict: status, chi2, and with status 'ok' pose (3,) and covariance (3, 3) [m, m, rad].");
  module.def("range_position", &rangePosition, py::arg("landmarks"), py::arg("ranges"), py::arg("std"),
             "Maximum likelihood positions from n >= 2 horizontal ranges [m].\n\n"
             "Returns a dict: status and candidates, best first: position (2,), covariance (2, 2), chi2.");
  module.def(
      "running_fix", &runningFixOf, py::arg("landmark"), py::arg("displacement"), py::arg("first_range"),
      py::arg("second_range"), py::arg("first_std"), py::arg("second_std"),
      py::arg("displacement_covariance") = Matrix2d(Matrix2d::Zero()),
      "Two ranges to one landmark with a known displacement between them (world axes, [m]): Bais, Sablatnig and Gu."
      "\n\nReturns a dict: status, intersects, candidates with first (2,), second (2,) and covariance (2, 2).");
  module.def(
      "solve_pose", &solvePose, py::arg("bearing_landmarks") = none, py::arg("bearings") = nothing,
      py::arg("std_bearing") = 1.0, py::arg("range_landmarks") = none, py::arg("ranges") = nothing,
      py::arg("std_range") = 1.0,
      "Every pose that bearings and ranges of known landmarks allow.\n\n"
      "Returns a dict: status, consistency, candidates: pose (3,), covariance (3, 3), heading_known, probability.");
  module.def(
      "pose_bound", &poseBound, py::arg("pose"), py::arg("bearing_landmarks") = none, py::arg("std_bearing") = 1.0,
      py::arg("range_landmarks") = none, py::arg("std_range") = 1.0,
      "Cramer-Rao bound (3, 3) of a pose from bearings and ranges to these landmarks; None where it is singular.");
}
}  // namespace mrpt_ext::python
