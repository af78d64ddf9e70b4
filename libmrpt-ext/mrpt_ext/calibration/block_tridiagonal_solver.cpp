#include "mrpt_ext/calibration/block_tridiagonal_solver.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace mrpt_ext
{
namespace
{
constexpr double kSingular = 1e-14;  // smallest over largest eigenvalue, units scaled away

bool isPositive(const Eigen::MatrixXd& information)
{
  if (information.rows() == 0) return true;
  if (!information.allFinite() || !(information.diagonal().minCoeff() > 0)) return false;
  const Eigen::VectorXd scale = information.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd unitless = scale.asDiagonal() * information * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(unitless, Eigen::EigenvaluesOnly).eigenvalues().minCoeff() >
         kSingular;
}
}  // namespace

PoseChainSystem::PoseChainSystem(std::size_t poses, Eigen::Index shared)
    : diagonal_(poses, Matrix3d::Zero()),
      above_(poses, Matrix3d::Zero()),
      side_(Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(poses), 1 + shared)),
      shared_(Eigen::MatrixXd::Zero(shared, shared)),
      shared_side_(Eigen::VectorXd::Zero(shared))
{
}

void PoseChainSystem::addReading(std::size_t pose, double residual, const JacobianRow& own, const SharedRow& shared,
                                 double weight)
{
  const auto at = 3 * static_cast<Eigen::Index>(pose);
  const Vector3d pull = weight * own.transpose();
  diagonal_[pose].noalias() += pull * own;
  side_.block<3, 1>(at, 0) += pull * residual;
  side_.middleRows<3>(at).rightCols(shared.size()).noalias() += pull * shared;
  addPrior(residual, shared, weight);
}

void PoseChainSystem::addLink(std::size_t pose, const Vector3d& residual, const Matrix3d& own, const Matrix3d& next,
                              const SharedRows& shared, double weight)
{
  const auto at = 3 * static_cast<Eigen::Index>(pose);
  const Matrix3d own_pull = weight * own.transpose(), next_pull = weight * next.transpose();
  diagonal_[pose] += own_pull * own;
  diagonal_[pose + 1] += next_pull * next;
  above_[pose] += own_pull * next;
  side_.block<3, 1>(at, 0) += own_pull * residual;
  side_.block<3, 1>(at + 3, 0) += next_pull * residual;
  side_.middleRows<3>(at).rightCols(shared.cols()).noalias() += own_pull * shared;
  side_.middleRows<3>(at + 3).rightCols(shared.cols()).noalias() += next_pull * shared;
  shared_.noalias() += weight * shared.transpose() * shared;
  shared_side_ += weight * shared.transpose() * residual;
}

void PoseChainSystem::addPrior(double residual, const SharedRow& shared, double weight)
{
  shared_.noalias() += weight * shared.transpose() * shared;
  shared_side_ += weight * residual * shared.transpose();
}

std::optional<ChainSolution> PoseChainSystem::solve() const
{
  const std::size_t n = diagonal_.size();
  ChainSolution solution;
  std::vector<Matrix3d> inverse(n), back(n);  // of the pose given all later ones; how it follows the next
  Eigen::MatrixXd side = side_;
  Matrix3d own = n > 0 ? diagonal_[0] : Matrix3d(Matrix3d::Identity());
  for (std::size_t k = 0; k < n; ++k)
  {
    const auto at = 3 * static_cast<Eigen::Index>(k);
    const Eigen::LLT<Matrix3d> llt(own);
    if (llt.info() != Eigen::Success) return std::nullopt;
    inverse[k] = llt.solve(Matrix3d::Identity());
    back[k] = inverse[k] * above_[k];
    if (k + 1 == n) break;
    own = diagonal_[k + 1] - above_[k].transpose() * back[k];
    side.middleRows<3>(at + 3) -= back[k].transpose() * side.middleRows<3>(at);
  }
  solution.covariance.assign(n, Matrix3d::Zero());
  solution.with_successor.assign(n, Matrix3d::Zero());
  for (std::size_t k = n; k-- > 0;)
  {
    const auto at = 3 * static_cast<Eigen::Index>(k);
    side.middleRows<3>(at) = (inverse[k] * side.middleRows<3>(at)).eval();
    solution.covariance[k] = inverse[k];
    if (k + 1 == n) continue;
    side.middleRows<3>(at) -= back[k] * side.middleRows<3>(at + 3);
    solution.with_successor[k] = -back[k] * solution.covariance[k + 1];
    solution.covariance[k] -= solution.with_successor[k] * back[k].transpose();
  }
  solution.pull = side.rightCols(shared_.cols());
  solution.shared_information = shared_ - side_.rightCols(shared_.cols()).transpose() * solution.pull;
  if (!isPositive(solution.shared_information)) return std::nullopt;
  const Eigen::VectorXd gradient = shared_side_ - side_.rightCols(shared_.cols()).transpose() * side.col(0);
  solution.shared_step =
      shared_.cols() > 0 ? Eigen::VectorXd(solution.shared_information.ldlt().solve(gradient)) : Eigen::VectorXd(0);
  const Eigen::VectorXd steps = side.col(0) - solution.pull * solution.shared_step;
  for (std::size_t k = 0; k < n; ++k) solution.steps.push_back(steps.segment<3>(3 * static_cast<Eigen::Index>(k)));
  return solution;
}
}  // namespace mrpt_ext
