#include "mrpt_ext/diagnosis/innovation_regression.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kLeastBlocks = 12;
constexpr double kLeastIndependence = 1e-6;  // share of the information on an unknown that no other one explains
constexpr double kSelected = 5;              // standard deviations, for a dozen unknowns in every run
}  // namespace

InnovationRegression::InnovationRegression(std::vector<CalibrationUnknown> unknowns, std::size_t nuisances)
    : unknowns_(std::move(unknowns)),
      nuisances_(nuisances),
      blocks_({Eigen::MatrixXd::Zero(size(), size()), Eigen::VectorXd::Zero(size())}),
      effect_(Eigen::VectorXd::Zero(size()))
{
}

void InnovationRegression::add(const SensitiveInnovation& innovation)
{
  blocks_.open().information.noalias() += innovation.sensitivity.transpose() * innovation.sensitivity;
  blocks_.open().score.noalias() += innovation.sensitivity.transpose() * innovation.value;
}

void InnovationRegression::endFrame(const BiasFreeFilter& filter)
{
  if (const Eigen::LLT<Matrix3d> factor(filter.pose().covariance); factor.info() == Eigen::Success)
  {
    effect_ += factor.matrixL().solve(filter.sensitivity()).colwise().squaredNorm().transpose() / 3;
    ++frames_;
  }
  blocks_.endItem();
}

std::optional<InnovationRegression::Fit> InnovationRegression::fit(const std::vector<Eigen::Index>& chosen) const
{
  const auto n = static_cast<Eigen::Index>(chosen.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n), spread = information;
  Eigen::VectorXd score = Eigen::VectorXd::Zero(n);
  for (const Block& block : blocks_.complete())
  {
    information += block.information(chosen, chosen);
    score += block.score(chosen);
  }
  // Scaled to a unit diagonal, so that units do not matter.
  const Eigen::VectorXd scale = information.diagonal().cwiseSqrt();
  if (!(scale.minCoeff() > 0)) return std::nullopt;
  const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * information * scale.cwiseInverse().asDiagonal();
  const Eigen::LDLT<Eigen::MatrixXd> factor(scaled);
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > kLeastIndependence)) return std::nullopt;
  const Eigen::MatrixXd inverse = scale.cwiseInverse().asDiagonal() * factor.solve(Eigen::MatrixXd::Identity(n, n)) *
                                  scale.cwiseInverse().asDiagonal();
  const Eigen::VectorXd values = inverse * score;
  for (const Block& block : blocks_.complete())
  {
    const Eigen::VectorXd left = block.score(chosen) - block.information(chosen, chosen) * values;
    spread += left * left.transpose();
  }
  const auto blocks = static_cast<double>(blocks_.complete().size());
  const Eigen::MatrixXd sandwich = blocks / (blocks - static_cast<double>(n)) * inverse * spread * inverse;
  return Fit{values, inverse.diagonal().cwiseMax(sandwich.diagonal()).cwiseSqrt()};
}

std::optional<Eigen::Index> InnovationRegression::mostSignificant(const std::vector<Eigen::Index>& chosen) const
{
  std::optional<Eigen::Index> best;
  double most = kSelected;
  for (auto k = static_cast<Eigen::Index>(nuisances_); k < effect_.size(); ++k)
  {
    if (std::find(chosen.begin(), chosen.end(), k) != chosen.end()) continue;
    std::vector<Eigen::Index> more = chosen;
    more.push_back(k);
    const std::optional<Fit> found = fit(more);
    if (!found) continue;
    const Eigen::Index last = found->values.size() - 1;
    const double significance = std::abs(found->values[last]) / found->stds[last];
    if (!(significance > most)) continue;
    most = significance;
    best = k;
  }
  return best;
}

std::vector<RegressedError> InnovationRegression::significantErrors() const
{
  if (blocks_.complete().size() < kLeastBlocks || frames_ == 0) return {};
  std::vector<Eigen::Index> chosen;
  for (std::size_t k = 0; k < nuisances_; ++k) chosen.push_back(static_cast<Eigen::Index>(k));
  while (const auto next = mostSignificant(chosen)) chosen.push_back(*next);
  if (chosen.size() == nuisances_) return {};
  const std::optional<Fit> found = fit(chosen);
  if (!found) return {};
  std::vector<RegressedError> errors;
  for (std::size_t j = nuisances_; j < chosen.size(); ++j)
  {
    const auto row = static_cast<Eigen::Index>(j);
    const double value = found->values[row], std = found->stds[row];
    if (std::abs(value) > kSelected * std)
      errors.push_back({unknowns_[static_cast<std::size_t>(chosen[j])], value, std,
                        std::abs(value) * std::sqrt(effect_[chosen[j]] / frames_)});
  }
  return errors;
}
}  // namespace mrpt_ext
