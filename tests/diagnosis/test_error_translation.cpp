#include "mrpt_ext/diagnosis/error_translation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/calibration/trajectory_model.h"

namespace mrpt_ext::test_error_translation
{
namespace
{
using Kind = CalibrationParameter;

const std::vector<CalibrationUnknown> kErrors{
    {Kind::distance_scale}, {Kind::distance_per_turn}, {Kind::rotation_scale}, {Kind::pivot_scale}, {Kind::drift}};

/// A straight way, an arc to either side, a turn in place, and a rest: a record each half second.
std::vector<OdometryRecord> drive()
{
  std::vector<OdometryRecord> records{{0, {0.5, -1, 2}}};
  for (int k = 0; k < 40; ++k)
  {
    const Pose2 step = k < 8    ? Pose2{0.2, 0, 0}
                       : k < 16 ? Pose2{0.2, 0, 0.1}
                       : k < 24 ? Pose2{0.15, 0, -0.2}
                       : k < 32 ? Pose2{0, 0, 0.3}
                                : Pose2{};
    records.push_back({records.back().time + 0.5, compose(records.back().pose, step)});
  }
  return records;
}

/// The configuration that takes the errors up.
OdometryCorrection corrected(const LocalizationConfig& config, const CalibrationResult& found)
{
  OdometryCorrection now = config.frames.odometry;
  const auto value = [&](std::size_t k) { return findingOf(found.errors[k], found, {}, config).estimate; };
  now.scale = value(0);
  now.distance_per_turn = radToDeg(value(1));
  now.rotation_scale = value(2);
  now.pivot_scale = value(3);
  now.turn_per_s = degToRad(value(4));
  return now;
}
}  // namespace

TEST(ErrorTranslation, TakesErrorsOfOdometryUpBesideWhatIsConfigured)
{
  LocalizationConfig config;
  config.frames.odometry = {
      .scale = 1.2, .distance_per_turn = -0.05, .rotation_scale = 0.8, .pivot_scale = 1.3, .turn_per_s = 0.002};
  CalibrationResult found;
  Eigen::VectorXd values(5);
  values << 0.002, -0.001, -0.003, 0.002, 0.0005;
  for (std::size_t k = 0; k < kErrors.size(); ++k)
  {
    ParameterEstimate& error = found.errors.emplace_back();
    error.unknown = kErrors[k];
    error.value = values[static_cast<Eigen::Index>(k)];
    error.observable = true;
  }

  const OdometryPath before(drive(), config.frames.odometry), after(drive(), corrected(config, found));
  CalibrationProblem problem;
  for (const TimedPose& entry : before.trajectory())
  {
    problem.odometry.push_back({entry.time, entry.pose});
    problem.poses.push_back({entry.time, entry.pose, {}});
  }
  TrajectoryModel model(problem, kErrors);
  model.setErrors(values);
  double changes = 0;
  for (std::size_t k = 1; k < problem.poses.size(); ++k)
  {
    const double from = problem.poses[k - 1].time, to = problem.poses[k].time;
    const Vector3d expected = model.motion(k).moved.vector(), is = after.between(from, to).increment.vector();
    // Axes of the later pose turn the chord by half of the turn that is added.
    EXPECT_NEAR(is.head<2>().norm(), expected.head<2>().norm(), 1e-5) << k;
    EXPECT_NEAR(is.z(), expected.z(), 1e-5) << k;
    changes += (is - before.between(from, to).increment.vector()).norm();
  }
  EXPECT_GT(changes, 0.01);
}
}  // namespace mrpt_ext::test_error_translation
