#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/localizers/particle_filter_localizer.h"
#include "mrpt_ext/solvers/running_fix.h"
#include "test_length.h"

namespace mrpt_ext::test_known_heading
{
namespace
{
// Paper 004's field, in metres, and noise: ranges of 3 cm, bearings and the compass of 1 deg.
constexpr double kWide = 1.5, kDeep = 1.3, kStdRange = 0.03, kStdAngle = degToRad(1.0);
const Vector2d kCorner{0, 0.45};
const LandmarkTable kMap({{.id = 1, .position = {kCorner.x(), kCorner.y(), 0}}});

struct Drive
{
  Pose2 first, second;
  double first_range = 0, second_range = 0;
  std::vector<Frame> frames;
};

Frame frameAt(const Pose2& pose, double time, double range, RandomStream& random)
{
  Reading reading{.time = time, .sensor = "stereo", .horizontal_range = true};
  reading.model.clutter_probability = 0.001;
  const double bearing = wrap(predictBearing(pose, kCorner) + kStdAngle * random.gaussian());
  reading.detections = {
      {.id = 1, .bearing = bearing, .range = range, .std_bearing = kStdAngle, .std_range = kStdRange}};
  Frame frame{.time = time, .readings = {reading}};
  frame.compass = CompassRecord{time, "compass", wrap(pose.phi + kStdAngle * random.gaussian()), kStdAngle};
  return frame;
}

/// Straight on for ten standard deviations of a range, odometry exact.
Drive driveOn(RandomStream& random)
{
  const Pose2 step{10 * kStdRange, 0, 0};
  Drive drive;
  do {
    drive.first = {random.uniform(0.1, kWide), random.uniform(0, kDeep), random.uniform(-kPi, kPi)};
    drive.second = compose(drive.first, step);
  } while (!PoseRegion{{0, 0}, {kWide, kDeep}}.contains(drive.second) || predictRange(drive.second, kCorner) < 0.15);
  drive.first_range = predictRange(drive.first, kCorner) + kStdRange * random.gaussian();
  drive.second_range = predictRange(drive.second, kCorner) + kStdRange * random.gaussian();
  drive.frames = {frameAt(drive.first, 0, drive.first_range, random),
                  frameAt(drive.second, 1, drive.second_range, random)};
  drive.frames[1].motion = {step, step.x, 0, 1};
  return drive;
}

double filterError(const Drive& drive, std::uint64_t seed)
{
  ParticleFilterOptions options;
  options.region = {{0, 0}, {kWide, kDeep}};
  options.modes.cell_xy = 0.08;
  options.motion = {.std_xy_per_m = 0, .std_phi_per_deg = 0, .std_phi_per_m = 0, .std_xy_per_s = 1e-3};
  ParticleFilterLocalizer filter(options, kMap, 0, seed);
  for (const Frame& frame : drive.frames) (void)filter.process(frame);
  return (filter.lastStep().modes.modes.front().pose.mean.position() - drive.second.position()).norm();
}

/// Of the better one of the two candidates, with the displacement in the map's axes known exactly.
double fixError(const Drive& drive)
{
  const RunningFix fix = runningFix({.landmark = kCorner,
                                     .displacement = drive.second.position() - drive.first.position(),
                                     .first_range = drive.first_range,
                                     .second_range = drive.second_range,
                                     .first_std = kStdRange,
                                     .second_std = kStdRange});
  double best = kWide;
  for (const RunningFixCandidate& candidate : fix.candidates)
    best = std::min(best, (candidate.second.mean - drive.second.position()).norm());
  return best;
}
}  // namespace

TEST(KnownHeading, OneLandmarkSufficesWhereTwoCirclesHardlyCross)
{
  const int runs = testing::runsOfTest(200);
  RandomStream random(4);
  double filter = 0, fix = 0;
  for (int run = 0; run < runs; ++run)
  {
    const Drive drive = driveOn(random);
    filter += square(filterError(drive, static_cast<std::uint64_t>(run)));
    fix += square(fixError(drive));
  }
  filter = std::sqrt(filter / runs);
  fix = std::sqrt(fix / runs);
  if (testing::isShort()) return;  // too few runs for the bounds
  RecordProperty("filter_rmse_m", std::to_string(filter));
  RecordProperty("two_circles_rmse_m", std::to_string(fix));
  EXPECT_LE(filter, 0.04) << "two circles: " << fix;
  EXPECT_GE(fix, 3 * filter);
}
}  // namespace mrpt_ext::test_known_heading
