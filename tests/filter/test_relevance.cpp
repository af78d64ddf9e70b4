#include "mrpt_ext/filter/consider/relevance.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_relevance
{
namespace
{
/// Of parameters that may all be zero.
PriorStds upTo(Eigen::Index count, double most)
{
  return {Eigen::VectorXd::Zero(count), Eigen::VectorXd::Constant(count, most)};
}

/// Measurements y = x theta + noise of standard deviation 1, the columns of x nearly alike.
LinearEvidence measured(const Eigen::VectorXd& truth, double likeness, int count, std::uint64_t seed)
{
  RandomStream random(seed, 1);
  LinearEvidence evidence{Eigen::MatrixXd::Zero(truth.size(), truth.size()), Eigen::VectorXd::Zero(truth.size())};
  for (int i = 0; i < count; ++i)
  {
    const double common = random.gaussian();
    Eigen::VectorXd x(truth.size());
    for (double& value : x) value = likeness * common + (1 - likeness) * random.gaussian();
    const double y = x.dot(truth) + random.gaussian();
    evidence.information += x * x.transpose();
    evidence.weighted += x * y;
  }
  return evidence;
}

RelevantParameters determined(const LinearEvidence& evidence, const PriorStds& prior)
{
  Relevance relevance;
  for (int i = 0; i < 20; ++i) relevance.update(evidence, prior);
  return relevance.posterior(evidence);
}

TEST(Relevance, KnowsNothingWithoutData)
{
  const LinearEvidence nothing{Eigen::MatrixXd::Zero(3, 3), Eigen::VectorXd::Zero(3)};
  const RelevantParameters found = determined(nothing, upTo(3, 1));
  EXPECT_EQ(found.mean.norm(), 0);
  EXPECT_EQ(found.covariance.norm(), 0);
}

TEST(Relevance, AParameterThatIsNeverZeroHasItsPriorUntilTheDataSayMore)
{
  const PriorStds prior{Eigen::Vector2d(0, 0.5), Eigen::Vector2d(1, 1)};
  const LinearEvidence nothing{Eigen::MatrixXd::Zero(2, 2), Eigen::VectorXd::Zero(2)};
  EXPECT_NEAR(determined(nothing, prior).covariance(1, 1), 0.25, 1e-12);
  EXPECT_EQ(determined(nothing, prior).covariance(0, 0), 0);
  const RelevantParameters found = determined(measured(Eigen::Vector2d::Zero(), 0, 400, 3), prior);
  EXPECT_NEAR(found.covariance(1, 1), 1 / 400.0, 1e-3);
}

// However large an estimate of next to no data is.
TEST(Relevance, AParameterThatIsNeverZeroIsNotTakenForLargeByChance)
{
  const PriorStds prior{Eigen::VectorXd::Constant(1, 0.05), Eigen::VectorXd::Constant(1, 0.2)};
  const LinearEvidence little{Eigen::MatrixXd::Constant(1, 1, 1e-6), Eigen::VectorXd::Constant(1, 5e-4)};
  EXPECT_NEAR(determined(little, prior).covariance(0, 0), square(0.05), 1e-6);
  const LinearEvidence clear{Eigen::MatrixXd::Constant(1, 1, 1e6), Eigen::VectorXd::Constant(1, 1.5e5)};
  EXPECT_NEAR(determined(clear, prior).mean[0], 0.15, 1e-4);
}

TEST(Relevance, OneErrorIsExplainedByTheParameterThatFits)
{
  Eigen::VectorXd truth = Eigen::VectorXd::Zero(12);
  truth[4] = 1;
  const RelevantParameters found = determined(measured(truth, 0.5, 400, 3), upTo(12, 2));
  EXPECT_NEAR(found.mean[4], 1, 0.2);
  for (Eigen::Index k = 0; k < 12; ++k)
  {
    EXPECT_LT(std::abs(found.mean[k] - truth[k]), 3 * std::sqrt(found.covariance(k, k)) + 0.02) << k;
  }
}

TEST(Relevance, AnEstimateIsNoLargerThanPlausible)
{
  const Eigen::VectorXd truth = Eigen::VectorXd::Constant(1, 5);
  const RelevantParameters found = determined(measured(truth, 0, 2, 1), upTo(1, 0.01));
  EXPECT_LT(std::abs(found.mean[0]), 0.05);
  EXPECT_LE(found.covariance(0, 0), 0.01 * 0.01);
}
}  // namespace
}  // namespace mrpt_ext::test_relevance
