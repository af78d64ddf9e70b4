#pragma once

#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>

#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext::python
{
// What each file adds to the module.
void bindOnline(pybind11::module_& module);
void bindSearch(pybind11::module_& module);
void bindSolvers(pybind11::module_& module);

/// (x, y, phi) [m, m, rad] as numpy has it.
[[nodiscard]] inline Vector3d arrayOf(const Pose2& pose) { return {pose.x, pose.y, pose.phi}; }
[[nodiscard]] inline Pose2 poseOf(const Vector3d& array) { return {array.x(), array.y(), wrap(array.z())}; }
/// Adds "pose" and "covariance".
inline void addPose(pybind11::dict& to, const GaussianPose& pose)
{
  to["pose"] = arrayOf(pose.mean);
  to["covariance"] = pose.covariance;
}

/// Values of n measurements with their standard deviations, one for all or one each. Throws std::invalid_argument (in
/// Python ValueError) where the lengths differ.
struct Measured
{
  Eigen::MatrixX2d landmarks;
  Eigen::VectorXd values, stds;
};
[[nodiscard]] Measured measured(const Eigen::MatrixX2d& landmarks, const Eigen::VectorXd& values,
                                const pybind11::object& std);
}  // namespace mrpt_ext::python
