#include "mrpt_ext/filter/gaussian_tracking.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"

namespace mrpt_ext::test_gaussian_tracking
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {4, 0, 0}}, {.id = 2, .position = {0, 3, 0}}});

Frame frameAt(const Pose2& truth, bool named)
{
  Reading reading;
  reading.model.clutter_probability = 0.05;
  reading.model.max_range = 20.0;
  for (const Landmark& landmark : kMap.all())
  {
    Detection detection{.id = named ? landmark.id : kNoId, .std_bearing = degToRad(1.0), .std_range = 0.05};
    detection.bearing = predictBearing(truth, landmark.position.head<2>());
    detection.range = predictRange(truth, landmark.position.head<2>());
    reading.detections.push_back(detection);
  }
  Frame frame;
  frame.readings = {reading};
  return frame;
}

void weight(const Frame& frame, ParticleSet& particles)
{
  for (const Reading& reading : frame.readings)
    for (std::size_t i = 0; i < particles.size(); ++i)
      particles.log_weight[i] += static_cast<float>(logLikelihood(reading, kMap, particles.pose(i)));
}

KalmanState priorOf(double std_xy, double std_phi)
{
  KalmanState prior;
  prior.covariance = Vector3d(square(std_xy), square(std_xy), square(std_phi)).asDiagonal();
  return prior;
}

GaussianUpdate updateOf(const KalmanState& prior, const Frame& frame)
{
  RandomStream random(8);
  return updateGaussian(prior, frame, kMap, ParticleSet(Vector2d(0, 0)), 100, random);
}

bool confirmed(const KalmanState& prior, const Frame& frame)
{
  return isConfirmed(updateOf(prior, frame), frame, weight);
}
}  // namespace

TEST(GaussianTracking, ParticlesHaveTheMomentsTheyAreDrawnFor)
{
  RandomStream random(9);
  KalmanState state{KalmanVector::Zero(4), KalmanMatrix::Identity(4, 4)};
  state.mean << 1, 2, kPi - 0.01, 0.3;
  state.covariance.diagonal() << 0.01, 0.04, 0.01, 0.0025;
  state.covariance(0, 3) = state.covariance(3, 0) = 0.003;
  const ParticleSet like(Vector2d(1, 1), {{.kind = BiasKind::range_offset, .std = 1}});
  const ParticleSet particles = drawGaussian(like, state, 50, random);
  EXPECT_EQ(particles.size(), 50U);
  const auto moments = momentsOf(particles, [](std::size_t) { return true; });
  ASSERT_TRUE(moments);
  EXPECT_LT(moved(moments->mean, -state.mean).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_LT((moments->covariance - state.covariance).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(GaussianTracking, TheKalmanPosteriorIsConfirmedWhereItIsThePosterior)
{
  const Frame frame = frameAt({0.1, -0.05, 0.02}, true);
  const KalmanState prior = priorOf(0.1, 0.05);
  EXPECT_TRUE(confirmed(prior, frame));
  EXPECT_EQ(updateOf(prior, frame).posterior.mean, updateIterated(prior, frame, kMap, {}).state.mean);
}

// The evidence that many particles of the prior give, from few that are near the posterior.
TEST(GaussianTracking, TheSamplesGiveTheEvidenceOfAPreciseFrame)
{
  const Frame frame = frameAt({0.3, -0.3, 0.1}, true);
  const KalmanState prior = priorOf(0.4, 0.2);
  const auto log_evidence = [&](ParticleSet particles)
  {
    weight(frame, particles);
    return normalizeWeights(particles).log_sum;
  };
  RandomStream random(10);
  const double many = log_evidence(drawGaussian(ParticleSet(Vector2d(0, 0)), prior, 200'000, random));
  EXPECT_NEAR(log_evidence(updateOf(prior, frame).samples), many, 0.3);
}

TEST(GaussianTracking, WithoutDetectionsThePriorIsThePosterior)
{
  const KalmanState prior = priorOf(0.4, 0.3);
  EXPECT_TRUE(confirmed(prior, {}));
  EXPECT_EQ(updateOf(prior, {}).posterior.covariance, prior.covariance);
}

// A heading that may be either way: the Kalman filter takes one, which half of the likelihood contradicts.
TEST(GaussianTracking, APosteriorOfTwoModesIsNotConfirmed)
{
  // Without names, and two landmarks of which each may be the other after a quarter turn.
  const LandmarkTable& map = kMap;
  Frame frame = frameAt({0, 0, 0}, false);
  for (Detection& detection : frame.readings.front().detections) detection.range = 3.5, detection.std_range = 0.6;
  frame.readings.front().detections.resize(1);
  frame.readings.front().detections.front().bearing = degToRad(45.0);
  ASSERT_EQ(map.size(), 2U);
  EXPECT_FALSE(confirmed(priorOf(0.3, degToRad(60.0)), frame));
}

// Outliers that the filter leaves out leave the posterior a Gaussian.
TEST(GaussianTracking, AnOutlierChangesNothing)
{
  Frame frame = frameAt({0.1, -0.05, 0.02}, true);
  frame.readings.front().detections.front().range = 12.0;
  EXPECT_TRUE(confirmed(priorOf(0.1, 0.05), frame));
}
}  // namespace mrpt_ext::test_gaussian_tracking
