#include <gtest/gtest.h>

#include "paper_settings.h"
#include "sections.h"

// Paper 004 by tests/papers/paper-004-ranges.ini, paper-004-located.ini, paper-004-open-study.ini and
// paper-004-drive.ini; the drive is that of ini/landmark-simulator/goal-corners-stereo.ini, localized as in
// ini/landmark-localization/.
namespace mrpt_ext::papers::test_running_fix_tables
{
TEST(PaperRangeTables, AreWholePixelsAndFivePerCent)
{
  const auto ranges = runRangeExperiment(paperSettings("paper-004-ranges", {"Ranges.measurements=1000 1000"}));
  ASSERT_EQ(ranges.size(), 2u);
  const RangeResult &qvga = ranges[0], &vga = ranges[1];
  EXPECT_NEAR(qvga.paper.absolute.mean(), 0.049, 0.007);
  EXPECT_NEAR(qvga.paper.relative.mean(), 0.057, 0.009);
  EXPECT_NEAR(vga.paper.absolute.mean(), 0.045, 0.007);
  EXPECT_NEAR(vga.paper.relative.mean(), 0.051, 0.008);
  // Without the scale twice the resolution halves the error; with it hardly anything changes.
  EXPECT_LT(vga.calibrated.absolute.mean(), 0.6 * qvga.calibrated.absolute.mean());
  EXPECT_GT(vga.paper.absolute.mean(), 0.8 * qvga.paper.absolute.mean());
  EXPECT_LT(qvga.best.absolute.mean(), 0.5 * qvga.calibrated.absolute.mean());
  EXPECT_NEAR(qvga.best.absolute.mean() / qvga.bound.absolute.mean(), 1, 0.15);
}

TEST(PaperLocatedTables, RulesFollowFromEachOtherAndNoneGivesBothCounts)
{
  const auto e =
      runLocatedExperiment(paperSettings("paper-004-located", {"Experiment.trials=300", "RunningFix.repetitions=1",
                                                               "RunningFix.displacements_m=0.1 0.3"}));
  EXPECT_EQ(e.tried.size(), 16u);
  for (const LocatedShares& tried : e.tried)
    for (std::size_t w = 0; w < 2; ++w)
    {
      EXPECT_GE(tried.share[0][w], tried.share[1][w]);
      EXPECT_GE(tried.share[1][w], tried.share[2][w]);
    }
  for (const LocatedErrors& errors : e.errors)
  {
    EXPECT_LT(errors.best.distance.median(), 0.6 * errors.closed_form.distance.median());
    EXPECT_NEAR(errors.best.distance.median() / errors.bound.distance.median(), 1, 0.3);
    EXPECT_LT(errors.best.heading.median(), errors.closed_form.heading.median());
  }
}

TEST(PaperFixStudy, LongerWaysHelpUntilDeadReckoningSpoilsThem)
{
  const auto rows = runFixStudy(paperSettings(
      "paper-004-open-study", {"Experiment.trials=600", "Study.ratios=1 10 30", "Study.displacement_errors=0 0.1"}));
  ASSERT_EQ(rows.size(), 6u);
  const FixStudyRow &shortest = rows[0], &middle = rows[2], &longest = rows[4], &spoilt = rows[5];
  EXPECT_NEAR(shortest.missed, 0.53, 0.07);
  EXPECT_LT(longest.missed, 0.15);
  EXPECT_LT(middle.fix.median(), 0.5 * shortest.fix.median());
  EXPECT_LT(longest.fix.median(), 0.7 * middle.fix.median());
  EXPECT_GT(spoilt.fix.median(), 1.4 * longest.fix.median());
  EXPECT_NEAR(longest.fix.median() / longest.fix_bound.median(), 1, 0.25);
  for (const FixStudyRow& row : rows)
  {
    EXPECT_LT(row.likeliest.median(), 0.04);
    EXPECT_NEAR(row.likeliest.median() / row.likeliest_bound.median(), 1, 0.2);
  }
}

TEST(PaperLocatedTables, TheFilterDoesWithoutHeadingAndCalibration)
{
  const DriveErrors drive = runDrives(paperSettings("paper-004-drive", {"Drive.runs=3"}));
  ASSERT_EQ(drive.distance.count(), 3u);
  EXPECT_EQ(drive.lost, 0);
  EXPECT_LT(drive.distance.mean(), 0.05);
  ASSERT_EQ(drive.bound.count(), 3u);
  EXPECT_LT(drive.bound.mean(), 1.2 * drive.rmse.mean());
}
}  // namespace mrpt_ext::papers::test_running_fix_tables
