#include "mrpt_ext/evaluation/information_bound.h"

#include <Eigen/Dense>

namespace mrpt_ext
{
namespace
{
// Eigenvalues of the scaled matrix below this count as zero; rounding leaves about 1e-16.
constexpr double kRankTolerance = 1e-12;

Eigen::VectorXd diagonalScale(const Eigen::MatrixXd& information)
{
  return information.diagonal().unaryExpr([](double v) { return v > 0 ? 1.0 / std::sqrt(v) : 0.0; });
}
}  // namespace

int informationRank(const Eigen::MatrixXd& information)
{
  const Eigen::VectorXd scale = diagonalScale(information);
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues();
  return static_cast<int>((eigenvalues.array() > kRankTolerance).count());
}

std::optional<InformationBound> informationBound(const Eigen::MatrixXd& information)
{
  const auto n = information.rows();
  if (n < 2 || !information.allFinite() || informationRank(information) < n) return std::nullopt;
  const Eigen::VectorXd scale = diagonalScale(information);
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  InformationBound bound;
  bound.covariance = scale.asDiagonal() * scaled.ldlt().solve(Eigen::MatrixXd::Identity(n, n)) * scale.asDiagonal();
  bound.position_rms = std::sqrt(bound.covariance(0, 0) + bound.covariance(1, 1));
  return bound;
}
}  // namespace mrpt_ext
