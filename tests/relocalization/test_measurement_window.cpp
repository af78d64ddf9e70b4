#include "mrpt_ext/relocalization/measurement_window.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "../hypotheses/exact_scene.h"
#include "mrpt_ext/hypotheses/window_readings.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"

namespace mrpt_ext::test_measurement_window
{
namespace
{
const MotionModel kModel{};

OdometryMotion motionOf(const Pose2& increment, double duration = 1)
{
  return {increment, increment.position().norm(), std::abs(increment.phi), duration};
}

Frame frameAt(double time, const OdometryMotion& motion, std::vector<Reading> readings)
{
  for (Reading& reading : readings) reading.time = time;
  return {.time = time, .motion = motion, .readings = std::move(readings)};
}

const LandmarkTable kMap = fiveLandmarks();
const ExactSensor kSensor{.range = true, .T_robot_sensor = {0.3, -0.2, 0.7}};

/// The reading `first`, propagated over `steps`.
Reading propagatedAlong(const std::vector<OdometryMotion>& steps, const Reading& first)
{
  MeasurementWindow window(1e9, kModel);
  window.add(frameAt(0, {}, {first}));
  double time = 0;
  for (const OdometryMotion& step : steps) window.add(frameAt(++time, step, {}));
  return window.readings().front();
}

/// Error of a past sensor pose relative to the robot after noisy odometry.
struct SampledError
{
  Vector2d offset;
  double heading;
};

std::vector<SampledError> sampleErrors(const std::vector<OdometryMotion>& steps, const Pose2& T_robot_sensor, int n)
{
  ParticleSet robots;
  for (int i = 0; i < n; ++i) robots.add({}, 0);
  RandomStream random(5);
  Pose2 end;
  for (const OdometryMotion& step : steps)
  {
    sampleMotion(robots, kModel, step, random);
    end = compose(end, step.increment);
  }
  const Pose2 nominal = between(end, T_robot_sensor);
  std::vector<SampledError> samples;
  for (int i = 0; i < n; ++i)
  {
    const Pose2 seen = between(robots.pose(static_cast<std::size_t>(i)), T_robot_sensor);
    samples.push_back({seen.position() - nominal.position(), wrap(seen.phi - nominal.phi)});
  }
  return samples;
}

Matrix2d covarianceOf(const std::vector<SampledError>& samples)
{
  Matrix2d sum = Matrix2d::Zero();
  for (const SampledError& s : samples) sum += s.offset * s.offset.transpose();
  return sum / static_cast<double>(samples.size());
}

void expectSimilar(const Matrix2d& actual, const Matrix2d& expected)
{
  EXPECT_LT((actual - expected).norm(), 0.06 * expected.norm()) << actual << "\n\nexpected\n" << expected;
}
}  // namespace

TEST(MeasurementWindow, PropagatedReadingsPredictTheirMeasurements)
{
  MeasurementWindow window(10, kModel);
  Pose2 robot{1, 2, 0.4};
  window.add(frameAt(0, {}, {seenFrom(robot, kMap, {0, 1}, kSensor)}));
  for (const Pose2 step : {Pose2{0.5, 0.1, 0.6}, Pose2{0.3, 0, -1.2}, Pose2{0, 0, 2.9}})
  {
    robot = compose(robot, step);
    window.add(frameAt(window.frame().time + 1, motionOf(step), {seenFrom(robot, kMap, {2, 3}, kSensor)}));
  }
  const std::vector<Reading> readings = window.readings();
  ASSERT_EQ(readings.size(), 4u);
  for (const Reading& reading : readings)
    for (const Detection& d : reading.detections)
    {
      const LandmarkPrediction p = predict(kMap[*kMap.indexOf(d.id)], reading, robot);
      EXPECT_NEAR(std::abs(wrap(p.bearing - *d.bearing)), 0, 1e-9);
      EXPECT_NEAR(p.range, *d.range, 1e-9);
    }
}

TEST(MeasurementWindow, TheNewestReadingsAreUnchanged)
{
  MeasurementWindow window(10, kModel);
  window.add(frameAt(0, {}, {seenFrom({}, kMap, {0}, kSensor)}));
  const Reading newest = seenFrom({1, 0, 0}, kMap, {1}, kSensor, 1);
  window.add(frameAt(1, motionOf({1, 0, 0}), {newest}));
  const Reading kept = window.frame().readings.back();
  EXPECT_EQ(kept.T_robot_sensor.vector(), newest.T_robot_sensor.vector());
  EXPECT_TRUE(kept.sensor_position_covariance.isZero(0));
  EXPECT_EQ(kept.detections.front().std_bearing, newest.detections.front().std_bearing);
}

TEST(MeasurementWindow, ReadingsOlderThanTheWindowAreDropped)
{
  MeasurementWindow window(2, kModel);
  for (int k = 0; k < 6; ++k)
  {
    window.add(frameAt(k, motionOf({0.1, 0, 0}), {seenFrom({}, kMap, {0}, kSensor)}));
    EXPECT_EQ(window.full(), k >= 2) << k;
    EXPECT_EQ(window.readings().size(), static_cast<std::size_t>(std::min(k, 2)) + 1) << k;
  }
  EXPECT_EQ(window.readings().front().time, 3);
  EXPECT_EQ(window.frame().time, 5);
}

TEST(MeasurementWindow, AWindowOfZeroIsTheNewestFrame)
{
  MeasurementWindow window(0, kModel);
  window.add(frameAt(0, {}, {seenFrom({}, kMap, {0}, kSensor)}));
  window.add(frameAt(0.1, motionOf({0.1, 0, 0}), {seenFrom({}, kMap, {1}, kSensor)}));
  EXPECT_EQ(window.readings().size(), 1u);
  EXPECT_TRUE(window.full());
}

TEST(MeasurementWindow, PastMissedDetectionsDoNotCount)
{
  Reading first = seenFrom({}, kMap, {0}, kSensor);
  first.model.detection_probability = 0.9;
  EXPECT_FALSE(propagatedAlong({motionOf({0.1, 0, 0})}, first).model.detection_probability);
}

TEST(MeasurementWindow, OdometryNoiseInflatesTheSensorPosition)
{
  Reading first;
  const std::vector<OdometryMotion> curve(30, motionOf({0.1, 0, 0.04}, 0.2));
  expectSimilar(propagatedAlong(curve, first).sensor_position_covariance, covarianceOf(sampleErrors(curve, {}, 40000)));
  first.T_robot_sensor = {0.4, 0.3, 1.0};
  expectSimilar(propagatedAlong(curve, first).sensor_position_covariance,
                covarianceOf(sampleErrors(curve, first.T_robot_sensor, 40000)));
}

TEST(MeasurementWindow, OneLongMotionInflatesAsMuchAsManyShortOnes)
{
  const Reading first;
  const std::vector<OdometryMotion> one{motionOf({3, 0, 0}, 6)}, many(60, motionOf({0.05, 0, 0}, 0.1));
  const Matrix2d expected = covarianceOf(sampleErrors(many, {}, 40000));
  expectSimilar(propagatedAlong(many, first).sensor_position_covariance, expected);
  expectSimilar(propagatedAlong(one, first).sensor_position_covariance, expected);
}

TEST(MeasurementWindow, HeadingNoiseInflatesBearings)
{
  const Reading first = seenFrom({}, kMap, {0, 1}, {.range = true});
  const std::vector<OdometryMotion> curve(30, motionOf({0.1, 0, 0.04}, 0.2));
  double heading_variance = 0;
  const std::vector<SampledError> samples = sampleErrors(curve, {}, 40000);
  for (const SampledError& s : samples) heading_variance += square(s.heading) / static_cast<double>(samples.size());
  const Reading propagated = propagatedAlong(curve, first);
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double before = square(first.detections[i].std_bearing);
    EXPECT_NEAR(square(propagated.detections[i].std_bearing) - before, heading_variance, 0.05 * heading_variance);
    EXPECT_EQ(propagated.detections[i].std_range, first.detections[i].std_range);
  }
}

TEST(MeasurementWindow, HeadingNoiseInflatesFacings)
{
  Reading first = seenFrom({}, kMap, {0}, {});
  first.detections[0].facing = Facing::single(1, 0.1);
  const std::vector<OdometryMotion> curve(30, motionOf({0.1, 0, 0.04}, 0.2));
  const Reading propagated = propagatedAlong(curve, first);
  EXPECT_NEAR(square(propagated.detections[0].facing->attitudes[0].std) - square(0.1),
              square(propagated.detections[0].std_bearing) - square(first.detections[0].std_bearing), 1e-12);
  EXPECT_EQ(propagated.detections[0].facing->attitudes[0].yaw, 1);
  EXPECT_NEAR(withoutOdometryNoise(propagated).detections[0].facing->attitudes[0].std, 0.1, 1e-9);
}

TEST(MeasurementWindow, KeepsTheCovarianceOfTheOdometry)
{
  const std::vector<OdometryMotion> curve(30, motionOf({0.1, 0, 0.04}, 0.2));
  const Matrix3d P = propagatedAlong(curve, {.T_robot_sensor = {0.4, 0.3, 1.0}}).odometry_covariance;
  // Samples of the robot's pose after noisy odometry, in the axes of the nominal one.
  Pose2 end;
  for (const OdometryMotion& step : curve) end = compose(end, step.increment);
  ParticleSet robots;
  const int n = 40000;
  for (int i = 0; i < n; ++i) robots.add({}, 0);
  RandomStream random(6);
  for (const OdometryMotion& step : curve) sampleMotion(robots, kModel, step, random);
  Matrix3d sampled = Matrix3d::Zero();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vector3d e = between(end, robots.pose(i)).vector();
    sampled += e * e.transpose() / n;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(P(i, j), sampled(i, j), 0.03 * std::sqrt(P(i, i) * P(j, j))) << i << j;
}

TEST(MeasurementWindow, ARandomWalkIgnoresOdometry)
{
  MotionModel walk{.type = MotionType::random_walk, .std_xy_per_s = 0.3, .std_phi_per_s = 0.2};
  MeasurementWindow window(10, walk);
  const Reading seen = seenFrom({}, kMap, {0, 1}, kSensor);
  window.add(frameAt(0, {}, {seen}));
  // The increment is ignored; without path length and rotation, the noise depends on time alone.
  window.add(frameAt(2, {.increment = {1, 0.5, 0.7}, .duration = 2}, {}));
  const Reading propagated = window.readings().front();
  EXPECT_EQ(propagated.T_robot_sensor.vector(), seen.T_robot_sensor.vector());
  const Matrix3d expected = Vector3d(0.09 * 2, 0.09 * 2, 0.04 * 2).asDiagonal();
  EXPECT_TRUE(propagated.odometry_covariance.isApprox(expected, 1e-12)) << propagated.odometry_covariance;
  EXPECT_GE(propagated.sensor_position_covariance(0, 0), 0.18);
  EXPECT_NEAR(square(propagated.detections[0].std_bearing) - square(seen.detections[0].std_bearing), 0.08, 1e-12);
}

namespace
{
/// The window of a drive past the landmarks, three of which are measured from every pose, with noise.
std::vector<Reading> windowOfDrive(const Pose2& end, RandomStream& random)
{
  const OdometryMotion measured = motionOf({0.15, 0, 0.1}, 0.2);
  ParticleSet noisy;
  std::vector<Pose2> poses{end};
  for (int k = 0; k < 12; ++k)
  {
    noisy.clear();
    noisy.add({}, 0);
    sampleMotion(noisy, kModel, measured, random);
    poses.insert(poses.begin(), compose(poses.front(), inverse(noisy.pose(0))));
  }
  MeasurementWindow window(100, kModel);
  for (std::size_t k = 0; k < poses.size(); ++k)
  {
    Reading reading = seenFrom(poses[k], kMap, {0, 2, 3}, kSensor);
    for (Detection& d : reading.detections)
    {
      *d.bearing += d.std_bearing * random.gaussian();
      *d.range += d.std_range * random.gaussian();
    }
    window.add(frameAt(static_cast<double>(k), k > 0 ? measured : OdometryMotion{}, {reading}));
  }
  return window.readings();
}
}  // namespace

TEST(MeasurementWindow, OdometryNoiseCanBeTakenOff)
{
  RandomStream random(7);
  for (const Reading& reading : windowOfDrive({2, 3, 0.5}, random))
    for (const Detection& d : withoutOdometryNoise(reading).detections) EXPECT_NEAR(d.std_bearing, degToRad(0.5), 1e-9);
}

TEST(MeasurementWindow, ThePoseOfAWindowIsConsistent)
{
  RandomStream random(8);
  const int trials = 500;
  double squared = 0;
  for (int trial = 0; trial < trials; ++trial)
  {
    const Pose2 end{random.uniform(1, 4), random.uniform(1, 4), random.uniform(-kPi, kPi)};
    const PoseMl fit = refineWindowPose(windowMeasurements(windowOfDrive(end, random), kMap), end);
    ASSERT_EQ(fit.status, SolveStatus::ok);
    Vector3d e = fit.pose.mean.vector() - end.vector();
    e.z() = wrap(e.z());
    squared += e.dot(fit.pose.covariance.inverse() * e) / trials;
  }
  EXPECT_NEAR(squared, 3, 3.3 * std::sqrt(6.0 / trials));  // 99.9 % band
}
}  // namespace mrpt_ext::test_measurement_window
