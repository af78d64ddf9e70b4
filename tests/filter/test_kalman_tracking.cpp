#include <gtest/gtest.h>

#include <Eigen/LU>

#include "mrpt_ext/evaluation/consistency.h"
#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "posterior_bounds.h"
#include "simulated_run.h"

namespace mrpt_ext::test_kalman_tracking
{
namespace
{
constexpr int kSteps = 150, kTransient = 20, kRuns = 60;
const Pose2 kStart{8, 5, kPi / 2};
const Matrix3d kPrior = Vector3d(0.01, 0.01, 0.001).asDiagonal();

using UpdateRule = KalmanUpdate (*)(const KalmanState&, const Frame&, const LandmarkTable&, const BiasModel&);

struct Tracking
{
  double error2 = 0, bound2 = 0;
  double nees_at_end = 0;  // of the last step of each run; the runs are independent
  double nis = 0;
  double degrees_of_freedom = 0;
  int count = 0;
};

/// One run in a 10 m square with 10 landmarks. Each step has 5 bearings with a standard deviation of one degree.
void track(std::uint64_t run, UpdateRule rule, Tracking& result)
{
  const SimulatedRobot robot;
  RandomStream random(29, run);
  const LandmarkTable map = randomMap(10, 10, random);
  const Pose2 guess{kStart.x + 0.1 * random.gaussian(), kStart.y + 0.1 * random.gaussian(),
                    kStart.phi + std::sqrt(0.001) * random.gaussian()};
  const MotionModel model = motionModelOf(robot);
  KalmanState state = startingState({guess, kPrior}, {});
  std::vector<BoundStep> bound_steps;
  Pose2 truth = kStart;
  std::vector<Vector3d> errors;
  for (int k = 0; k < kSteps; ++k)
  {
    BoundStep bound_step{k > 0 ? roundTripStep(k) : Pose2{}, k > 0 ? robot.odometry_std : Vector3d::Zero().eval()};
    truth = compose(truth, bound_step.increment);
    const Frame frame = simulatedFrame(robot, map, truth, bound_step.increment, random);
    for (const Detection& detection : frame.readings[0].detections)
      addInformation(bound_step.measurement_information,
                     bearingJacobian(truth, map[*map.indexOf(detection.id)].position.head<2>()), robot.std_bearing);
    bound_steps.push_back(bound_step);
    if (k > 0) state = predict(state, {}, model, frame.motion);
    const KalmanUpdate update = rule(state, frame, map, {});
    state = update.state;
    result.nis += update.nis;
    result.degrees_of_freedom += update.degrees_of_freedom;
    const Pose2 estimate = state.pose();
    errors.push_back({estimate.x - truth.x, estimate.y - truth.y, wrap(estimate.phi - truth.phi)});
  }
  const std::vector<Matrix3d> bounds = testing::posteriorBounds(kStart, kPrior, bound_steps);
  for (std::size_t k = kTransient; k < errors.size(); ++k)
  {
    result.error2 += errors[k].head<2>().squaredNorm();
    result.bound2 += bounds[k](0, 0) + bounds[k](1, 1);
  }
  result.nees_at_end += errors.back().dot(Matrix3d(state.covariance).inverse() * errors.back());
  ++result.count;
}
}  // namespace

TEST(KalmanTracking, ReachesThePosteriorCramerRaoBoundWithAConsistentCovariance)
{
  for (const UpdateRule rule : {updateExtended, updateIterated})
  {
    Tracking result;
    for (std::uint64_t run = 0; run < kRuns; ++run) track(run, rule, result);
    const double ratio = std::sqrt(result.error2 / result.bound2);
    EXPECT_LT(ratio, 1.08);
    EXPECT_GT(ratio, 0.9) << "better than the bound: an error of this test";
    // Independent runs: the sum of their NEES is chi-square with three degrees of freedom each.
    EXPECT_GT(result.nees_at_end, chiSquareQuantile(3.0 * kRuns, 0.025));
    EXPECT_LT(result.nees_at_end, chiSquareQuantile(3.0 * kRuns, 0.975));
    // Innovations of a consistent filter are white: the sum of their NIS is chi-square too.
    EXPECT_GT(result.nis, chiSquareQuantile(result.degrees_of_freedom, 0.005));
    EXPECT_LT(result.nis, chiSquareQuantile(result.degrees_of_freedom, 0.995));
  }
}

TEST(KalmanTracking, EstimatesSystematicErrorsTogetherWithThePose)
{
  const BiasModel biases{{.kind = BiasKind::range_scale, .std = 0.1},
                         {.kind = BiasKind::range_offset, .std = 0.3},
                         {.kind = BiasKind::bearing_offset, .std = 0.1},
                         {.kind = BiasKind::distance_scale, .std = 0.1},
                         {.kind = BiasKind::rotation_scale, .std = 0.1}};
  const KalmanVector wrong = (KalmanVector(5) << 0.05, -0.2, 0.06, 0.04, -0.05).finished();
  SimulatedRobot robot;
  robot.measures_range = true;
  robot.odometry_std = {0.002, 0.002, 0.002};
  MotionModel model = motionModelOf(robot);
  KalmanVector nees = KalmanVector::Zero(5);
  constexpr int kBiasRuns = 10;
  for (std::uint64_t run = 0; run < kBiasRuns; ++run)
  {
    RandomStream random(31, run);
    const LandmarkTable map = randomMap(10, 10, random);
    KalmanState state = startingState({kStart, kPrior}, biases);
    Pose2 truth = kStart;
    for (int k = 0; k < 400; ++k)
    {
      // Odometry measures distances that are 4 % too short and rotations that are 5 % too large.
      const Pose2 increment = k > 0 ? Pose2{0.1, 0, 0.04} : Pose2{};
      truth = compose(truth, increment);
      Frame frame = simulatedFrame(robot, map, truth, increment, random);
      Pose2& measured = frame.motion.increment;
      measured = {measured.x / 1.04, measured.y / 1.04, measured.phi / 0.95};
      for (Detection& d : frame.readings[0].detections)
      {
        d.range = 1.05 * *d.range - 0.2;
        d.bearing = wrap(*d.bearing + 0.06);
      }
      if (k > 0) state = predict(state, biases, model, frame.motion);
      state = updateExtended(state, frame, map, biases).state;
    }
    const KalmanVector found = state.mean.tail(5);
    for (int b = 0; b < 5; ++b)
    {
      nees[b] += square(found[b] - wrong[b]) / state.covariance(3 + b, 3 + b);
      EXPECT_LT(state.covariance(3 + b, 3 + b), 0.1 * square(biases[static_cast<std::size_t>(b)].std)) << b;
    }
  }
  for (int b = 0; b < 5; ++b) EXPECT_LT(nees[b], chiSquareQuantile(kBiasRuns, 0.999)) << "error " << b;
}
}  // namespace mrpt_ext::test_kalman_tracking
