#pragma once

#include <Eigen/Core>
#include <vector>

namespace mrpt_ext
{
/// What the data of a linear model tell of its parameters: the information and, times it, their estimate.
struct LinearEvidence
{
  Eigen::MatrixXd information;
  Eigen::VectorXd weighted;
};

/// What is known of parameters before any data: standard deviations that a prior has at least and at most.
struct PriorStds
{
  Eigen::VectorXd least, most;
};

struct RelevantParameters
{
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;  ///< zero where the prior is
};

/// Parameters of which most are about zero, and nobody knows which: the prior of each one is as wide as the parameter
/// seems large, given the others (automatic relevance determination: MacKay 1994; one parameter after the other:
/// Tipping and Faul, Fast marginal likelihood maximisation for sparse Bayesian models, AISTATS 2003). So one error is
/// explained by the one parameter that fits it, not by a little of each.
///
/// The prior that makes the data most likely is narrower by the variance of that estimate. Without it parameters that
/// are hardly known keep their uncertainty. Parameters that are never exactly zero have a least standard deviation,
/// which is uncertainty enough: their priors are those that make the data most likely.
class Relevance
{
 public:
  /// Determines the priors of some parameters, in turn, given those of the others as they were found before.
  void update(const LinearEvidence& evidence, const PriorStds& prior);
  [[nodiscard]] RelevantParameters posterior(const LinearEvidence& evidence) const;
  /// What the data tell of some parameters alone, with the others as their priors say.
  [[nodiscard]] LinearEvidence marginal(const LinearEvidence& evidence,
                                        const std::vector<Eigen::Index>& parameters) const;

 private:
  [[nodiscard]] std::vector<Eigen::Index> relevant() const;

  Eigen::Index next_ = 0;
  Eigen::VectorXd variances_;  // of the priors
};
}  // namespace mrpt_ext
