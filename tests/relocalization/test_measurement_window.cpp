#include "mrpt_ext/relocalization/measurement_window.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "../hypotheses/exact_scene.h"
#include "mrpt_ext/hypotheses/window_readings.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"
#include "mrpt_ext/localizers/windowed_localizer.h"

namespace mrpt_ext
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

/// Empty readings of a sensor in the robot's centre, carried along `steps`; the carried first one.
Reading carriedAlong(const std::vector<OdometryMotion>& steps, const Reading& first)
{
  MeasurementWindow joiner(1e9, kModel);
  joiner.add(frameAt(0, {}, {first}));
  double time = 0;
  for (const OdometryMotion& step : steps) joiner.add(frameAt(++time, step, {}));
  return joiner.readings().front();
}

/// Where the sensor at `place` on the robot is seen from the end of the noisy way, minus where it is said to be.
struct CarriedSample
{
  Vector2d offset;
  double heading;
};

std::vector<CarriedSample> sampleCarried(const std::vector<OdometryMotion>& steps, const Pose2& T_robot_sensor, int n)
{
  ParticleSet robots;
  for (int i = 0; i < n; ++i) robots.add({}, 0);
  RandomStream random(5);
  Pose2 end;
  for (const OdometryMotion& step : steps)
  {
    moveParticles(robots, kModel, step, random);
    end = compose(end, step.increment);
  }
  const Pose2 said = between(end, T_robot_sensor);
  std::vector<CarriedSample> samples;
  for (int i = 0; i < n; ++i)
  {
    const Pose2 seen = between(robots.pose(static_cast<std::size_t>(i)), T_robot_sensor);
    samples.push_back({seen.position() - said.position(), wrap(seen.phi - said.phi)});
  }
  return samples;
}

Matrix2d covarianceOf(const std::vector<CarriedSample>& samples)
{
  Matrix2d sum = Matrix2d::Zero();
  for (const CarriedSample& s : samples) sum += s.offset * s.offset.transpose();
  return sum / static_cast<double>(samples.size());
}

void expectSimilar(const Matrix2d& actual, const Matrix2d& expected)
{
  EXPECT_LT((actual - expected).norm(), 0.06 * expected.norm()) << actual << "\n\nexpected\n" << expected;
}
}  // namespace

TEST(MeasurementWindow, CarriedReadingsPredictWhatWasMeasured)
{
  MeasurementWindow joiner(10, kModel);
  Pose2 robot{1, 2, 0.4};
  joiner.add(frameAt(0, {}, {seenFrom(robot, kMap, {0, 1}, kSensor)}));
  for (const Pose2 step : {Pose2{0.5, 0.1, 0.6}, Pose2{0.3, 0, -1.2}, Pose2{0, 0, 2.9}})
  {
    robot = compose(robot, step);
    joiner.add(frameAt(joiner.joined().time + 1, motionOf(step), {seenFrom(robot, kMap, {2, 3}, kSensor)}));
  }
  const std::vector<Reading> readings = joiner.readings();
  ASSERT_EQ(readings.size(), 4u);
  for (const Reading& reading : readings)
    for (const Detection& d : reading.detections)
    {
      const LandmarkPrediction p = predict(kMap[*kMap.indexOf(d.id)], reading, robot);
      EXPECT_NEAR(std::abs(wrap(p.bearing - *d.bearing)), 0, 1e-9);
      EXPECT_NEAR(p.range, *d.range, 1e-9);
    }
}

TEST(MeasurementWindow, TheNewestReadingsAreAsTheyCame)
{
  MeasurementWindow joiner(10, kModel);
  joiner.add(frameAt(0, {}, {seenFrom({}, kMap, {0}, kSensor)}));
  const Reading newest = seenFrom({1, 0, 0}, kMap, {1}, kSensor, 1);
  joiner.add(frameAt(1, motionOf({1, 0, 0}), {newest}));
  const Reading kept = joiner.joined().readings.back();
  EXPECT_EQ(kept.T_robot_sensor.vector(), newest.T_robot_sensor.vector());
  EXPECT_TRUE(kept.sensor_position_covariance.isZero(0));
  EXPECT_EQ(kept.detections.front().std_bearing, newest.detections.front().std_bearing);
}

TEST(MeasurementWindow, ReadingsOlderThanTheWindowAreDropped)
{
  MeasurementWindow joiner(2, kModel);
  for (int k = 0; k < 6; ++k)
  {
    joiner.add(frameAt(k, motionOf({0.1, 0, 0}), {seenFrom({}, kMap, {0}, kSensor)}));
    EXPECT_EQ(joiner.full(), k >= 2) << k;
    EXPECT_EQ(joiner.readings().size(), static_cast<std::size_t>(std::min(k, 2)) + 1) << k;
  }
  EXPECT_EQ(joiner.readings().front().time, 3);
  EXPECT_EQ(joiner.joined().time, 5);
}

TEST(MeasurementWindow, AWindowOfZeroKeepsNothing)
{
  MeasurementWindow joiner(0, kModel);
  joiner.add(frameAt(0, {}, {seenFrom({}, kMap, {0}, kSensor)}));
  joiner.add(frameAt(0.1, motionOf({0.1, 0, 0}), {seenFrom({}, kMap, {1}, kSensor)}));
  EXPECT_EQ(joiner.readings().size(), 1u);
  EXPECT_TRUE(joiner.full());
}

TEST(MeasurementWindow, WhatWasNotSeenThenIsNotHeldAgainstThePoseNow)
{
  Reading first = seenFrom({}, kMap, {0}, kSensor);
  first.model.detection_probability = 0.9;
  EXPECT_FALSE(carriedAlong({motionOf({0.1, 0, 0})}, first).model.detection_probability);
}

TEST(MeasurementWindow, TheSensorPlaceGrowsAsUncertainAsOdometryMakesIt)
{
  Reading first;
  const std::vector<OdometryMotion> curve(30, motionOf({0.1, 0, 0.04}, 0.2));
  expectSimilar(carriedAlong(curve, first).sensor_position_covariance, covarianceOf(sampleCarried(curve, {}, 40000)));
  first.T_robot_sensor = {0.4, 0.3, 1.0};
  expectSimilar(carriedAlong(curve, first).sensor_position_covariance,
                covarianceOf(sampleCarried(curve, first.T_robot_sensor, 40000)));
}

TEST(MeasurementWindow, OneLongMotionMakesItAsUncertainAsManyShortOnes)
{
  const Reading first;
  const std::vector<OdometryMotion> one{motionOf({3, 0, 0}, 6)}, many(60, motionOf({0.05, 0, 0}, 0.1));
  const Matrix2d expected = covarianceOf(sampleCarried(many, {}, 40000));
  expectSimilar(carriedAlong(many, first).sensor_position_covariance, expected);
  expectSimilar(carriedAlong(one, first).sensor_position_covariance, expected);
}

TEST(MeasurementWindow, BearingsGrowAsUncertainAsTheHeadingOfTheWay)
{
  const Reading first = seenFrom({}, kMap, {0, 1}, {.range = true});
  const std::vector<OdometryMotion> curve(30, motionOf({0.1, 0, 0.04}, 0.2));
  double heading_variance = 0;
  const std::vector<CarriedSample> samples = sampleCarried(curve, {}, 40000);
  for (const CarriedSample& s : samples) heading_variance += square(s.heading) / static_cast<double>(samples.size());
  const Reading carried = carriedAlong(curve, first);
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double before = square(first.detections[i].std_bearing);
    EXPECT_NEAR(square(carried.detections[i].std_bearing) - before, heading_variance, 0.05 * heading_variance);
    EXPECT_EQ(carried.detections[i].std_range, first.detections[i].std_range);
  }
}

TEST(MeasurementWindow, KnowsTheCovarianceOfTheWayItself)
{
  const std::vector<OdometryMotion> curve(30, motionOf({0.1, 0, 0.04}, 0.2));
  const Matrix3d way = carriedAlong(curve, {.T_robot_sensor = {0.4, 0.3, 1.0}}).odometry_covariance;
  // The robot's pose at the end of the noisy way, in axes of where it is said to be.
  Pose2 end;
  for (const OdometryMotion& step : curve) end = compose(end, step.increment);
  ParticleSet robots;
  const int n = 40000;
  for (int i = 0; i < n; ++i) robots.add({}, 0);
  RandomStream random(6);
  for (const OdometryMotion& step : curve) moveParticles(robots, kModel, step, random);
  Matrix3d sampled = Matrix3d::Zero();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vector3d e = between(end, robots.pose(i)).vector();
    sampled += e * e.transpose() / n;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(way(i, j), sampled(i, j), 0.03 * std::sqrt(way(i, i) * way(j, j))) << i << j;
}

TEST(MeasurementWindow, ARandomWalkBelievesNoOdometry)
{
  MotionModel walk{.type = MotionType::random_walk, .std_xy_per_s = 0.3, .std_phi_per_s = 0.2};
  MeasurementWindow joiner(10, walk);
  const Reading seen = seenFrom({}, kMap, {0, 1}, kSensor);
  joiner.add(frameAt(0, {}, {seen}));
  // Odometry says something; without a way and a turn to be noisy about, only time counts.
  joiner.add(frameAt(2, {.increment = {1, 0.5, 0.7}, .duration = 2}, {}));
  const Reading carried = joiner.readings().front();
  EXPECT_EQ(carried.T_robot_sensor.vector(), seen.T_robot_sensor.vector());
  const Matrix3d expected = Vector3d(0.09 * 2, 0.09 * 2, 0.04 * 2).asDiagonal();
  EXPECT_TRUE(carried.odometry_covariance.isApprox(expected, 1e-12)) << carried.odometry_covariance;
  EXPECT_GE(carried.sensor_position_covariance(0, 0), 0.18);
  EXPECT_NEAR(square(carried.detections[0].std_bearing) - square(seen.detections[0].std_bearing), 0.08, 1e-12);
}

namespace
{
/// A robot drives a curve past the landmarks and sees three of them from every place, with noise, as joined by
/// odometry.
std::vector<Reading> joinedDrive(const Pose2& end, RandomStream& random)
{
  const OdometryMotion said = motionOf({0.15, 0, 0.1}, 0.2);
  ParticleSet noisy;
  std::vector<Pose2> way{end};
  for (int k = 0; k < 12; ++k)
  {
    noisy.clear();
    noisy.add({}, 0);
    moveParticles(noisy, kModel, said, random);
    way.insert(way.begin(), compose(way.front(), inverse(noisy.pose(0))));
  }
  MeasurementWindow joiner(100, kModel);
  for (std::size_t k = 0; k < way.size(); ++k)
  {
    Reading reading = seenFrom(way[k], kMap, {0, 2, 3}, kSensor);
    for (Detection& d : reading.detections)
    {
      *d.bearing += d.std_bearing * random.gaussian();
      *d.range += d.std_range * random.gaussian();
    }
    joiner.add(frameAt(static_cast<double>(k), k > 0 ? said : OdometryMotion{}, {reading}));
  }
  return joiner.readings();
}
}  // namespace

TEST(MeasurementWindow, AReadingCanBeGivenBackAsItWasTaken)
{
  RandomStream random(7);
  for (const Reading& reading : joinedDrive({2, 3, 0.5}, random))
    for (const Detection& d : withoutOdometryNoise(reading).detections) EXPECT_NEAR(d.std_bearing, degToRad(0.5), 1e-9);
}

TEST(MeasurementWindow, APoseSolvedFromJoinedReadingsIsAsUncertainAsItSays)
{
  RandomStream random(8);
  const int trials = 500;
  double squared = 0;
  for (int trial = 0; trial < trials; ++trial)
  {
    const Pose2 end{random.uniform(1, 4), random.uniform(1, 4), random.uniform(-kPi, kPi)};
    const PoseMl fit = refineCarriedPose(windowMeasurements(joinedDrive(end, random), kMap), end);
    ASSERT_EQ(fit.status, SolveStatus::ok);
    Vector3d e = fit.pose.mean.vector() - end.vector();
    e.z() = wrap(e.z());
    squared += e.dot(fit.pose.covariance.inverse() * e) / trials;
  }
  EXPECT_NEAR(squared, 3, 3.3 * std::sqrt(6.0 / trials));  // 99.9 % band
}

namespace
{
/// Keeps what it is given.
class Listener : public Localizer
{
 public:
  explicit Listener(Frame& heard) : heard_(heard) {}
  [[nodiscard]] std::string name() const override { return "listener"; }
  [[nodiscard]] bool continuous() const override { return false; }
  Estimate process(const Frame& frame) override
  {
    heard_ = frame;
    return {.status = SolveStatus::none};
  }

 private:
  Frame& heard_;
};
}  // namespace

TEST(WindowedLocalizer, HandsTheJoinedReadingsToTheMethod)
{
  Frame heard;
  WindowedLocalizer localizer(std::make_unique<Listener>(heard), 5, kModel);
  EXPECT_EQ(localizer.name(), "listener_joined");
  EXPECT_FALSE(localizer.continuous());
  Frame first = frameAt(0, {}, {seenFrom({}, kMap, {0}, kSensor)});
  first.compass = CompassRecord{.heading = 1};
  EXPECT_EQ(localizer.process(first).status, SolveStatus::none);
  EXPECT_TRUE(heard.compass);
  (void)localizer.process(frameAt(1, motionOf({1, 0, 0}), {seenFrom({1, 0, 0}, kMap, {1}, kSensor)}));
  EXPECT_EQ(heard.time, 1);
  EXPECT_FALSE(heard.compass);
  ASSERT_EQ(heard.readings.size(), 2u);
  EXPECT_NEAR(heard.readings[0].T_robot_sensor.x, kSensor.T_robot_sensor.x - 1, 1e-12);
}
}  // namespace mrpt_ext
