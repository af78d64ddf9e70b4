#include <gtest/gtest.h>

#include "paper_settings.h"
#include "sections.h"

// Paper 001 by tests/papers/paper-001-lattice.ini, paper-001-drive.ini and paper-001-drive-turned.ini; the drive is
// that of ini/landmark-simulator/movis-lattice.ini, localized as in ini/landmark-localization/movis-lattice.ini.
namespace mrpt_ext::papers::test_movis_tables
{
namespace
{
const MovisExperiment& turnedCameras()
{
  static const MovisExperiment kMovis =
      runMovisExperiment(paperSettings("paper-001-lattice", {"Experiment.trials=150"}));
  return kMovis;
}
}  // namespace

TEST(PaperMovisTables, TheScenarioErrsAsThePaperPrinted)
{
  const MovisExperiment& e = turnedCameras();
  EXPECT_EQ(withinTwoSpreads(e.closed_form.mean_d, PrintedLattice::kMeanBefore), Outcome::reproduced);
  EXPECT_EQ(withinTwoSpreads(e.closed_form.median_d, PrintedLattice::kMedianBefore), Outcome::reproduced);
  EXPECT_EQ(withinTwoSpreads(e.origin_corrected.mean_d, PrintedLattice::kMeanAfter), Outcome::reproduced);
  EXPECT_EQ(withinTwoSpreads(e.origin_corrected.median_d, PrintedLattice::kMedianAfter), Outcome::reproduced);
}

TEST(PaperMovisTables, EqEightHelpsOnTheLeftAndHarmsOnTheRight)
{
  const MovisExperiment& e = turnedCameras();
  double left = 0, right = 0;
  for (std::size_t i = 0; i < e.worse.size(); ++i)
    (e.lattice.places[i].x() < 0 ? left : right) += e.lattice.places[i].x() == 0 ? 0 : e.worse[i] / 5;
  EXPECT_LT(left + 0.1, right);
  EXPECT_EQ(e.worse[e.lattice.origin], 0);
  EXPECT_NEAR(e.origin_corrected.at_point[e.lattice.origin].quantile(1), 0, 1e-9);
}

TEST(PaperMovisTables, EachStepBringsItNearerToTheLimit)
{
  const MovisExperiment& e = turnedCameras();
  EXPECT_LT(e.origin_corrected.mean_d.mean(), e.closed_form.mean_d.mean());
  EXPECT_LT(e.straight_closed.mean_d.mean(), e.origin_corrected.mean_d.mean());
  EXPECT_LT(e.best.mean_d.mean(), 0.7 * e.straight_closed.mean_d.mean());
  EXPECT_LT(e.best.mean_d.mean(), 1.35 * e.bound.mean_d.mean());
  EXPECT_GT(e.best.mean_d.mean(), 0.9 * e.bound.mean_d.mean());
  EXPECT_LT(e.best_told.mean_d.mean(), 0.02);
  EXPECT_GT(e.closed_form.ball_in_robot.mean(), 1.5 * e.best.ball_in_robot.mean());
  EXPECT_GT(e.origin_corrected.frame_slip.mean(), 0.05);
}

TEST(PaperMovisTables, NoisefreeStraightCamerasAreExact)
{
  const auto e = runMovisExperiment(
      paperSettings("paper-001-lattice", {"Experiment.trials=1", "Movis.std_bearing_deg=1e-7", "Movis.yaw_deg=0 0"}));
  EXPECT_LT(e.closed_form.mean_d.mean(), 1e-4);
  EXPECT_LT(e.origin_corrected.mean_d.mean(), 1e-4);
  EXPECT_LT(e.best.mean_d.mean(), 1e-4);
}

TEST(PaperMovisTables, TheScanPrefersTheScenariosCamerasToStraightOnes)
{
  const Settings settings =
      paperSettings("paper-001-lattice", {"YawScan.std_bearing_deg=0.07", "YawScan.common_deg=-0.3 0",
                                          "YawScan.difference_deg=0 0.2", "YawScan.trials=60"});
  const auto tries = scanYaw(settings);
  ASSERT_EQ(tries.size(), 4u);
  const MovisLattice scenario = readLattice(settings);
  ASSERT_EQ(likeliestMount(tries), &tries.front());
  EXPECT_TRUE(tries.front().explains);
  EXPECT_NEAR(tries.front().yaw[0], scenario.yaw[0], 1e-9);
  EXPECT_NEAR(tries.front().yaw[1], scenario.yaw[1], 1e-9);
  EXPECT_FALSE(tries.front().explainsHeading());
}

TEST(PaperMovisTables, TheFilterFindsTheAnglesOnADrive)
{
  const DriveErrors drive = runDrives(paperSettings("paper-001-drive", {"Drive.runs=1"}));
  ASSERT_EQ(drive.distance.count(), 1u);
  EXPECT_EQ(drive.lost, 0);
  EXPECT_LT(drive.distance.mean(), 0.5 * turnedCameras().closed_form.mean_d.mean());
  ASSERT_EQ(drive.bound.count(), 1u);
  EXPECT_GT(drive.bound.mean(), 0);
}
}  // namespace mrpt_ext::papers::test_movis_tables
