#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext
{
/// Solution of the normal equations of a PoseChainSystem.
struct ChainSolution
{
  std::vector<Vector3d> steps;           ///< of the poses
  Eigen::VectorXd shared_step;           ///< of the shared unknowns
  Eigen::MatrixXd shared_information;    ///< about them, with the poses marginalized
  Eigen::MatrixXd pull;                  ///< rows 3k ...: negative derivative of pose k by the shared unknowns
  std::vector<Matrix3d> covariance;      ///< of the poses, given the shared unknowns
  std::vector<Matrix3d> with_successor;  ///< between pose k and pose k + 1
};

/// Normal equations of a chain of poses (x, y, phi), each tied to its neighbours only, and of a few unknowns that touch
/// all of them. Everything added is a residual (measured minus predicted), its derivative of the prediction, and a
/// weight. Solved by block elimination along the chain, in time linear in its length (Schur complement for the shared
/// unknowns; Bryson-Frazier-like backward pass for the covariances).
class PoseChainSystem
{
 public:
  using SharedRow = Eigen::RowVectorXd;
  using SharedRows = Eigen::Matrix<double, 3, Eigen::Dynamic>;

  PoseChainSystem(std::size_t poses, Eigen::Index shared);

  /// A scalar that depends on one pose.
  void addReading(std::size_t pose, double residual, const JacobianRow& own, const SharedRow& shared, double weight);
  /// Three scalars that depend on a pose and the one after it.
  void addLink(std::size_t pose, const Vector3d& residual, const Matrix3d& own, const Matrix3d& next,
               const SharedRows& shared, double weight);
  /// A scalar that depends on the shared unknowns alone: a prior.
  void addPrior(double residual, const SharedRow& shared, double weight);

  /// Nothing when a pose or a shared unknown stays undetermined.
  [[nodiscard]] std::optional<ChainSolution> solve() const;

 private:
  std::vector<Matrix3d> diagonal_, above_;  // information of each pose, and between it and the next
  Eigen::MatrixXd side_;                    // by pose: gradient, then the coupling with the shared unknowns
  Eigen::MatrixXd shared_;
  Eigen::VectorXd shared_side_;
};
}  // namespace mrpt_ext
