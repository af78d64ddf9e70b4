#include <gtest/gtest.h>

#include "simulated_run.h"
#include "test_length.h"

namespace mrpt_ext::test_filter_standstill
{
namespace
{
constexpr int kDrive = 80, kHour = 3600;  // frames of a second

/// What the sensor measures, and whether it knows the landmarks.
struct SensorKind
{
  const char* name;
  bool bearing, range, identified;
};

class FilterStandstill : public ::testing::TestWithParam<SensorKind>
{
};

SimulatedRobot robotWith(const SensorKind& kind)
{
  SimulatedRobot robot;
  robot.measures_bearing = kind.bearing;
  robot.measures_range = kind.range;
  robot.identified = kind.identified;
  robot.detections = 6;
  robot.false_detections = 1;
  robot.clutter = 0.08;  // less than the false detections: one in seven
  robot.odometry_std = {0.003, 0.003, 0.001};
  return robot;
}
}  // namespace

TEST_P(FilterStandstill, AnHourChangesNoVerdict)
{
  const SimulatedRobot robot = robotWith(GetParam());
  const int end = kDrive + testing::runsOfTest(kHour);
  for (std::uint64_t run = 0; run < 1; ++run)
  {
    RandomStream random(17, run);
    const LandmarkTable map = randomMap(14, 10, random);
    ParticleFilterOptions options;
    options.particles = 500;
    options.region = {{0, 0}, {10, 10}};
    options.motion = motionModelOf(robot);
    options.initial_mode = InitialMode::gaussian;
    Pose2 truth{5, 2, 0};
    options.initial_pose = {truth, Vector3d(0.01, 0.01, 0.01).asDiagonal()};
    ParticleFilter filter(options, map, 7, run);
    int changed = 0;
    std::string reason;
    for (int k = 0; k < end; ++k)
    {
      const Pose2 increment = k < kDrive ? roundTripStep(k) : Pose2{};
      truth = compose(truth, increment);
      Frame frame = simulatedFrame(robot, map, truth, increment, random);
      if (k >= kDrive) frame.motion.increment = {};
      addFalseDetections(robot, map, frame, random);
      const FilterStep step = filter.process(frame, {});
      if (k < kDrive || step.verdict == Verdict::ok) continue;
      ++changed;
      reason = step.reason;
    }
    EXPECT_EQ(changed, 0) << "run " << run << ": " << reason;
  }
}

INSTANTIATE_TEST_SUITE_P(EverySensorKind, FilterStandstill,
                         ::testing::Values(SensorKind{"bearings", true, false, true},
                                           SensorKind{"ranges", false, true, true},
                                           SensorKind{"both", true, true, true},
                                           SensorKind{"anonymous_bearings", true, false, false},
                                           SensorKind{"anonymous_ranges_and_bearings", true, true, false}),
                         [](const auto& kind) { return std::string(kind.param.name); });
}  // namespace mrpt_ext::test_filter_standstill
