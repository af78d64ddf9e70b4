#pragma once

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/solvers/levenberg_marquardt.h"

namespace mrpt_ext
{
// A window holds readings of several times, transformed into the present robot frame by odometry. Let e_k be the error
// of odometry from time k until now, written as an error of the present pose (x, y, phi; robot axes), with covariance
// E_k. The errors of separate stretches are independent, so an older time contains the error of every newer one:
// Cov(e_i, e_j) = E_j for i older than j. Backwards in time e is a random walk, so that generalized least squares with
// this covariance needs no large matrix: process the times from the oldest to the newest, add up the information about
// the state, and between two times let it diffuse by E_i - E_j. The result is exactly the joint maximum likelihood (a
// Kalman filter in information form), in time linear in the number of readings.

/// Information about a state after a change by noise of this covariance: the quadratic cost q(x) becomes
/// min over y of q(y) + (x - y)^T noise^-1 (x - y). Neither matrix need be invertible.
template <int N>
void diffuse(NormalEquations<N>& information, const Eigen::Matrix<double, N, N>& noise)
{
  using Matrix = Eigen::Matrix<double, N, N>;
  if (noise.isZero(0)) return;
  const Matrix spread = (Matrix::Identity() + information.hessian * noise).inverse();
  const Eigen::Matrix<double, N, 1> gradient = spread * information.gradient;
  information.cost = std::max(0.0, information.cost - information.gradient.dot(noise * gradient));
  information.gradient = gradient;
  const Matrix hessian = spread * information.hessian;
  information.hessian = 0.5 * (hessian + hessian.transpose());
}

/// Adds one scalar reading: its residual (predicted minus measured) and Jacobian row.
template <int N, class Row>
void addReading(NormalEquations<N>& information, double residual, const Row& row, double std)
{
  const double e = residual / std;
  const Eigen::Matrix<double, N, 1> scaled = row.transpose() / std;
  information.cost += e * e;
  information.gradient += e * scaled;
  information.hessian += scaled * scaled.transpose();
}
}  // namespace mrpt_ext
