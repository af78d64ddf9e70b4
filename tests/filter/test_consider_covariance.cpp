#include "mrpt_ext/filter/consider/consider_covariance.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <map>

#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "simulated_run.h"
#include "test_length.h"

namespace mrpt_ext::test_consider_covariance
{
namespace
{
/// How the sensor of a run errs beside the stated white noise.
struct LastingErrors
{
  double white = 1;           // noise, relative to the stated standard deviation
  double of_landmark = 0;     // standard deviation of the constant error of each landmark, relative to the stated one
  double range_offset = 0;    // [m]
  double bearing_offset = 0;  // [rad]
  Vector2d lever{0, 0};       // [m]
  std::optional<double> lever_std = 0;  // [m] as it is given
  Vector2d followed{0, 0};              // [m] the point that odometry follows, from the robot's
  double delay = 0;                     // [s]
  double delay_std = 0;                 // [s] as it is given
  double turn_scale = 0;                // of odometry
  double drift = 0;                     // [rad/s]
};

struct Statistics
{
  double steps = 0, covered = 0, covered_as_stated = 0;
  double heading_covered = 0, heading_covered_as_stated = 0;
  double variance = 0, stated_variance = 0;
};

double mahalanobis2Of(const Vector2d& error, const Matrix3d& covariance)
{
  const Matrix2d C = covariance.topLeftCorner<2, 2>();
  return error.dot(C.inverse() * error);
}

constexpr double kInside = 5.991;       // 95 % of chi square with two degrees of freedom
constexpr double kInsideOfOne = 3.841;  // ... with one
constexpr double kPeriod = 0.2;         // [s]
const SensorModel kLeverArm{.lever_arm_std = 0.05, .delay_std = 0};

const MotionModel kGoodWheels{.std_xy_per_m = 0.02,
                              .std_phi_per_deg = 0.1,
                              .std_phi_per_m = degToRad(0.5),
                              .std_xy_per_s = 0.002,
                              .std_phi_per_s = degToRad(0.1)};

/// The pose after k periods: figures of eight, now faster, now slower.
Pose2 poseAt(int k)
{
  const auto position = [](double t)
  {
    const double a = 0.12 * t + 0.4 * std::sin(0.15 * t);
    return Vector2d(5 + 3 * std::sin(a), 5 + 2 * std::sin(2 * a));
  };
  const double t = kPeriod * k;
  const Vector2d at = position(t), ahead = position(t + 1e-3) - at;
  return {at.x(), at.y(), std::atan2(ahead.y(), ahead.x())};
}

Frame frameOf(const LandmarkTable& map, int k, const LastingErrors& errors,
              std::map<std::pair<int, bool>, double>& constant, RandomStream& random)
{
  constexpr double kRange = 0.03, kBearing = 0.015;
  const Pose2 before = poseAt(k - 1), truth = poseAt(k);
  const Vector2d swung = (rotation(truth.phi) - rotation(before.phi)) * errors.followed;
  const Vector2d moved = rotation(before.phi).transpose() * (truth.position() - before.position() + swung);
  const Pose2 step{moved.x(), moved.y(), wrap(truth.phi - before.phi)};
  Frame frame;
  frame.time = kPeriod * k;
  frame.motion = {
      .increment = step, .path_length = step.position().norm(), .turned = std::abs(step.phi), .duration = kPeriod};
  const Vector3d std = incrementStd(kGoodWheels, frame.motion);
  Pose2& told = frame.motion.increment;
  told.phi = step.phi / (1 + errors.turn_scale) - errors.drift * kPeriod;
  told = {told.x + std.x() * random.gaussian(), told.y + std.y() * random.gaussian(),
          told.phi + std.z() * random.gaussian()};
  const double late = errors.delay / kPeriod;
  const Pose2 then{truth.x - late * (truth.x - before.x), truth.y - late * (truth.y - before.y),
                   wrap(truth.phi - late * wrap(truth.phi - before.phi))};
  Reading reading;
  reading.time = frame.time;
  reading.sensor = "laser";
  reading.model.clutter_probability = 0.01;
  reading.model.lever_arm_std = errors.lever_std;
  reading.model.delay_std = errors.delay_std;
  const Pose2 lever{errors.lever.x(), errors.lever.y(), 0};
  for (const Landmark& landmark : map.all())
  {
    const Vector2d at = landmark.position.head<2>();
    const double range = predictRange(then, at, lever);
    if (range < 1 || range > 6) continue;
    const auto lasting = [&](bool bearing)
    {
      auto [found, is_new] = constant.try_emplace({landmark.id, bearing}, 0.0);
      if (is_new) found->second = errors.of_landmark * random.gaussian();
      return found->second + errors.white * random.gaussian();
    };
    Detection detection;
    detection.id = landmark.id;
    detection.std_bearing = kBearing;
    detection.std_range = kRange;
    detection.bearing = wrap(predictBearing(then, at, lever) + errors.bearing_offset + kBearing * lasting(true));
    detection.range = range + errors.range_offset + kRange * lasting(false);
    reading.detections.push_back(detection);
  }
  frame.readings = {reading};
  return frame;
}

/// Has followed a robot straight on among landmarks, whose sensor is where it is said to be and measures when it says.
ConsiderCovariance followedStraightOn(double start_std, bool given, const SensorModel& sensor)
{
  RandomStream random(3, 1);
  const LandmarkTable map = randomMap(10, 10, random);
  const GaussianPose start{{1.9, 5, 0}, square(start_std) * Matrix3d::Identity()};
  ConsiderCovariance consider(kGoodWheels, {}, map, given ? std::optional(start) : std::nullopt);
  KalmanState state = startingState(start, {});
  for (int k = 0; k < 40; ++k)
  {
    Frame frame{.time = kPeriod * k,
                .motion = {.increment = {0.1, 0, 0}, .path_length = 0.1, .duration = kPeriod},
                .readings = {Reading{.time = kPeriod * k, .sensor = "laser", .model = sensor}}};
    for (const Landmark& landmark : map.all())
    {
      Detection detection{.id = landmark.id, .std_bearing = 0.015, .std_range = 0.03};
      detection.bearing = predictBearing({2 + 0.1 * k, 5, 0}, landmark.position.head<2>());
      detection.range = predictRange({2 + 0.1 * k, 5, 0}, landmark.position.head<2>());
      frame.readings.front().detections.push_back(detection);
    }
    state = updateExtended(predict(state, {}, kGoodWheels, frame.motion), frame, map, {}).state;
    consider.follow(state, frame, true);
  }
  return consider;
}

Matrix3d addedOnAStraightWay(double start_std, bool given, const SensorModel& sensor)
{
  return followedStraightOn(start_std, given, sensor).added();
}

/// Adds one run of a Kalman filter that knows of white errors only. The first 100 seconds are not counted.
void run(const LastingErrors& errors, std::uint64_t seed, Statistics& statistics)
{
  RandomStream random(seed, 1);
  const LandmarkTable map = randomMap(10, 10, random);
  KalmanState state = startingState({poseAt(0), Vector3d(0.01, 0.01, 0.01).cwiseAbs2().asDiagonal()}, {});
  ConsiderCovariance consider(kGoodWheels, {}, map, {});
  consider.follow(state, {}, true);
  std::map<std::pair<int, bool>, double> constant;
  for (int k = 1; k < 1500; ++k)
  {
    const Frame frame = frameOf(map, k, errors, constant, random);
    state = updateExtended(predict(state, {}, kGoodWheels, frame.motion), frame, map, {}).state;
    consider.follow(state, frame, true);
    if (k < 500) continue;
    const Vector2d error = state.pose().position() - poseAt(k).position();
    const Matrix3d stated = state.gaussianPose().covariance, honest = stated + consider.added();
    statistics.steps += 1;
    statistics.covered += mahalanobis2Of(error, honest) < kInside;
    statistics.covered_as_stated += mahalanobis2Of(error, stated) < kInside;
    const double turned2 = square(wrap(state.pose().phi - poseAt(k).phi));
    statistics.heading_covered += turned2 < kInsideOfOne * honest(2, 2);
    statistics.heading_covered_as_stated += turned2 < kInsideOfOne * stated(2, 2);
    statistics.stated_variance += stated.topLeftCorner<2, 2>().trace();
    statistics.variance += honest.topLeftCorner<2, 2>().trace();
  }
}

Statistics runs(const LastingErrors& errors, std::uint64_t first_seed = 100, int count = 20)
{
  Statistics statistics;
  for (int k = 0; k < testing::runsOfTest(count); ++k)
    run(errors, first_seed + static_cast<std::uint64_t>(k), statistics);
  return statistics;
}
}  // namespace

TEST(ConsiderCovariance, WhiteErrorsAddNothing)
{
  const Statistics all = runs({});
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_LT(all.variance, 1.05 * all.stated_variance);
  EXPECT_NEAR(all.covered / all.steps, all.covered_as_stated / all.steps, 0.01);
}

TEST(ConsiderCovariance, CoversErrorsOfTheMap)
{
  const Statistics all = runs({.white = 0.6, .of_landmark = 0.8});
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_LT(all.covered_as_stated / all.steps, 0.75);
  EXPECT_GT(all.covered / all.steps, 0.90);
  EXPECT_LT(all.covered / all.steps, 0.99);
}

TEST(ConsiderCovariance, CoversARangeOffset)
{
  const Statistics all = runs({.range_offset = 0.06});
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_LT(all.covered_as_stated / all.steps, 0.5);
  EXPECT_GT(all.covered / all.steps, 0.90);
}

TEST(ConsiderCovariance, CoversABearingOffset)
{
  const Statistics all = runs({.bearing_offset = degToRad(2)});
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_LT(all.heading_covered_as_stated / all.steps, 0.5);
  EXPECT_GT(all.covered / all.steps, 0.90);
  EXPECT_GT(all.heading_covered / all.steps, 0.90);
}

TEST(ConsiderCovariance, CoversADelay)
{
  for (const double given : {0.0, 0.05})
  {
    const Statistics all = runs({.delay = 0.1, .delay_std = given});
    if (testing::isShort()) return;  // too few runs for the bounds
    EXPECT_LT(all.covered_as_stated / all.steps, 0.5);
    EXPECT_GT(all.covered / all.steps, 0.90);
  }
}

TEST(ConsiderCovariance, CoversALeverArm)
{
  for (const double given : {0.0, 0.05})
  {
    const Statistics all = runs({.lever = {0.05, 0.05}, .lever_std = given});
    if (testing::isShort()) return;  // too few runs for the bounds
    EXPECT_LT(all.covered_as_stated / all.steps, 0.5);
    EXPECT_GT(all.covered / all.steps, 0.90);
  }
}

// Nobody says how well places are known: less than where it is stated to be 5 cm once turns tell that they agree.
TEST(ConsiderCovariance, ALeverArmOfUnknownAccuracyIsCoveredWhetherItIsRightOrWrong)
{
  const Statistics wrong = runs({.lever = {0.05, 0.05}, .lever_std = std::nullopt});
  const Statistics right = runs({.lever_std = std::nullopt}), stated = runs({.lever_std = 0.05});
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_GT(wrong.covered / wrong.steps, 0.90);
  EXPECT_GT(right.covered / right.steps, 0.95);
  EXPECT_LT(right.variance - right.stated_variance, 0.5 * (stated.variance - stated.stated_variance));
}

// Turns tell where the sensor is from the point that odometry follows, and nothing whether that is the robot's.
TEST(ConsiderCovariance, CoversAnotherPointThatOdometryAndSensorAgreeOn)
{
  const Statistics all = runs({.lever = {0.04, -0.03}, .lever_std = 0.05, .followed = {0.04, -0.03}});
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_LT(all.covered_as_stated / all.steps, 0.5);
  EXPECT_GT(all.covered / all.steps, 0.90);
}

// Before it turns nothing tells whether the sensor is where it is said to be: 5 cm in each axis.
TEST(ConsiderCovariance, StatesALeverArmThatNothingTells)
{
  const Matrix3d added = addedOnAStraightWay(0.01, false, kLeverArm);
  EXPECT_NEAR(std::sqrt(added(0, 0)), 0.05, 0.01);
  EXPECT_NEAR(std::sqrt(added(1, 1)), 0.05, 0.01);
}

// At half a metre per second and nothing but constant speed: 5 cm for a tenth of a second.
TEST(ConsiderCovariance, StatesADelayThatNothingTells)
{
  const Matrix3d added = addedOnAStraightWay(0.01, false, {.lever_arm_std = 0, .delay_std = 0.1});
  EXPECT_NEAR(std::sqrt(added(0, 0)), 0.05, 0.01);
  EXPECT_LT(std::sqrt(added(1, 1)), 0.01);
  EXPECT_LT(std::sqrt(addedOnAStraightWay(0.01, false, {.lever_arm_std = 0, .delay_std = 0})(0, 0)), 0.01);
}

// No reading and no motion tells which way the axes point that the heading refers to.
TEST(ConsiderCovariance, StatesTheDirectionsOfSensorsAsTheyAreKnown)
{
  const SensorModel exact{.lever_arm_std = 0, .delay_std = 0};
  SensorModel turned = exact;
  turned.yaw_std = degToRad(2.0);
  const Matrix3d added = addedOnAStraightWay(0.01, false, turned) - addedOnAStraightWay(0.01, false, exact);
  EXPECT_NEAR(std::sqrt(added(2, 2)), degToRad(2.0), 1e-9);
  EXPECT_NEAR((added.topLeftCorner<2, 2>().norm()), 0, 1e-12);
  EXPECT_EQ(followedStraightOn(0.01, false, turned).finding(square(0.01) * Matrix3d::Identity()),
            "yaw_std_deg: standard deviation 2.1 deg instead of 0.6 deg");
}

TEST(ConsiderCovariance, AnExactStartOwesNothingToTheReadings)
{
  const Matrix3d added = addedOnAStraightWay(0.001, true, kLeverArm);
  EXPECT_LT(std::sqrt(added(0, 0)), 0.025);
  EXPECT_LT(std::sqrt(added(1, 1)), 0.025);
}

// What the readings correct of it they correct to where the sensor is said to be.
TEST(ConsiderCovariance, ARoughStartIsSoonThatOfTheReadings)
{
  const Matrix3d added = addedOnAStraightWay(0.3, true, kLeverArm);
  EXPECT_NEAR(std::sqrt(added(0, 0)), 0.05, 0.01);
  EXPECT_NEAR(std::sqrt(added(1, 1)), 0.05, 0.01);
}

TEST(ConsiderCovariance, CoversOdometryThatTurnsLessAndDrifts)
{
  const Statistics all = runs({.turn_scale = 0.1, .drift = degToRad(0.4)});
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_GT(all.covered / all.steps, 0.90);
}

TEST(ConsiderCovariance, SensorsTakeTurns)
{
  RandomStream random(7, 1);
  const LandmarkTable map = randomMap(10, 10, random);
  ConsiderCovariance consider({}, {}, map, {});
  std::map<std::pair<int, bool>, double> constant;
  for (int k = 1; k < 100; ++k)
  {
    Frame frame = frameOf(map, k, {.of_landmark = 2, .lever_std = 0.05}, constant, random);
    frame.readings.front().sensor = "laser " + std::to_string(k % 3);
    if (k % 4 == 0) frame.readings.clear();
    if (k % 30 == 0) consider.restart();
    consider.follow(startingState({poseAt(k), 1e-4 * Matrix3d::Identity()}, {}), frame, true);
    EXPECT_TRUE(consider.added().allFinite());
  }
  EXPECT_GT(consider.added().trace(), 0);
}

TEST(ConsiderCovariance, OnlyAVerifiedPoseTellsTheNoiseOfOdometry)
{
  const auto excessAfter = [](bool verified)
  {
    RandomStream random(7, 1);
    const LandmarkTable map = randomMap(10, 10, random);
    ConsiderCovariance consider({}, {}, map, {});
    std::map<std::pair<int, bool>, double> constant;
    for (int k = 1; k < 200; ++k)
    {
      Frame frame = frameOf(map, k, {}, constant, random);
      frame.motion.increment.phi += degToRad(10) * random.gaussian();
      consider.follow(startingState({poseAt(k), 1e-4 * Matrix3d::Identity()}, {}), frame, verified);
    }
    Frame next;
    next.motion = {{0.5, 0, 0.1}, 0.5, 0.1, 1};
    return consider.withExcess(next).motion.excess.trace();
  };
  EXPECT_GT(excessAfter(true), 0);
  EXPECT_EQ(excessAfter(false), 0);
}

TEST(ConsiderCovariance, ANewEstimateHasNoLastingErrorYet)
{
  RandomStream random(7, 1);
  const LandmarkTable map = randomMap(10, 10, random);
  ConsiderCovariance consider({}, {}, map, {});
  EXPECT_EQ(consider.added(), Matrix3d::Zero());
  std::map<std::pair<int, bool>, double> constant;
  for (int k = 1; k < 500; ++k)
  {
    const Frame frame = frameOf(map, k, {.of_landmark = 2}, constant, random);
    consider.follow(startingState({poseAt(k), 1e-4 * Matrix3d::Identity()}, {}), frame, true);
  }
  EXPECT_GT(consider.added().trace(), 0);
  consider.restart();
  EXPECT_EQ(consider.added(), Matrix3d::Zero());
}

// ... but that of the lever arm, which nothing has told yet.
TEST(ConsiderCovariance, EveryEstimateThatIsFoundHasTheLeverArmAtOnce)
{
  RandomStream random(7, 1);
  const LandmarkTable map = randomMap(10, 10, random);
  ConsiderCovariance consider({}, {}, map, {});
  std::map<std::pair<int, bool>, double> constant;
  for (int k = 1; k < 3; ++k)
  {
    const Frame frame = frameOf(map, k, {.lever_std = 0.05}, constant, random);
    consider.follow(startingState({poseAt(k), 1e-4 * Matrix3d::Identity()}, {}), frame, true);
    EXPECT_NEAR(std::sqrt(consider.added()(0, 0)), 0.05, 1e-6);
    EXPECT_NEAR(std::sqrt(consider.added()(1, 1)), 0.05, 1e-6);
    consider.restart();
  }
}
}  // namespace mrpt_ext::test_consider_covariance
