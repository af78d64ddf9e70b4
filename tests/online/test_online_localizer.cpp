#include "mrpt_ext/online/online_localizer.h"

#include <gtest/gtest.h>

#include <thread>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/online/online_snapshot.h"

namespace mrpt_ext::test_online_localizer
{
namespace
{
const LandmarkTable kMap({{1, {0, 0, 0}}, {2, {6, 0, 0}}, {3, {6, 5, 0}}, {4, {0, 5, 0}}});
constexpr double kRate = 10;  // [Hz] of odometry and of the camera

/// A robot on a circle in the room: 0.5 m/s ahead, 0.4 rad/s to the left.
Pose2 truthAt(double time)
{
  const double a = 0.4 * time, radius = 0.5 / 0.4;
  return {3 + radius * std::sin(a), 1.2 + radius * (1 - std::cos(a)), wrap(a)};
}

OnlineOptions roomOptions()
{
  OnlineOptions options;
  options.filter.region = {{0, 0}, {6, 5}};
  options.filter.particles = 500;
  options.filter.initial_particles = 4000;
  return options;
}

Reading readingAt(double time)
{
  Reading reading{.time = time, .sensor = "camera"};
  for (const Landmark& landmark : kMap.all())
    reading.detections.push_back({.id = landmark.id,
                                  .bearing = predictBearing(truthAt(time), landmark.position.head<2>()),
                                  .std_bearing = degToRad(1)});
  return reading;
}

std::vector<Record> driveUntil(double end)
{
  std::vector<Record> records;
  for (int k = 0; k / kRate <= end; ++k)
  {
    records.emplace_back(OdometryRecord{k / kRate, truthAt(k / kRate)});
    records.emplace_back(readingAt(k / kRate));
  }
  return records;
}

std::vector<OnlineEstimate> fed(OnlineLocalizer& robot, const std::vector<Record>& records)
{
  std::vector<OnlineEstimate> all;
  for (const Record& record : records)
  {
    robot.add(record);
    for (OnlineEstimate& estimate : robot.estimates()) all.push_back(std::move(estimate));
  }
  return all;
}

void expectAt(const PoseEstimate& estimate, const Pose2& truth, double within = 0.1)
{
  EXPECT_LT((estimate.pose.mean.position() - truth.position()).norm(), within);
  EXPECT_LT(std::abs(wrap(estimate.pose.mean.phi - truth.phi)), degToRad(3));
}
}  // namespace

TEST(OnlineLocalizer, EstimatesComeSoonAndAreRight)
{
  OnlineLocalizer robot(roomOptions(), kMap);
  std::vector<OnlineEstimate> all;
  for (const Record& record : driveUntil(6))
  {
    robot.add(record);
    for (OnlineEstimate& estimate : robot.estimates())
    {
      EXPECT_LE(timeOf(record) - estimate.time, 2 / kRate) << "as soon as the next odometry has come";
      all.push_back(std::move(estimate));
    }
  }
  for (OnlineEstimate& estimate : robot.finish()) all.push_back(std::move(estimate));
  ASSERT_EQ(all.size(), 61U);
  EXPECT_EQ(all.back().verdict, Verdict::ok) << all.back().reason;
  ASSERT_TRUE(all.back().best);
  EXPECT_EQ(all.back().time, 6);
  expectAt(*all.back().best, truthAt(6));
  EXPECT_TRUE(robot.unusable().empty());
}

TEST(OnlineLocalizer, WhatAStepIsTooShortForComesLaterAndIsTold)
{
  OnlineOptions hurried = roomOptions(), unhurried = roomOptions();
  hurried.step_budget_ms = 0.5;
  unhurried.step_budget_ms = 0;
  OnlineLocalizer robot(hurried, kMap), patient(unhurried, kMap);
  std::vector<OnlineEstimate> all = fed(robot, driveUntil(2));
  EXPECT_TRUE(robot.working() || !all.empty());
  for (OnlineEstimate& estimate : robot.finish()) all.push_back(std::move(estimate));
  EXPECT_FALSE(robot.working());
  std::vector<OnlineEstimate> expected = fed(patient, driveUntil(2));
  for (OnlineEstimate& estimate : patient.finish()) expected.push_back(std::move(estimate));
  ASSERT_EQ(all.size(), expected.size());
  std::size_t late = 0;
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    late += all[k].steps_late > 0 ? 1 : 0;
    EXPECT_EQ(all[k].reason, reasonWithLateness(expected[k].reason, all[k].steps_late)) << k;
    EXPECT_EQ(expected[k].steps_late, 0U);
    ASSERT_EQ(all[k].best.has_value(), expected[k].best.has_value()) << k;
    if (all[k].best)
    {
      EXPECT_EQ(all[k].best->pose.mean.vector(), expected[k].best->pose.mean.vector()) << k;
    }
  }
  EXPECT_GT(late, 0U);
}

TEST(OnlineLocalizer, LateRecordsWithinTheLatenessChangeNothing)
{
  OnlineOptions options = roomOptions();
  options.lateness = 0.25;
  std::vector<Record> records = driveUntil(4), late = records;
  // The camera's readings come two periods late.
  std::stable_sort(late.begin(), late.end(),
                   [](const Record& a, const Record& b)
                   {
                     const auto arrival = [](const Record& record)
                     { return timeOf(record) + (std::holds_alternative<Reading>(record) ? 0.2 : 0); };
                     return arrival(a) < arrival(b);
                   });
  OnlineLocalizer in_order(options, kMap), delayed(options, kMap);
  const auto a = fed(in_order, records), b = fed(delayed, late);
  ASSERT_GT(b.size(), 30U);
  ASSERT_LE(b.size(), a.size());
  for (std::size_t k = 0; k < b.size(); ++k)
  {
    EXPECT_EQ(a[k].time, b[k].time);
    ASSERT_EQ(a[k].best.has_value(), b[k].best.has_value());
    if (a[k].best)
    {
      EXPECT_EQ(a[k].best->pose.mean.x, b[k].best->pose.mean.x);
    }
  }
}

TEST(OnlineLocalizer, WhatIsTooLateIsCounted)
{
  OnlineLocalizer robot(roomOptions(), kMap);
  (void)fed(robot, driveUntil(1));
  robot.add(readingAt(0.2));
  robot.addOdometry(0.3, {});
  (void)robot.estimates();
  const UnusableDetections unusable = robot.unusable();
  EXPECT_EQ(unusable.at("camera: later than records may arrive"), 1U);
  EXPECT_EQ(unusable.at("odometry: older than the record before"), 1U);
}

TEST(OnlineLocalizer, AFrameDoesNotWaitForeverForOdometry)
{
  OnlineLocalizer robot(roomOptions(), kMap);
  std::vector<OnlineEstimate> all = fed(robot, driveUntil(2));
  ASSERT_LE(all.back().time, 2);
  for (int k = 21; k <= 40; ++k)  // the wheels' bus is silent
  {
    robot.add(readingAt(k / kRate));
    for (OnlineEstimate& estimate : robot.estimates()) all.push_back(std::move(estimate));
  }
  EXPECT_GT(all.back().time, 2.5);
  EXPECT_LE(all.back().time, 3.0) << "estimates wait one second";
}

TEST(OnlineLocalizer, ThePoseOfNowIsCarriedByOdometry)
{
  OnlineLocalizer robot(roomOptions(), kMap);
  EXPECT_FALSE(robot.poseAt(0));
  (void)fed(robot, driveUntil(5));
  for (int k = 51; k <= 70; ++k) robot.addOdometry(k / kRate, truthAt(k / kRate));
  const auto before = robot.poseAt(5), now = robot.poseAt(6.95);
  ASSERT_TRUE(before && now);
  EXPECT_EQ(now->time, 6.95);
  expectAt(*now, truthAt(6.95), 0.15);
  EXPECT_GT(now->pose.covariance.trace(), before->pose.covariance.trace()) << "odometry has noise";
}

TEST(OnlineLocalizer, VelocitiesAreIntegratedAsArcs)
{
  OnlineLocalizer robot(roomOptions(), kMap);
  for (int k = 0; k <= 60; ++k)
  {
    robot.addVelocity(k / kRate, 0.5, 0.4);
    robot.addDetections(k / kRate, "camera", readingAt(k / kRate).detections);
  }
  const std::vector<OnlineEstimate> all = robot.finish();
  ASSERT_TRUE(all.back().best);
  expectAt(*all.back().best, truthAt(6));
  robot.addVelocity(8, 0, 0);
  EXPECT_LT((robot.poseAt(8)->pose.mean.position() - truthAt(8).position()).norm(), 0.15);
}

TEST(OnlineLocalizer, ResetPutsItWhereItIsTold)
{
  OnlineLocalizer robot(roomOptions(), kMap);
  (void)fed(robot, driveUntil(2));
  const GaussianPose told{truthAt(2.05), Vector3d(0.01, 0.01, 0.001).asDiagonal()};
  robot.reset(2.05, told);
  Reading blind{.time = 2.9, .sensor = "camera"};  // one bearing alone keeps the pose where it was put
  blind.detections = {readingAt(2.9).detections[0]};
  robot.add(blind);
  robot.addOdometry(3, truthAt(3));
  const std::vector<OnlineEstimate> after = robot.estimates();
  ASSERT_FALSE(after.empty());
  ASSERT_TRUE(after.back().best);
  EXPECT_EQ(after.back().modes.size(), 1U);
  expectAt(*after.back().best, truthAt(2.9), 0.2);

  robot.reset(3.0);
  Reading one = blind;
  one.time = 3.9;
  robot.add(one);
  robot.addOdometry(4, truthAt(4));
  const std::vector<OnlineEstimate> unknown = robot.estimates();
  ASSERT_FALSE(unknown.empty());
  EXPECT_NE(unknown.back().verdict, Verdict::ok);
}

TEST(OnlineLocalizer, AnotherMapKeepsThePose)
{
  OnlineLocalizer robot(roomOptions(), kMap);
  (void)fed(robot, driveUntil(4));
  robot.setMap(LandmarkTable({{9, {3, 5, 0}}}));
  Reading reading{.time = 4.5, .sensor = "camera"};
  reading.detections = {{.id = 9, .bearing = predictBearing(truthAt(4.5), {3, 5}), .std_bearing = degToRad(1)}};
  robot.addOdometry(4.5, truthAt(4.5));
  robot.add(reading);
  const std::vector<OnlineEstimate> estimates = robot.finish();
  ASSERT_FALSE(estimates.empty());
  ASSERT_TRUE(estimates.back().best);
  EXPECT_EQ(estimates.back().time, 4.5);
  expectAt(*estimates.back().best, truthAt(4.5));
}

TEST(OnlineLocalizer, ASnapshotLetsItGoOn)
{
  OnlineLocalizer before(roomOptions(), kMap);
  EXPECT_FALSE(snapshotFrom(before.snapshot()).pose) << "nothing is known yet";
  (void)fed(before, driveUntil(6));
  OnlineLocalizer after(roomOptions(), kMap);
  after.restore(before.snapshot());
  // Another clock and another frame of the odometry; the robot has stood still between.
  after.addOdometry(100, {});
  Reading reading = readingAt(6);
  reading.time = 100;
  reading.detections.resize(1);
  after.add(reading);
  const std::vector<OnlineEstimate> estimates = after.finish();
  ASSERT_EQ(estimates.size(), 1U);
  ASSERT_TRUE(estimates[0].best);
  expectAt(*estimates[0].best, truthAt(6));
}

TEST(OnlineLocalizer, OneThreadMeasuresAndAnotherEstimates)
{
  OnlineLocalizer robot(roomOptions(), kMap);
  std::thread measuring(
      [&]
      {
        for (const Record& record : driveUntil(6)) robot.add(record);
      });
  std::size_t count = 0;
  while (count < 50)
  {
    count += robot.estimates().size();
    (void)robot.poseAt(3);
  }
  measuring.join();
  count += robot.finish().size();
  EXPECT_EQ(count, 61U);
}
}  // namespace mrpt_ext::test_online_localizer
