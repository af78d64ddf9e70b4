#include "mrpt_ext/filter/kalman/kalman_update.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "mrpt_ext/filter/kalman/kalman_innovation.h"
#include "mrpt_ext/geometry/bounded_frame.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"
#include "simulated_run.h"

namespace mrpt_ext::test_kalman_update
{
namespace
{
const Pose2 kTruth{3, 4, 0.5};

Matrix3d diagonal(double xy, double phi) { return Vector3d(xy * xy, xy * xy, phi * phi).asDiagonal(); }

Frame exactFrame(const LandmarkTable& map, const std::vector<std::size_t>& seen, bool identified, bool range)
{
  Reading reading;
  reading.model.clutter_probability = 0.05;
  for (const std::size_t j : seen)
  {
    Detection d{.id = identified ? map[j].id : kNoId, .bearing = predictBearing(kTruth, map[j].position.head<2>())};
    d.std_bearing = degToRad(1);
    if (range) d.range = predictRange(kTruth, map[j].position.head<2>());
    d.std_range = 0.05;
    reading.detections.push_back(d);
  }
  Frame frame;
  frame.readings = {reading};
  return frame;
}

LandmarkTable squareMap()
{
  return LandmarkTable({{.id = 1, .position = {0, 0, 0}},
                        {.id = 2, .position = {8, 1, 0}},
                        {.id = 3, .position = {7, 9, 0}},
                        {.id = 4, .position = {-1, 7, 0}}});
}

bool isPositiveDefinite(const KalmanMatrix& covariance)
{
  return covariance.allFinite() && (covariance - covariance.transpose()).cwiseAbs().maxCoeff() < 1e-12 &&
         Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(covariance)).eigenvalues().minCoeff() > 0;
}

double drawn(double low, double high) { return low + (high - low) * 1e-6 * *rc::gen::inRange(0, 1000001); }

/// The nonlinear least squares solution for prior and measurements, by Gauss-Newton in information form.
Pose2 leastSquares(const KalmanState& prior, const Frame& frame, const LandmarkTable& map)
{
  KalmanVector mean = prior.mean;
  const Matrix3d inverse_prior = Matrix3d(prior.covariance).inverse();
  for (int i = 0; i < 50; ++i)
  {
    Vector3d from_prior = mean - prior.mean;
    from_prior.z() = wrap(from_prior.z());
    Matrix3d information = inverse_prior;
    Vector3d gradient = -inverse_prior * from_prior;
    for (const Detection& d : frame.readings[0].detections)
    {
      const DetectionRows rows = linearise(d, frame.readings[0], map[*map.indexOf(d.id)], mean, {});
      for (int r = 0; r < rows.count; ++r)
      {
        const KalmanRow& row = rows.rows[static_cast<std::size_t>(r)];
        information += row.jacobian.transpose() * row.jacobian / row.variance;
        gradient += row.jacobian.transpose() * row.residual / row.variance;
      }
    }
    mean = moved(mean, information.ldlt().solve(gradient));
  }
  return {mean[0], mean[1], mean[2]};
}
}  // namespace

TEST(KalmanUpdate, CorrectsThePoseAndReducesItsCovariance)
{
  const LandmarkTable map = squareMap();
  const KalmanState prior = startingState({{3.2, 3.9, 0.55}, diagonal(0.3, 0.1)}, {});
  const KalmanUpdate update = updateExtended(prior, exactFrame(map, {0, 1, 2, 3}, true, true), map, {});
  EXPECT_LT((update.state.pose().position() - kTruth.position()).norm(), 0.03);
  EXPECT_LT(std::abs(wrap(update.state.pose().phi - kTruth.phi)), degToRad(1));
  EXPECT_LT(update.state.covariance(0, 0), 0.02 * prior.covariance(0, 0));
  EXPECT_EQ(update.degrees_of_freedom, 8);
  EXPECT_LT(update.nis, 20);
  for (const DetectionUse& use : update.detections) EXPECT_TRUE(use.landmark);
}

TEST(KalmanUpdate, WithoutMeasurementsTheStateStaysAsItIs)
{
  const KalmanState prior = startingState({kTruth, diagonal(0.3, 0.1)}, {});
  for (const auto& rule : {updateExtended, updateIterated})
  {
    const KalmanUpdate update = rule(prior, Frame{}, squareMap(), {});
    EXPECT_EQ(update.log_evidence, 0);
    EXPECT_TRUE(update.state.mean == prior.mean);
    EXPECT_TRUE(update.state.covariance == prior.covariance);
  }
}

TEST(KalmanUpdate, RejectsAFalseDetectionAndReportsIt)
{
  const LandmarkTable map = squareMap();
  const KalmanState prior = startingState({{3.02, 4, 0.5}, diagonal(0.05, 0.02)}, {});
  Frame frame = exactFrame(map, {0, 1, 2}, true, false);
  frame.readings[0].detections[1].bearing = wrap(*frame.readings[0].detections[1].bearing + 1);
  const KalmanUpdate update = updateExtended(prior, frame, map, {});
  EXPECT_TRUE(update.detections[0].landmark);
  EXPECT_FALSE(update.detections[1].landmark);
  EXPECT_LT(update.detections[1].inlier_probability, 1e-6);
  EXPECT_EQ(update.degrees_of_freedom, 2);
  EXPECT_LT((update.state.pose().position() - kTruth.position()).norm(), 0.05);
}

TEST(KalmanUpdate, ADetectionWithAnUnknownIdIsClutter)
{
  Frame frame = exactFrame(squareMap(), {0}, true, false);
  frame.readings[0].detections[0].id = 99;
  const KalmanState prior = startingState({kTruth, diagonal(0.1, 0.1)}, {});
  const KalmanUpdate update = updateExtended(prior, frame, squareMap(), {});
  EXPECT_FALSE(update.detections[0].landmark);
  EXPECT_NEAR(update.log_evidence, std::log(1 / kTwoPi), 1e-12);
}

TEST(KalmanUpdate, AssociatesAnonymousDetectionsWithTheirLandmarks)
{
  const LandmarkTable map = squareMap();
  const KalmanState prior = startingState({{3.1, 3.9, 0.52}, diagonal(0.2, 0.05)}, {});
  const KalmanUpdate update = updateExtended(prior, exactFrame(map, {2, 0, 3}, false, false), map, {});
  for (const DetectionUse& use : update.detections)
  {
    ASSERT_TRUE(use.landmark);
    EXPECT_EQ(*use.landmark, (std::vector<std::size_t>{2, 0, 3})[use.detection]);
  }
}

TEST(KalmanUpdate, ADetectionWithAnAmbiguousAssociationIsNotUsed)
{
  const LandmarkTable twins({{.id = 1, .position = {5, 0.05, 0}}, {.id = 2, .position = {5, -0.05, 0}}});
  Frame frame;
  Reading reading;
  reading.detections = {{.bearing = 0.0, .std_bearing = degToRad(1)}};
  frame.readings = {reading};
  const KalmanState prior = startingState({{0, 0, 0}, diagonal(0.1, 0.05)}, {});
  const KalmanUpdate update = updateExtended(prior, frame, twins, {});
  EXPECT_FALSE(update.detections[0].landmark);
  EXPECT_GT(update.detections[0].inlier_probability, 0.9) << "it is an inlier of one of them";
}

TEST(KalmanUpdate, TheEvidenceOfAStateWithZeroCovarianceIsTheLikelihoodOfItsPose)
{
  const LandmarkTable map = squareMap();
  for (const bool identified : {true, false})
  {
    const Frame frame = exactFrame(map, {0, 1, 2, 3}, identified, true);
    const KalmanState exact = startingState({{3.01, 4.02, 0.51}, Matrix3d::Zero()}, {});
    const KalmanUpdate update = updateExtended(exact, frame, map, {});
    EXPECT_NEAR(update.log_evidence, logLikelihood(frame.readings[0], map, exact.pose()), 1e-3);
  }
}

TEST(KalmanUpdate, LandmarksThatAreLeftOutAsFarChangeNoEvidence)
{
  std::vector<Landmark> landmarks(400);
  RandomStream random(3);
  for (Landmark& landmark : landmarks) landmark.position = {random.uniform(-40, 40), random.uniform(-40, 40), 0};
  const LandmarkTable map(std::move(landmarks));
  for (const bool range : {true, false})
    for (const bool limited : {true, false})
    {
      Frame frame = exactFrame(map, {0, 1, 2, 3, 4, 5, 6, 7}, false, range);
      if (limited) frame.readings[0].model.max_range = 30;
      const KalmanState exact = startingState({{3.01, 4.02, 0.51}, Matrix3d::Zero()}, {});
      const KalmanUpdate update = updateExtended(exact, frame, map, {});
      EXPECT_NEAR(update.log_evidence, logLikelihood(frame.readings[0], map, exact.pose()), 1e-3);
    }
}

TEST(KalmanUpdate, OfTooManyComparisonsSomeDetectionsAreLeft)
{
  std::vector<Landmark> landmarks(1000);
  for (std::size_t i = 0; i < landmarks.size(); ++i)
    landmarks[i] = {.id = static_cast<int>(i), .position = {static_cast<double>(i), i % 2 == 0 ? 0.0 : 1000.0, 0}};
  const LandmarkTable map(std::move(landmarks));
  Frame frame{.readings = {Reading{.sensor = "s", .detections = std::vector<Detection>(100, {.bearing = 0.0})}}};
  EXPECT_FALSE(affordableToUpdate(frame, map, 10));
  EXPECT_EQ(detectionCount(affordableToUpdate(frame, map, 50).value()), 20u) << "100 detections, 1000 landmarks";
  frame.readings[0].model.max_range = 5;
  EXPECT_FALSE(affordableToUpdate(frame, map, 50)) << "few landmarks in range";
  frame.readings[0].model.max_range.reset();
  for (Detection& d : frame.readings[0].detections) d.id = 1;
  EXPECT_FALSE(affordableToUpdate(frame, map, 50)) << "compared with its landmark alone";
}

TEST(KalmanUpdate, ACompassHeadingIsUsedUnlessItIsAnOutlier)
{
  Frame frame;
  frame.compass = CompassRecord{.sensor = "c", .heading = 0.6, .std_heading = 0.05};
  const KalmanState prior = startingState({kTruth, diagonal(0.1, 0.1)}, {});
  const KalmanUpdate used = updateExtended(prior, frame, squareMap(), {});
  EXPECT_NEAR(used.state.pose().phi, 0.58, 1e-3);
  frame.compass->heading = 2.5;
  const KalmanUpdate unused = updateExtended(prior, frame, squareMap(), {});
  EXPECT_EQ(unused.state.pose().phi, kTruth.phi);
}

RC_GTEST_PROP(KalmanUpdate, TheIteratedUpdateMinimizesTheSquares, ())
{
  const LandmarkTable map = squareMap();
  const bool range = *rc::gen::arbitrary<bool>();
  Frame frame = exactFrame(map, {0, 1, 3}, true, range);
  frame.readings[0].model.clutter_probability = 0;
  const Pose2 start{kTruth.x + drawn(-0.8, 0.8), kTruth.y + drawn(-0.8, 0.8), kTruth.phi + drawn(-0.3, 0.3)};
  const KalmanState prior = startingState({start, diagonal(0.8, 0.3)}, {});
  const KalmanUpdate update = updateIterated(prior, frame, map, {});
  RC_ASSERT(update.degrees_of_freedom == (range ? 6 : 3));
  const Pose2 expected = leastSquares(prior, frame, map);
  RC_ASSERT((update.state.pose().position() - expected.position()).norm() < 2e-4);
  RC_ASSERT(std::abs(wrap(update.state.pose().phi - expected.phi)) < 1e-4);
}

RC_GTEST_PROP(KalmanUpdate, AnyMeasurementLeavesAFiniteStateAndAPositiveDefiniteCovariance, ())
{
  const LandmarkTable map = squareMap();
  const BiasModel biases{{.kind = BiasKind::range_scale, .std = 0.1}, {.kind = BiasKind::bearing_offset, .std = 0}};
  Frame frame = exactFrame(map, {0, 1, 2, 3}, *rc::gen::arbitrary<bool>(), true);
  for (Detection& d : frame.readings[0].detections)
  {
    d.bearing = drawn(-3.2, 3.2);
    d.range = drawn(1e-6, 30);
    d.std_bearing = std::pow(10, drawn(-6, 1));
    d.std_range = std::pow(10, drawn(-6, 1));
  }
  // Also with a landmark exactly under the sensor.
  const Pose2 start = *rc::gen::arbitrary<bool>() ? Pose2{0, 0, 0} : Pose2{drawn(-9, 9), drawn(-9, 9), drawn(-3, 3)};
  const double spread = std::pow(10, drawn(-6, 2));
  const KalmanState prior = startingState({start, diagonal(spread, spread)}, biases);
  for (const auto& rule : {updateExtended, updateIterated})
  {
    const KalmanUpdate update = rule(prior, frame, map, biases);
    RC_ASSERT(update.state.mean.allFinite());
    RC_ASSERT(std::isfinite(update.log_evidence) && std::isfinite(update.nis));
    RC_ASSERT(isPositiveDefinite(update.state.covariance));
  }
}
}  // namespace mrpt_ext::test_kalman_update
