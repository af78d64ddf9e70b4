#include <gtest/gtest.h>

#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/settings/settings.h"
#include "scratch_folder.h"
#include "whole_runs.h"

namespace mrpt_ext::test_calibration_run
{
namespace
{
using testing::Arguments;
using testing::joined;

/// A log of the half field whose sensor and odometry have known errors.
testing::LogFiles erroneousLog(const std::filesystem::path& folder)
{
  return testing::simulated(folder, "half-field",
                            {"--set", "Simulation.duration_s=240", "--set", "Odometry.scale_error=0.05", "--set",
                             "Odometry.rotation_scale_error=-0.04", "--set", "Sensor_stereo.delay_s=0.15", "--set",
                             "Sensor_stereo.bias_bearing_deg=2", "--set", "Sensor_stereo.scale_range=1.04"});
}

/// The configuration after calibration.
struct Calibrated
{
  testing::AppOutcome outcome;
  Settings settings;
};

Calibrated calibrate(const testing::ScratchFolder& folder, const Arguments& log)
{
  const auto shipped = testing::shipped("landmark-localization", "half-field");
  const auto ini = folder.write("calibrated.ini", readTextFile(shipped));
  const testing::AppOutcome outcome = testing::localize(joined({shipped, "--calibrate", ini}, log));
  return {outcome, Settings::load(ini, localizationKeys())};
}
}  // namespace

TEST(CalibrationRun, FindsTheErrorsOfASimulatedLogAndWritesThem)
{
  const testing::ScratchFolder folder;
  const Calibrated found = calibrate(folder, erroneousLog(folder.path()).arguments());
  ASSERT_EQ(found.outcome.exit_code, 0) << found.outcome.err;
  const Settings& settings = found.settings;
  EXPECT_NEAR(settings.number("Sensor_stereo", "delay_s"), 0.15, 0.03) << found.outcome.out;
  EXPECT_NEAR(settings.number("Sensor_stereo", "bias_bearing_deg"), 2, 0.4) << found.outcome.out;
  EXPECT_NEAR(settings.number("MotionModel", "odometry_scale"), 1 / 1.05, 0.02) << found.outcome.out;
  EXPECT_NEAR(settings.number("MotionModel", "odometry_rotation_scale"), 1 / 0.96, 0.02) << found.outcome.out;
  // Offset and scale of ranges are estimated together: only their effect on a typical range is well determined.
  const double at_three_metres =
      3 * settings.number("Sensor_stereo", "scale_range") + settings.number("Sensor_stereo", "bias_range_m");
  EXPECT_NEAR(at_three_metres, 3 * 1.04, 0.03) << found.outcome.out;
  EXPECT_NE(found.outcome.out.find("the truth was not used"), std::string::npos);
}

TEST(CalibrationRun, FindsALeverArmAndADrift)
{
  const testing::ScratchFolder folder;
  const auto log = testing::simulated(folder.path(), "uncalibrated",
                                      {"--set", "RandomErrors.lever_arm_m=0.2", "--set", "RandomErrors.noise_factor=1",
                                       "--set", "Odometry.drift_deg_s=1.5", "--set", "Simulation.random_seed=3"});
  const testing::AppOutcome diagnosed = testing::localize(
      joined({testing::shipped("landmark-localization", "uncalibrated"), "--diagnose"}, log.arguments()));
  ASSERT_EQ(diagnosed.exit_code, 0) << diagnosed.err;
  for (const char* key : {"[Sensor_camera] lever_arm_", "[MotionModel] odometry_turn_per_s_deg = -"})
    EXPECT_NE(diagnosed.out.find(std::string("set ") + key), std::string::npos) << diagnosed.out;
}

TEST(CalibrationRun, NoiseOfOdometryIsNoScale)
{
  const testing::ScratchFolder folder;
  const Calibrated found = calibrate(
      folder, testing::simulated(folder.path(), "half-field",
                                 {"--set", "Simulation.duration_s=240", "--set", "Odometry.std_phi_deg_per_deg=0.8",
                                  "--set", "Odometry.std_xy_per_m=0.08", "--set", "Sensor_stereo.delay_s=0.2"})
                  .arguments());
  ASSERT_EQ(found.outcome.exit_code, 0) << found.outcome.err;
  EXPECT_EQ(found.settings.number("MotionModel", "odometry_scale"), 1) << found.outcome.out;
  EXPECT_EQ(found.settings.number("MotionModel", "odometry_rotation_scale"), 1) << found.outcome.out;
}

TEST(CalibrationRun, LeavesTheConfigurationOfAGoodLogAlone)
{
  const testing::ScratchFolder folder;
  const Calibrated found = calibrate(folder, testing::simulated(folder.path(), "half-field").arguments());
  ASSERT_EQ(found.outcome.exit_code, 0) << found.outcome.err;
  EXPECT_NEAR(found.settings.number("Sensor_stereo", "delay_s"), 0, 0.05) << found.outcome.out;
  EXPECT_NEAR(found.settings.number("MotionModel", "odometry_scale"), 1, 0.05) << found.outcome.out;
  EXPECT_NE(found.outcome.out.find("consistent"), std::string::npos) << found.outcome.out;
}

TEST(CalibrationRun, NeedsAConfigurationToWriteInto)
{
  const auto shipped = testing::shipped("landmark-localization", "half-field");
  const testing::AppOutcome outcome = testing::localize({shipped, "--calibrate", "/nowhere/none.ini"});
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "--calibrate /nowhere/none.ini: no such file\n");
}

TEST(CalibrationRun, WithoutAConfigurationOneIsMade)
{
  const testing::ScratchFolder folder;
  const auto log = testing::simulated(folder.path(), "half-field",
                                      {"--set", "Simulation.duration_s=120", "--set", "Sensor_stereo.delay_s=0.2"});
  const auto ini = folder.path() / "new.ini";
  const testing::AppOutcome made =
      testing::localize({log.rawlog.string(), "--map", log.map.string(), "--calibrate", ini.string()});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("wrote " + ini.string() + ": the built-in configuration with these lines\n"),
            std::string::npos)
      << made.out;
  const Settings settings = Settings::load(ini, localizationKeys());
  EXPECT_NEAR(settings.number("Sensor_stereo", "delay_s"), 0.2, 0.05) << made.out;
  EXPECT_EQ(settings.number("LocalizationExperiment", "particles_count"), 2000);
  EXPECT_EQ(testing::localize({ini.string(), log.rawlog.string(), "--map", log.map.string(), "--dry-run"}).exit_code,
            0);
}

TEST(CalibrationRun, TheFormerNameOfTheOptionStillWorks)
{
  const testing::ScratchFolder folder;
  const auto log = testing::simulated(folder.path(), "half-field", {"--set", "Simulation.duration_s=30"}).arguments();
  const auto shipped = testing::shipped("landmark-localization", "half-field");
  const testing::AppOutcome diagnosed = testing::localize(joined({shipped, "--diagnose"}, log));
  EXPECT_EQ(diagnosed.exit_code, 0) << diagnosed.err;
  EXPECT_EQ(testing::localize(joined({shipped, "--examine"}, log)).out, diagnosed.out);
  EXPECT_EQ(testing::localize({"--help"}).out.find("--examine"), std::string::npos);
}
}  // namespace mrpt_ext::test_calibration_run
