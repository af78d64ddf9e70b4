#include "mrpt_ext/filter/gaussian_proposal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"

namespace mrpt_ext::test_gaussian_proposal
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {4, 0, 0}}, {.id = 2, .position = {0, 3, 0}}});

Frame preciseFrame(const Pose2& truth)
{
  Reading reading;
  reading.model.clutter_probability = 0.01;
  reading.model.max_range = 20.0;
  for (const Landmark& landmark : kMap.all())
  {
    Detection detection{.id = landmark.id};
    detection.std_bearing = degToRad(0.5);
    detection.std_range = 0.02;
    detection.bearing = predictBearing(truth, landmark.position.head<2>());
    detection.range = predictRange(truth, landmark.position.head<2>());
    reading.detections.push_back(detection);
  }
  Frame frame;
  frame.readings = {reading};
  return frame;
}
}  // namespace

TEST(GaussianProposal, MomentsOfDrawsAreThoseOfTheGaussian)
{
  RandomStream random(3);
  const Eigen::MatrixXd draws = exactNormals(4, 50, random);
  EXPECT_LT(draws.rowwise().mean().norm(), 1e-12);
  EXPECT_LT((draws * draws.transpose() / 50 - Eigen::MatrixXd::Identity(4, 4)).norm(), 1e-12);
}

TEST(GaussianProposal, FewParticlesGiveThePosteriorThatManyGive)
{
  const Pose2 truth{0.4, -0.3, 0.1};
  const Frame frame = preciseFrame(truth);
  KalmanState prior;
  prior.covariance = Vector3d(0.16, 0.16, 0.01).asDiagonal();
  RandomStream random(4);
  const auto posterior = [&](std::size_t count, bool proposed)
  {
    const KalmanState aim = proposed ? updateIterated(prior, frame, kMap, {}).state : prior;
    ParticleSet particles = drawFromKalmanProposal(ParticleSet(Vector2d(0, 0)), prior, aim, count, 1.2, random);
    for (const Reading& reading : frame.readings)
      for (std::size_t i = 0; i < particles.size(); ++i)
        particles.log_weight[i] += static_cast<float>(logLikelihood(reading, kMap, particles.pose(i)));
    const double ratio = normalizeWeights(particles).effective_ratio;
    if (proposed)
    {
      EXPECT_GT(ratio, 0.5);
    }
    return *momentsOf(particles, [](std::size_t) { return true; });
  };
  const KalmanState many = posterior(200000, false), few = posterior(300, true);
  for (int i = 0; i < 3; ++i)
  {
    const double std = std::sqrt(many.covariance(i, i));
    EXPECT_NEAR(few.mean[i], many.mean[i], 0.2 * std) << i;
    EXPECT_NEAR(std::sqrt(few.covariance(i, i)), std, 0.2 * std) << i;
  }
}

TEST(GaussianProposal, MomentsIncludeSystematicErrorsAndWrapHeadings)
{
  ParticleSet particles(Vector2d(1, 1), {{.kind = BiasKind::range_offset, .std = 1}});
  RandomStream random(5);
  KalmanState state{KalmanVector::Zero(4), KalmanMatrix::Identity(4, 4)};
  state.mean << 1, 2, kPi - 0.01, 0.3;
  state.covariance.diagonal() << 0.01, 0.04, 0.01, 0.0025;
  state.covariance(0, 3) = state.covariance(3, 0) = 0.003;
  particles = drawFromKalmanProposal(particles, state, state, 3000, 1.2, random);
  for (float& log_w : particles.log_weight) log_w = -1;
  const auto moments = momentsOf(particles, [](std::size_t) { return true; });
  ASSERT_TRUE(moments);
  EXPECT_LT((moved(moments->mean, -state.mean)).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_GT(moments->covariance(0, 3), 0.003);  // nine tenths are drawn 1.2 times as wide
  EXPECT_LT(moments->covariance(0, 3), 0.0045);
  EXPECT_FALSE(momentsOf(particles, [](std::size_t i) { return i < 3; }));
}

TEST(GaussianProposal, ReplacesTheParticlesOnlyWhereTooFewAreEffective)
{
  const Frame frame = preciseFrame({0.4, -0.3, 0.1});
  KalmanState prior;
  prior.covariance = Vector3d(0.16, 0.16, 0.01).asDiagonal();
  const auto weight = [](const Frame& z, ParticleSet& particles)
  {
    for (const Reading& reading : z.readings)
      for (std::size_t i = 0; i < particles.size(); ++i)
        particles.log_weight[i] += static_cast<float>(logLikelihood(reading, kMap, particles.pose(i)));
  };
  const auto effective_after = [&](const KalmanProposalLimits& limits)
  {
    RandomStream random(6);
    ParticleSet particles = drawFromKalmanProposal(ParticleSet(Vector2d(0, 0)), prior, prior, 500, 1.2, random);
    weight(frame, particles);
    proposeFromKalman(particles, prior, frame, kMap, limits, weight, random);
    EXPECT_EQ(particles.size(), 500U);
    return 500 * normalizeWeights(particles).effective_ratio;
  };
  EXPECT_LT(effective_after({0, 0.5}), 20) << "never";
  EXPECT_LT(effective_after({400, 0.001}), 20) << "the ratio allows it";
  EXPECT_GT(effective_after({400, 0.5}), 200);
}
}  // namespace mrpt_ext::test_gaussian_proposal
