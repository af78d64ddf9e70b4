#include "mrpt_ext/calibration/trajectory_model.h"

#include <gtest/gtest.h>

#include "recorded_drive.h"

namespace mrpt_ext::test_trajectory_model
{
namespace
{
const std::vector<CalibrationUnknown> kTerms{{CalibrationParameter::delay},
                                             {CalibrationParameter::bearing_offset},
                                             {CalibrationParameter::range_offset},
                                             {CalibrationParameter::range_scale},
                                             {CalibrationParameter::distance_scale},
                                             {CalibrationParameter::rotation_scale},
                                             {CalibrationParameter::veer},
                                             {CalibrationParameter::drift},
                                             {CalibrationParameter::lever_arm_x},
                                             {CalibrationParameter::lever_arm_y},
                                             {CalibrationParameter::landmark_x, 0, 1},
                                             {CalibrationParameter::landmark_y, 0, 1},
                                             {CalibrationParameter::bearing_scale},
                                             {CalibrationParameter::range_axis},
                                             {CalibrationParameter::distance_per_turn},
                                             {CalibrationParameter::pivot_scale}};
constexpr double kStep = 1e-5;

Pose2 moved(const Pose2& pose, int axis, double by)
{
  return {pose.x + (axis == 0 ? by : 0), pose.y + (axis == 1 ? by : 0), pose.phi + (axis == 2 ? by : 0)};
}

/// A drive without noise, its poses a little off, with some errors set.
struct Scene
{
  testing::DrivePlan plan{.field_of_view = degToRad(120.0), .rests = true, .pivots = true};
  RandomStream random{2};
  CalibrationProblem problem = testing::recordedDrive(plan, random);
  TrajectoryModel model{problem, kTerms};

  Scene()
  {
    Eigen::VectorXd errors(16);
    errors << 0.1, 0.02, 0.3, 0.05, -0.06, 0.08, 0.04, 0.01, 0.07, -0.05, 0.2, -0.1, -0.03, 0.04, -0.06, 0.15;
    model.setErrors(errors);
  }
  [[nodiscard]] Eigen::VectorXd with(int term, double by) const
  {
    Eigen::VectorXd errors = model.errors();
    errors[term] += by;
    return errors;
  }
};
}  // namespace

TEST(TrajectoryModel, DerivativesOfReadingsAreTheirDifferences)
{
  Scene scene;
  for (std::size_t i = 0; i < scene.problem.readings.size(); i += 37)
  {
    const CalibrationReading& r = scene.problem.readings[i];
    const Pose2 pose = scene.problem.poses[r.pose].pose;
    const ReadingResidual row = scene.model.reading(r, pose);
    const auto predictedAt = [&](const Pose2& at) { return -scene.model.reading(r, at).residual; };
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(row.own[axis],
                  (predictedAt(moved(pose, axis, kStep)) - predictedAt(moved(pose, axis, -kStep))) / (2 * kStep), 1e-3);
    for (int term = 1; term < 16; ++term)  // the delay is a difference itself
    {
      TrajectoryModel plus = scene.model, minus = scene.model;
      plus.setErrors(scene.with(term, kStep));
      minus.setErrors(scene.with(term, -kStep));
      EXPECT_NEAR(row.shared[term], (minus.reading(r, pose).residual - plus.reading(r, pose).residual) / (2 * kStep),
                  1e-3);
    }
  }
}

TEST(TrajectoryModel, DerivativesOfLinksAreTheirDifferences)
{
  Scene scene;
  for (std::size_t k = 1; k < scene.problem.poses.size(); k += 23)
  {
    const Pose2 before = scene.problem.poses[k - 1].pose, pose = scene.problem.poses[k].pose;
    const OdometryResidual row = scene.model.link(k, before, pose);
    const double unit = row.next.norm();
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3d by_before = (scene.model.linkResidual(k, moved(before, axis, -kStep), pose) -
                                  scene.model.linkResidual(k, moved(before, axis, kStep), pose)) /
                                 (2 * kStep);
      const Vector3d by_pose = (scene.model.linkResidual(k, before, moved(pose, axis, -kStep)) -
                                scene.model.linkResidual(k, before, moved(pose, axis, kStep))) /
                               (2 * kStep);
      EXPECT_LT((row.own.col(axis) - by_before).norm(), 1e-6 * unit);
      EXPECT_LT((row.next.col(axis) - by_pose).norm(), 1e-6 * unit);
    }
    for (int term = 0; term < 16; ++term)
    {
      TrajectoryModel plus = scene.model, minus = scene.model;
      plus.setErrors(scene.with(term, kStep));
      minus.setErrors(scene.with(term, -kStep));
      const Vector3d difference =
          (minus.linkResidual(k, before, pose) - plus.linkResidual(k, before, pose)) / (2 * kStep);
      EXPECT_LT((row.shared.col(term) - difference).norm(), 1e-6 * unit) << term;
    }
  }
}

TEST(TrajectoryModel, MotionIsTheInverseOfALink)
{
  Scene scene;
  for (std::size_t k = 1; k < scene.problem.poses.size(); k += 23)
  {
    const Pose2 before = scene.problem.poses[k - 1].pose;
    const MotionPrediction motion = scene.model.motion(k);
    EXPECT_LT(scene.model.linkResidual(k, before, compose(before, motion.moved)).norm(), 1e-6);
    for (const int term : {4, 5, 6, 7, 14, 15})
    {
      TrajectoryModel plus = scene.model, minus = scene.model;
      plus.setErrors(scene.with(term, kStep));
      minus.setErrors(scene.with(term, -kStep));
      const Vector3d difference = (plus.motion(k).moved.vector() - minus.motion(k).moved.vector()) / (2 * kStep);
      EXPECT_LT((motion.shared.col(term) - difference).norm(), 1e-7);
    }
  }
}
}  // namespace mrpt_ext::test_trajectory_model
