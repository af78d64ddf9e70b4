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
constexpr double kSettled = 1e-3;            // step over its standard deviation
constexpr double kLoosePose = 1e-6;          // [1/m^2], [1/rad^2] keeps poses without constraints solvable
constexpr double kLeastRedundancy = 0.05;    // of a residual; below, it carries no information about its scatter
constexpr double kLeastLinkRedundancy = 10;  // of all links, likewise
constexpr double kLeastScatter = 0.1, kMostScatter = 30;
// Slips belong to odometry: scales are to be right on the whole, not for the stretches without slip. Only a robot that
// was picked up does not count.
constexpr double kSlip2 = 400;              // squared standard deviations
constexpr double kLeastLandmarkStd = 0.02;  // of landmarks' offsets, over the deviation of a range
constexpr double kLeastTold = 0.01;         // of all landmarks' offsets
constexpr int kMostBlocks = 30, kLeastBlocks = 8;
constexpr double kScatterStep = 0.05;  // of a logarithm, for a derivative
constexpr int kScatterSteps = 3;       // of the adjustment that follow it

/// Of one kind, by one sensor.
struct Residuals
{
  std::vector<double> sizes;  // over the declared standard deviation, and over what the poses leave of it
  double redundancy = 0, taken_up = 0;
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
  for (const CalibrationUnknown& unknown : model_.unknowns())
    if (isOfLandmark(unknown.parameter)) landmark_errors_[landmarkErrorsOf(unknown)].std = priorStd(problem, unknown);
}

TrajectoryAdjustment::LandmarkErrors TrajectoryAdjustment::landmarkErrorsOf(const CalibrationUnknown& unknown)
{
  return {unknown.sensor, isOfMap(unknown.parameter)};
}

double TrajectoryAdjustment::priorOf(const CalibrationUnknown& unknown) const
{
  return isOfLandmark(unknown.parameter) ? landmark_errors_.at(landmarkErrorsOf(unknown)).std
                                         : priorStd(problem_, unknown);
}

double TrajectoryAdjustment::scatterOf(const CalibrationReading& r) const
{
  return r.is_range ? scatters_[r.sensor].range : scatters_[r.sensor].bearing;
}

/// Never below what is declared: neighbouring readings with correlated errors scatter less than they err, and poses
/// that followed them would make odometry appear wrong.
double TrajectoryAdjustment::assumedScatterOf(const CalibrationReading& r) const { return std::max(1.0, scatterOf(r)); }

ReadingLoss TrajectoryAdjustment::lossOf(const CalibrationReading& r, double residual) const
{
  const double scatter = assumedScatterOf(r);
  return outliers_.lossOf(r, square(residual / scatter), scatter);
}

void TrajectoryAdjustment::tellOutliers()
{
  outliers_.tell(problem_);
  estimateOutlierShares();
}

void TrajectoryAdjustment::estimateOutlierShares()
{
  std::vector<double> weights;
  for (const CalibrationReading& r : problem_.readings)
    weights.push_back(lossOf(r, model_.reading(r, poses_[r.pose]).residual).weight);
  outliers_.estimateShares(problem_, weights);
}

void TrajectoryAdjustment::restart(const TrajectoryAdjustment& start, const Eigen::VectorXd& errors)
{
  poses_ = start.poses_;
  scatters_ = start.scatters_;
  landmark_errors_ = start.landmark_errors_;
  model_.setOdometryScatter(start.model_.odometryScatter());
  model_.setErrors(errors);
}

void TrajectoryAdjustment::continueFrom(const TrajectoryAdjustment& start)
{
  scatters_ = start.scatters_;
  landmark_errors_ = start.landmark_errors_;
  model_.setOdometryScatter(start.model_.odometryScatter());
  steps_ = start.steps_;
  model_.setErrors(start.model_.errors());
}

PoseChainSystem TrajectoryAdjustment::linearized() const
{
  PoseChainSystem chain(poses_.size(), model_.errors().size());
  for (const CalibrationReading& r : problem_.readings)
  {
    const ReadingResidual row = model_.reading(r, poses_[r.pose]);
    const double weight = lossOf(r, row.residual).weight / square(assumedScatterOf(r));
    chain.addReading(r.pose, row.residual, row.own, row.shared, weight);
  }
  for (std::size_t k = 0; k < poses_.size(); ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
      chain.addReading(k, 0, JacobianRow::Unit(axis), Eigen::RowVectorXd::Zero(model_.errors().size()), kLoosePose);
    if (k == 0 || !problem_.poses[k].since_previous) continue;
    const OdometryResidual row = model_.link(k, poses_[k - 1], poses_[k]);
    const double weight = robust::weight(row.residual.squaredNorm(), kSlip2);
    chain.addLink(k - 1, row.residual, row.own, row.next, row.shared, weight);
  }
  for (std::size_t k = 0; k < model_.unknowns().size(); ++k)
  {
    const auto i = static_cast<Eigen::Index>(k);
    chain.addPrior(-model_.errors()[i], Eigen::RowVectorXd::Unit(model_.errors().size(), i),
                   1 / square(priorOf(model_.unknowns()[k])));
  }
  return chain;
}

double TrajectoryAdjustment::cost() const
{
  double cost = 0;
  for (const CalibrationReading& r : problem_.readings)
    cost += lossOf(r, model_.reading(r, poses_[r.pose]).residual).loss;
  for (std::size_t k = 1; k < poses_.size(); ++k)
    if (problem_.poses[k].since_previous)
      cost += robust::loss(model_.linkResidual(k, poses_[k - 1], poses_[k]).squaredNorm(), kSlip2);
  for (std::size_t k = 0; k < model_.unknowns().size(); ++k)
    cost += square(model_.errors()[static_cast<Eigen::Index>(k)] / priorOf(model_.unknowns()[k]));
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
    const double weight = lossOf(r, row.residual).weight;
    const double explained = row.own.dot(row.own * solution->covariance[r.pose]) / square(assumedScatterOf(r));
    const double redundancy = std::max(1 - weight * explained, kLeastRedundancy);
    Residuals& residuals = (r.is_range ? ranges : bearings)[r.sensor];
    residuals.sizes.push_back(std::abs(row.residual) / std::sqrt(redundancy));
    residuals.redundancy += weight * redundancy;
    residuals.taken_up += weight * (1 - redundancy);
  }
  const LinkFits odometry = linkFits(*solution);
  for (std::size_t s = 0; s < problem_.sensors; ++s)
  {
    scatters_[s].bearing = scatterFrom(bearings[s].sizes);
    scatters_[s].range = scatterFrom(ranges[s].sizes);
    scatters_[s].bearing_redundancy = bearings[s].redundancy;
    scatters_[s].range_redundancy = ranges[s].redundancy;
    scatters_[s].bearing_taken_up = bearings[s].taken_up;
    scatters_[s].range_taken_up = ranges[s].taken_up;
  }
  PerMotionNoise<double> scatter = model_.odometryScatter();
  for (std::size_t n = 0; n < motion_noises; ++n)
  {
    const auto row = static_cast<Eigen::Index>(n);
    odometry_redundancy_[n] = odometry.redundancy.row(row).sum();
    if (odometry_redundancy_[n] < kLeastLinkRedundancy) continue;
    const double excess = std::log(std::max(odometry.misfit.row(row).sum() / odometry_redundancy_[n], 1e-6));
    scatter[n] =
        std::clamp(scatter[n] * std::exp(search_[n].step(std::log(scatter[n]), excess)), kLeastScatter, kMostScatter);
  }
  model_.setOdometryScatter(scatter);
  estimateLandmarkStds(*solution);
  if (outliers_.told()) estimateOutlierShares();
  return true;
}

void TrajectoryAdjustment::estimateLandmarkStds(const ChainSolution& solution)
{
  if (landmark_errors_.empty()) return;
  const std::vector<CalibrationUnknown>& unknowns = model_.unknowns();
  std::map<LandmarkErrors, double> squares, told, least;
  const Eigen::VectorXd variances = Eigen::MatrixXd(solution.shared_information.inverse()).diagonal();
  for (std::size_t k = 0; k < unknowns.size(); ++k)
  {
    if (!isOfLandmark(unknowns[k].parameter)) continue;
    const LandmarkErrors of = landmarkErrorsOf(unknowns[k]);
    const auto i = static_cast<Eigen::Index>(k);
    squares[of] += square(model_.errors()[i]);
    told[of] += std::max(1 - variances[i] / square(landmark_errors_[of].std), 0.0);
    least[of] = kLeastLandmarkStd * priorStd(problem_, unknowns[k]);
  }
  for (auto& [of, errors] : landmark_errors_)
  {
    errors.told = told[of];
    if (errors.told > kLeastTold) errors.std = std::max(std::sqrt(squares[of] / errors.told), least[of]);
    (of.of_map ? scatters_[of.sensor].landmark_place_std : scatters_[of.sensor].landmark_offset_std) = errors.std;
  }
}

TrajectoryAdjustment::LinkFits TrajectoryAdjustment::linkFits(const ChainSolution& solution) const
{
  const LinkFits::ByLink none = LinkFits::ByLink::Zero(motion_noises, static_cast<Eigen::Index>(poses_.size()));
  LinkFits fits{none, none};
  for (std::size_t k = 1; k < poses_.size(); ++k)
  {
    if (!problem_.poses[k].since_previous) continue;
    const OdometryResidual row = model_.link(k, poses_[k - 1], poses_[k]);
    const double weight = robust::weight(row.residual.squaredNorm(), kSlip2);
    const Matrix3d cross = row.own * solution.with_successor[k - 1] * row.next.transpose();
    const Matrix3d explained = row.own * solution.covariance[k - 1] * row.own.transpose() +
                               row.next * solution.covariance[k] * row.next.transpose() + cross + cross.transpose();
    const Matrix3d unexplained = Matrix3d::Identity() - weight * explained;
    for (const MotionNoise noise : {position_noise, heading_noise})
    {
      const Matrix3d share = model_.linkCovariance(k, noise);
      const auto n = static_cast<Eigen::Index>(noise), link = static_cast<Eigen::Index>(k);
      fits.misfit(n, link) = weight * row.residual.dot(share * row.residual);
      fits.redundancy(n, link) = weight * std::max((share * unexplained).trace(), 0.0);
    }
  }
  return fits;
}

std::optional<TrajectoryAdjustment::LinkFits::ByLink> TrajectoryAdjustment::scatterScores(
    const PerMotionNoise<double>& scatter) const
{
  TrajectoryAdjustment other = *this;
  other.model_.setOdometryScatter(scatter);
  if (!other.descend(kScatterSteps)) return std::nullopt;
  const std::optional<ChainSolution> solution = other.linearized().solve();
  if (!solution) return std::nullopt;
  const LinkFits fits = other.linkFits(*solution);
  const auto blocks = static_cast<Eigen::Index>(std::min<std::size_t>(kMostBlocks, poses_.size()));
  LinkFits::ByLink scores = LinkFits::ByLink::Zero(motion_noises, blocks);
  for (Eigen::Index k = 0; k < fits.misfit.cols(); ++k)
    scores.col(k * blocks / fits.misfit.cols()) += fits.misfit.col(k) - fits.redundancy.col(k);
  return scores;
}

PerMotionNoise<double> TrajectoryAdjustment::odometryScatterStd() const
{
  using NoiseMatrix = Eigen::Matrix<double, motion_noises, motion_noises>;
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const PerMotionNoise<double>& scatter = model_.odometryScatter();
  const auto scores = scatterScores(scatter);
  if (!scores) return {kUnknown, kUnknown};
  NoiseMatrix information;
  for (std::size_t n = 0; n < motion_noises; ++n)
  {
    PerMotionNoise<double> more = scatter, less = scatter;
    more[n] *= std::exp(kScatterStep);
    less[n] *= std::exp(-kScatterStep);
    const auto above = scatterScores(more), below = scatterScores(less);
    if (!above || !below) return {kUnknown, kUnknown};
    information.col(static_cast<Eigen::Index>(n)) = (*below - *above).rowwise().sum() / (2 * kScatterStep);
  }
  information = (0.5 * (information + information.transpose())).eval();
  // A noise that nothing tells leaves the other one as it is.
  if (!(information.determinant() > 0 && information(0, 0) > 0))
    information = NoiseMatrix(information.diagonal().asDiagonal());
  PerMotionNoise<double> stds{kUnknown, kUnknown};
  const NoiseMatrix inverse = information.inverse();
  const auto blocks = static_cast<double>(scores->cols());
  const NoiseMatrix sandwich = blocks / (blocks - 1) * inverse * (*scores * scores->transpose()) * inverse;
  for (std::size_t n = 0; n < motion_noises; ++n)
  {
    const auto i = static_cast<Eigen::Index>(n);
    if (!(information(i, i) > 0)) continue;
    const double variance = blocks >= kLeastBlocks ? std::max(inverse(i, i), sandwich(i, i)) : inverse(i, i);
    stds[n] = scatter[n] * std::sqrt(variance);
  }
  return stds;
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
    const ReadingLoss loss = lossOf(r, row.residual);
    const Eigen::RowVectorXd reduced = row.shared - row.own * pull_of(r.pose);
    scores.row(block_of(r.pose)) += loss.weight * row.residual / square(assumedScatterOf(r)) * reduced;
    weights += loss.weight;
    curvatures += loss.curvature;
  }
  for (std::size_t k = 1; k < poses_.size(); ++k)
  {
    if (!problem_.poses[k].since_previous) continue;
    const OdometryResidual row = model_.link(k, poses_[k - 1], poses_[k]);
    const double weight = robust::weight(row.residual.squaredNorm(), kSlip2);
    const Eigen::MatrixXd reduced = row.shared - row.own * pull_of(k - 1) - row.next * pull_of(k);
    scores.row(block_of(k)) += weight * row.residual.transpose() * reduced;
  }
  curvature = std::clamp(curvatures / weights, 0.3, 1.0);
  return scores;
}

std::optional<TrajectoryAdjustment::Uncertainty> TrajectoryAdjustment::uncertainty() const
{
  const std::optional<ChainSolution> solution = linearized().solve();
  if (!solution) return std::nullopt;
  const Eigen::MatrixXd inverse = solution->shared_information.inverse();
  double curvature = 1;
  const Eigen::MatrixXd scores = scoresByBlock(*solution, curvature);
  Eigen::VectorXd variance = inverse.diagonal();
  if (const auto blocks = static_cast<double>(scores.rows()); scores.rows() >= kLeastBlocks)
  {
    Eigen::MatrixXd spread = blocks / (blocks - 1) * scores.transpose() * scores;
    for (std::size_t k = 0; k < model_.unknowns().size(); ++k)
      if (const CalibrationUnknown& unknown = model_.unknowns()[k]; isOfLandmark(unknown.parameter))
        // Their deviation is told by few: Student's t instead of Gaussian, to second order.
        spread.diagonal()[static_cast<Eigen::Index>(k)] +=
            (1 + 2 / std::max(landmark_errors_.at(landmarkErrorsOf(unknown)).told, 1.0)) / square(priorOf(unknown));
    variance = variance.cwiseMax((inverse * spread * inverse).diagonal());
  }
  return Uncertainty{inverse, variance.cwiseMax(0).cwiseSqrt() / curvature};
}
}  // namespace mrpt_ext
