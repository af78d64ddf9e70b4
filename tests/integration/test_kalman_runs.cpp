#include <gtest/gtest.h>

#include <cmath>

#include "scratch_folder.h"
#include "whole_runs.h"

// The Kalman filters beside the particle filter, in whole runs over shipped configurations.
namespace mrpt_ext::test_kalman_runs
{
namespace
{
using testing::Arguments;

Arguments methods(const std::string& names) { return {"--set", "LocalizationExperiment.methods=" + names}; }

const std::string kAll = "particle_filter extended_kalman_filter iterated_kalman_filter kalman_filter_bank";
}  // namespace

TEST(KalmanRun, TrackingComesCloseToTheBoundAndTheReportComparesTheMethods)
{
  const testing::ScratchFolder folder;
  const auto log = testing::simulated(folder.path(), "tracking");
  const auto run = testing::localized(folder.path(), "tracking", testing::joined(log.arguments(), methods(kAll)));
  const nlohmann::json summary = testing::summaryOf(run);
  const double bound = summary.at("limit").at("pcrlb_position_rmse_m");
  EXPECT_GT(bound, 0.005);
  EXPECT_GT(summary.at("limit").at("pcrlb_heading_rmse_deg"), 0.05);
  for (const char* method : {"extended_kalman_filter", "iterated_kalman_filter", "kalman_filter_bank"})
  {
    // One run of 40 s: its RMSE scatters by some ten per cent about what is reached on average.
    EXPECT_LT(testing::positionRmse(summary, method), 1.4 * bound) << method;
    EXPECT_GT(testing::positionRmse(summary, method), 0.7 * bound) << method;
  }
}

TEST(KalmanRun, TheBankFindsThePoseAmongLandmarksThatLookAlike)
{
  const testing::ScratchFolder folder;
  const auto run = testing::localized(folder.path(), "room", methods("kalman_filter_bank"));
  const nlohmann::json summary = testing::summaryOf(run);
  EXPECT_LT(testing::positionRmse(summary, "kalman_filter_bank"), 0.1);
  EXPECT_EQ(summary.at("verdict"), "ok") << summary.at("verdict_reason");
  const auto steps = testing::stepsOf(run, "kalman_filter_bank");
  ASSERT_FALSE(steps.empty());
  EXPECT_NE(steps.front().verdict, "ok");
  EXPECT_GT(steps.front().modes, 1);
  EXPECT_EQ(steps.back().verdict, "ok");
  EXPECT_TRUE(summary.at("limit").at("pcrlb_position_rmse_m").is_null()) << "the true associations are not known";
}

TEST(KalmanRun, ASystematicErrorOfTheRangesIsFoundAndTakenOff)
{
  const testing::ScratchFolder folder;
  // All ranges of the log are taken for 10 % longer than they were.
  const Arguments too_long =
      testing::joined(methods("extended_kalman_filter"), {"--set", "Sensor_stereo.scale_range=0.9"});
  const auto spoilt = testing::localized(folder.path() / "spoilt", "half-field", too_long);
  const auto found = testing::localized(folder.path() / "found", "half-field",
                                        testing::joined(too_long, {"--set", "Bias.range_scale_std=0.1"}));
  const double before = testing::positionRmse(testing::summaryOf(spoilt), "extended_kalman_filter");
  const double after = testing::positionRmse(testing::summaryOf(found), "extended_kalman_filter");
  EXPECT_FALSE(after >= 0.7 * before) << before << " -> " << after;
  EXPECT_LT(after, 0.12);
}
}  // namespace mrpt_ext::test_kalman_runs
