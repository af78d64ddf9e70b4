#include "mrpt_ext/calibration/trajectory_adjustment.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mrpt_ext/calibration/parameter_limits.h"
#include "mrpt_ext/calibration/robust_loss.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSettled = 1e-3;          // step over its standard deviation
constexpr double kLoosePose = 1e-6;        // [1/m^2], [1/rad^2] keeps poses without constraints solvable
constexpr double kLeastRedundancy = 0.05;  // of a residual; below, it carries no information about its scatter
constexpr double kLeastScatter = 0.1, kMostScatter = 30;
// Slips belong to odometry: scales are to be right on the whole, not for the stretches without slip. Only a robot that
// was picked up does not count.
constexpr double kSlip2 = 400;  // squared standard deviations
constexpr int kMostBlocks = 30, kLeastBlocks = 8;
constexpr double kScatterStep = 0.05;  // of a logarithm, for a derivative
constexpr int kScatterSteps = 3;       // of the adjustment that follow it

/// Of one kind, by one sensor.
struct Residuals
{
  std::vector<double> sizes;  // over the declared standard deviation, and over what the poses leave of it
  double redundancy = 0;
};

/// Median absolute deviation. The outliers are left out of it: they shift the median of the others.
double scatterFrom(std::vector<double> sizes)
{
  if (sizes.empty()) return 1;
  const double all = 1.4826 * upperMedian(sizes);
  std::erase_if(sizes, [&](double size) { return size > kOutlierMisfit * all; });
  return std::clamp(1.4826 * upperMedian(std::move(sizes)), kLeastScatter, kMostScatter);
}

}  // namespace

TrajectoryAdjustment::TrajectoryAdjustment(const CalibrationProblem& problem, std::vector<CalibrationUnknown> unknowns)
    : problem_(problem), model_(problem, std::move(unknowns)), scatters_(problem.sensors)
{
  for (const TrajectoryPose& pose : problem.poses) poses_.push_back(pose.pose);
  for (const CalibrationReading& r : problem.readings)
    ++(r.is_range ? scatters_[r.sensor].ranges : scatters_[r.sensor].bearings);
}

double TrajectoryAdjustment::scatterOf(const CalibrationReading& r) const
{
  return r.is_range ? scatters_[r.sensor].range : scatters_[r.sensor].bearing;
}

/// Never below what is declared: neighbouring readings with correlated errors scatter less than they err, and poses
/// that followed them would make odometry appear wrong.
double TrajectoryAdjustment::assumedScatterOf(const CalibrationReading& r) const { return std::max(1.0, scatterOf(r)); }

void TrajectoryAdjustment::restart(const TrajectoryAdjustment& start, const Eigen::VectorXd& errors)
{
  poses_ = start.poses_;
  scatters_ = start.scatters_;
  odometry_scatter_ = start.odometry_scatter_;
  model_.setErrors(errors);
}

void TrajectoryAdjustment::continueFrom(const TrajectoryAdjustment& start)
{
  scatters_ = start.scatters_;
  odometry_scatter_ = start.odometry_scatter_;
  steps_ = start.steps_;
  model_.setErrors(start.model_.errors());
}

PoseChainSystem TrajectoryAdjustment::linearized() const
{
  PoseChainSystem chain(poses_.size(), model_.errors().size());
  for (const CalibrationReading& r : problem_.readings)
  {
    const ReadingResidual row = model_.reading(r, poses_[r.pose]);
    const double scatter = assumedScatterOf(r),
                 weight = robust::weight(square(row.residual / scatter)) / square(scatter);
    chain.addReading(r.pose, row.residual, row.own, row.shared, weight);
  }
  for (std::size_t k = 0; k < poses_.size(); ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
      chain.addReading(k, 0, JacobianRow::Unit(axis), Eigen::RowVectorXd::Zero(model_.errors().size()), kLoosePose);
    if (k == 0 || !problem_.poses[k].since_previous) continue;
    const OdometryResidual row = model_.link(k, poses_[k - 1], poses_[k]);
    const double weight = robust::weight((linkScale() * row.residual).squaredNorm(), kSlip2) * square(linkScale());
    chain.addLink(k - 1, row.residual, row.own, row.next, row.shared, weight);
  }
  for (std::size_t k = 0; k < model_.unknowns().size(); ++k)
  {
    const auto i = static_cast<Eigen::Index>(k);
    chain.addPrior(-model_.errors()[i], Eigen::RowVectorXd::Unit(model_.errors().size(), i),
                   1 / square(priorStd(problem_, model_.unknowns()[k])));
  }
  return chain;
}

double TrajectoryAdjustment::cost() const
{
  double cost = 0;
  for (const CalibrationReading& r : problem_.readings)
    cost += robust::loss(square(model_.reading(r, poses_[r.pose]).residual / assumedScatterOf(r)));
  for (std::size_t k = 1; k < poses_.size(); ++k)
    if (problem_.poses[k].since_previous)
      cost += robust::loss((linkScale() * model_.linkResidual(k, poses_[k - 1], poses_[k])).squaredNorm(), kSlip2);
  for (std::size_t k = 0; k < model_.unknowns().size(); ++k)
    cost += square(model_.errors()[static_cast<Eigen::Index>(k)] / priorStd(problem_, model_.unknowns()[k]));
  return cost;
}

void TrajectoryAdjustment::move(const ChainSolution& solution, double share, const std::vector<Pose2>& from,
                                const Eigen::VectorXd& errors)
{
  for (std::size_t k = 0; k < poses_.size(); ++k) poses_[k] = added(from[k], share * solution.steps[k]);
  model_.setErrors(errors + share * solution.shared_step);
}

bool TrajectoryAdjustment::descend(int most_steps)
{
  double before = cost();
  for (int k = 0; k < most_steps; ++k, ++steps_)
  {
    const std::optional<ChainSolution> solution = linearized().solve();
    if (!solution || !solution->shared_step.allFinite()) return false;
    const std::vector<Pose2> from = poses_;
    const Eigen::VectorXd errors = model_.errors();
    double share = 1, after = 0;
    for (;; share /= 3)
    {
      move(*solution, share, from, errors);
      after = cost();
      if (after <= before || share < 0.01) break;
    }
    const double step2 = solution->shared_step.dot(solution->shared_information * solution->shared_step);
    const bool settled = step2 < square(kSettled) && before - after < 1e-4 * before;
    before = after;
    if (settled) break;
  }
  return std::isfinite(before);
}

bool TrajectoryAdjustment::estimateScatters()
{
  const std::optional<ChainSolution> solution = linearized().solve();
  if (!solution) return false;
  std::vector<Residuals> bearings(problem_.sensors), ranges(problem_.sensors);
  for (const CalibrationReading& r : problem_.readings)
  {
    const ReadingResidual row = model_.reading(r, poses_[r.pose]);
    const double weight = robust::weight(square(row.residual / assumedScatterOf(r)));
    const double explained = row.own.dot(row.own * solution->covariance[r.pose]) / square(assumedScatterOf(r));
    const double redundancy = std::max(1 - weight * explained, kLeastRedundancy);
    Residuals& residuals = (r.is_range ? ranges : bearings)[r.sensor];
    residuals.sizes.push_back(std::abs(row.residual) / std::sqrt(redundancy));
    residuals.redundancy += weight * redundancy;
  }
  const LinkFit odometry = linkFits(*solution).rowwise().sum();
  for (std::size_t s = 0; s < problem_.sensors; ++s)
  {
    scatters_[s].bearing = scatterFrom(bearings[s].sizes);
    scatters_[s].range = scatterFrom(ranges[s].sizes);
    scatters_[s].bearing_redundancy = bearings[s].redundancy;
    scatters_[s].range_redundancy = ranges[s].redundancy;
  }
  odometry_redundancy_ = odometry[1];
  if (odometry[1] > 10)
    odometry_scatter_ = std::clamp(std::sqrt(odometry[0] / odometry[1]), kLeastScatter, kMostScatter);
  return true;
}

Eigen::Matrix2Xd TrajectoryAdjustment::linkFits(const ChainSolution& solution) const
{
  Eigen::Matrix2Xd fits = Eigen::Matrix2Xd::Zero(2, static_cast<Eigen::Index>(poses_.size()));
  for (std::size_t k = 1; k < poses_.size(); ++k)
  {
    if (!problem_.poses[k].since_previous) continue;
    const OdometryResidual row = model_.link(k, poses_[k - 1], poses_[k]);
    const double weight = robust::weight((linkScale() * row.residual).squaredNorm(), kSlip2);
    const Matrix3d cross = row.own * solution.with_successor[k - 1] * row.next.transpose();
    const Matrix3d explained = row.own * solution.covariance[k - 1] * row.own.transpose() +
                               row.next * solution.covariance[k] * row.next.transpose() + cross + cross.transpose();
    fits.col(static_cast<Eigen::Index>(k)) << weight * row.residual.squaredNorm(),
        weight * std::max(3 - weight * square(linkScale()) * explained.trace(), 0.0);
  }
  return fits;
}

std::optional<Eigen::VectorXd> TrajectoryAdjustment::scatterScores(double scatter) const
{
  TrajectoryAdjustment other = *this;
  other.odometry_scatter_ = scatter;
  if (!other.descend(kScatterSteps)) return std::nullopt;
  const std::optional<ChainSolution> solution = other.linearized().solve();
  if (!solution) return std::nullopt;
  const Eigen::Matrix2Xd fits = other.linkFits(*solution);
  const auto blocks = static_cast<Eigen::Index>(std::min<std::size_t>(kMostBlocks, poses_.size()));
  Eigen::VectorXd scores = Eigen::VectorXd::Zero(blocks);
  for (Eigen::Index k = 0; k < fits.cols(); ++k)
    scores[k * blocks / fits.cols()] += fits(0, k) / square(scatter) - fits(1, k);
  return scores;
}

double TrajectoryAdjustment::odometryScatterStd() const
{
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const auto here = scatterScores(odometry_scatter_), above = scatterScores(odometry_scatter_ * std::exp(kScatterStep)),
             below = scatterScores(odometry_scatter_ * std::exp(-kScatterStep));
  if (!here || !above || !below) return kUnknown;
  const double information = (below->sum() - above->sum()) / (2 * kScatterStep);
  if (!(information > 0)) return kUnknown;
  double variance = 1 / information;
  if (const auto blocks = static_cast<double>(here->size()); here->size() >= kLeastBlocks)
    variance = std::max(variance, blocks / (blocks - 1) * here->squaredNorm() / square(information));
  return odometry_scatter_ * std::sqrt(variance);
}

std::vector<double> TrajectoryAdjustment::misfits() const
{
  std::vector<double> misfits;
  for (const CalibrationReading& r : problem_.readings)
    misfits.push_back(model_.reading(r, poses_[r.pose]).residual / scatterOf(r));
  return misfits;
}

/// Gradient by the unknowns of each block of time, with the poses eliminated; one row per block. `curvature`: second
/// derivative of the losses over the weights that stand for it in the normal equations.
Eigen::MatrixXd TrajectoryAdjustment::scoresByBlock(const ChainSolution& solution, double& curvature) const
{
  const Eigen::Index unknowns = model_.errors().size();
  const auto poses = static_cast<Eigen::Index>(poses_.size());
  const Eigen::Index blocks = std::min<Eigen::Index>(kMostBlocks, poses / 10);
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(blocks, unknowns);
  if (blocks < kLeastBlocks) return scores;
  const auto block_of = [&](std::size_t k) { return static_cast<Eigen::Index>(k) * blocks / poses; };
  const auto pull_of = [&](std::size_t k) { return solution.pull.middleRows<3>(3 * static_cast<Eigen::Index>(k)); };
  double weights = 0, curvatures = 0;
  for (const CalibrationReading& r : problem_.readings)
  {
    const ReadingResidual row = model_.reading(r, poses_[r.pose]);
    const double scatter = assumedScatterOf(r), e2 = square(row.residual / scatter);
    const Eigen::RowVectorXd reduced = row.shared - row.own * pull_of(r.pose);
    scores.row(block_of(r.pose)) += robust::weight(e2) * row.residual / square(scatter) * reduced;
    weights += robust::weight(e2);
    curvatures += robust::curvature(e2);
  }
  for (std::size_t k = 1; k < poses_.size(); ++k)
  {
    if (!problem_.poses[k].since_previous) continue;
    const OdometryResidual row = model_.link(k, poses_[k - 1], poses_[k]);
    const double weight = robust::weight((linkScale() * row.residual).squaredNorm(), kSlip2) * square(linkScale());
    const Eigen::MatrixXd reduced = row.shared - row.own * pull_of(k - 1) - row.next * pull_of(k);
    scores.row(block_of(k)) += weight * row.residual.transpose() * reduced;
  }
  curvature = std::clamp(curvatures / weights, 0.3, 1.0);
  return scores;
}

std::optional<Eigen::VectorXd> TrajectoryAdjustment::standardDeviations() const
{
  const std::optional<ChainSolution> solution = linearized().solve();
  if (!solution) return std::nullopt;
  const Eigen::MatrixXd inverse = solution->shared_information.inverse();
  double curvature = 1;
  const Eigen::MatrixXd scores = scoresByBlock(*solution, curvature);
  Eigen::VectorXd variance = inverse.diagonal();
  if (const auto blocks = static_cast<double>(scores.rows()); scores.rows() >= kLeastBlocks)
  {
    const Eigen::MatrixXd sandwich = inverse * (scores.transpose() * scores) * inverse;
    variance = variance.cwiseMax(blocks / (blocks - 1) * sandwich.diagonal());
  }
  return Eigen::VectorXd(variance.cwiseMax(0).cwiseSqrt() / curvature);
}
}  // namespace mrpt_ext
