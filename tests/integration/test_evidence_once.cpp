#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/maps/register_all_classes.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"
#include "scratch_folder.h"
#include "whole_runs.h"

// Evidence is counted once: a running fix is two ranges; where the log has these ranges, the fix adds nothing to them.
namespace mrpt_ext::test_evidence_once
{
namespace
{
namespace fs = std::filesystem;

constexpr double kStart = 1000, kDuration = 40, kStdRange = 0.1, kStdHeading = degToRad(2.0);
constexpr double kRadius = 2, kSpeed = 0.5;

/// A circle around (5, 5), begun at (7, 5) heading along y.
Pose2 robotAt(double time)
{
  const double angle = kSpeed / kRadius * (time - kStart);
  return {5 + kRadius * std::cos(angle), 5 + kRadius * std::sin(angle), wrap(angle + kPi / 2)};
}

LandmarkTable fourCorners()
{
  return LandmarkTable({{.id = 1, .position = {0, 0, 0}},
                        {.id = 2, .position = {10, 0, 0}},
                        {.id = 3, .position = {10, 10, 0}},
                        {.id = 4, .position = {0, 10, 0}}});
}

struct Contents
{
  bool ranges = false, fixes = false;
  std::string label_of_fixes = "sonar";
};

/// Odometry, a compass, and every two seconds a range to one landmark, then another one a second later: one pair is
/// one running fix, no range is part of two.
Recording recordingWith(const Contents& contents)
{
  Recording recording;
  recording.map = fourCorners();
  RandomStream random(7);
  double first_range = 0;
  for (int k = 0; k <= static_cast<int>(10 * kDuration); ++k)
  {
    const double time = kStart + 0.1 * k;
    const Pose2 robot = robotAt(time);
    recording.records.push_back(OdometryRecord{time, robot});
    recording.truth.push_back({time, robot, true});
    if (k % 10 != 0) continue;
    recording.records.push_back(
        CompassRecord{time, "compass", wrap(robot.phi + kStdHeading * random.gaussian()), kStdHeading});
    const Landmark& landmark = recording.map[static_cast<std::size_t>(k / 20) % 4];
    const double range = (landmark.position.head<2>() - robot.position()).norm() + kStdRange * random.gaussian();
    if (contents.ranges)
      recording.records.push_back(Reading{.time = time,
                                          .sensor = "sonar",
                                          .horizontal_range = true,
                                          .detections = {{.id = landmark.id, .range = range, .std_range = kStdRange}}});
    if (k % 20 == 10 && contents.fixes)
    {
      RunningFixReading fix{.time = time, .first_time = time - 1, .sensor = contents.label_of_fixes};
      fix.horizontal_range = true;
      fix.id = landmark.id;
      fix.first_range = first_range;
      fix.second_range = range;
      fix.first_std = fix.second_std = kStdRange;
      fix.displacement = between(robotAt(time - 1), robot);
      fix.displacement_covariance.diagonal() << 1e-6, 1e-6, 1e-6;
      recording.records.push_back(fix);
    }
    first_range = range;
  }
  return recording;
}

class EvidenceOnce : public ::testing::Test
{
 protected:
  /// The filter's steps over a log with these contents, from a known start.
  std::vector<testing::StepRow> stepsWith(const Contents& contents)
  {
    registerAllClasses();
    const fs::path place = folder_.path() / std::to_string(++count_);
    fs::create_directory(place);
    const Recording recording = recordingWith(contents);
    const testing::LogFiles log = testing::logFiles(place, "log");
    writeRawlog(log.rawlog, recording);
    writeLandmarkCsv(log.map, recording.map);
    writeTum(log.truth, recording.truth);
    const auto run = testing::localized(
        place, "tracking",
        testing::joined(
            log.arguments(),
            {"--set", "LocalizationExperiment.init_PDF_mean_x=7", "--set", "Sensor_compass.std_heading_deg=2", "--set",
             "LocalizationExperiment.init_PDF_std_xy=0.5", "--set", "LocalizationExperiment.particles_count=5000",
             "--set", "LocalizationExperiment.methods=particle_filter running_fix"}));
    EXPECT_EQ(testing::summaryOf(run).at("verdict"), "ok") << testing::summaryOf(run).at("verdict_reason");
    return testing::stepsOf(run);
  }

  testing::ScratchFolder folder_;
  int count_ = 0;
};

/// Mean variance of the position over the second half of the log [m^2].
double positionVariance(const std::vector<testing::StepRow>& steps)
{
  double sum = 0;
  int count = 0;
  for (const testing::StepRow& step : steps)
    if (step.time > kStart + kDuration / 2) sum += step.cxx + step.cyy, ++count;
  EXPECT_GT(count, 5);
  return sum / count;
}

void expectSameSteps(const std::vector<testing::StepRow>& a, const std::vector<testing::StepRow>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    EXPECT_EQ(a[k].x, b[k].x) << "step " << k;
    EXPECT_EQ(a[k].y, b[k].y) << "step " << k;
    EXPECT_EQ(a[k].cxx, b[k].cxx) << "step " << k;
    EXPECT_EQ(a[k].cyy, b[k].cyy) << "step " << k;
  }
}
}  // namespace

TEST_F(EvidenceOnce, FixesAddNothingToTheirOwnRanges)
{
  expectSameSteps(stepsWith({.ranges = true}), stepsWith({.ranges = true, .fixes = true}));
}

TEST_F(EvidenceOnce, NorDoTheyUnderAnotherLabel)
{
  expectSameSteps(stepsWith({.ranges = true}),
                  stepsWith({.ranges = true, .fixes = true, .label_of_fixes = "running_fix"}));
}

TEST_F(EvidenceOnce, FixesAloneAreWorthTheirTwoRanges)
{
  const double with_ranges = positionVariance(stepsWith({.ranges = true}));
  const auto fixes = stepsWith({.fixes = true});
  EXPECT_EQ(fixes.size(), 20U);
  // Once: about the same variance. Not at all: that of the start and of the odometry; twice: about half of it.
  EXPECT_NEAR(positionVariance(fixes) / with_ranges, 1, 0.3);
}
}  // namespace mrpt_ext::test_evidence_once
