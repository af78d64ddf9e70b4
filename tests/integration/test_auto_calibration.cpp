#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/settings/settings.h"
#include "scratch_folder.h"
#include "test_length.h"
#include "whole_runs.h"

namespace mrpt_ext::test_auto_calibration
{
namespace
{
using testing::Arguments;
using testing::joined;
using Json = nlohmann::json;

const Arguments kFilterAlone{"--set", "LocalizationExperiment.methods=particle_filter odometry"};
const Arguments kAsConfigured{"--set", "LocalizationExperiment.auto_calibrate=false"};
const Arguments kCalibrated{"--set", "LocalizationExperiment.auto_calibrate=true"};

/// A log of the half field whose camera is late and whose wheels are small.
testing::LogFiles erroneousLog(const std::filesystem::path& folder)
{
  return testing::simulated(folder, "half-field",
                            {"--set", "Simulation.duration_s=150", "--set", "Odometry.scale_error=0.08", "--set",
                             "Sensor_stereo.delay_s=0.25", "--set", "Simulation.random_seed=5"});
}

std::filesystem::path run(const std::filesystem::path& folder, const testing::LogFiles& log, const Arguments& more)
{
  return testing::localized(folder, "half-field", joined(joined(log.arguments(), kFilterAlone), more));
}

/// The adopted value; NaN when there is none.
double adopted(const Json& summary, const std::string& key)
{
  if (summary.at("calibration").is_null()) return NAN;
  for (const Json& value : summary.at("calibration").at("adopted"))
    if (value.at("key") == key) return value.at("value");
  return NAN;
}
}  // namespace

TEST(AutoCalibration, FindsAndAppliesWhatTheLogShows)
{
  const testing::ScratchFolder folder;
  const testing::LogFiles log = erroneousLog(folder.path());
  const auto calibrated = run(folder.path() / "calibrated", log, kCalibrated);
  const Json summary = testing::summaryOf(calibrated),
             plain = testing::summaryOf(run(folder.path() / "plain", log, kAsConfigured));
  EXPECT_NEAR(adopted(summary, "Sensor_stereo.delay_s"), 0.25, 0.03) << summary.at("calibration");
  EXPECT_NEAR(adopted(summary, "MotionModel.odometry_scale"), 1 / 1.08, 0.02) << summary.at("calibration");
  EXPECT_LT(testing::positionRmse(summary), 0.8 * testing::positionRmse(plain));

  EXPECT_TRUE(plain.at("calibration").is_null());
  const Json& rows = summary.at("calibration").at("rows");
  EXPECT_NEAR(rows.at("before").at("position_rmse_m"), testing::positionRmse(plain), 1e-9);
  EXPECT_NEAR(rows.at("after").at("position_rmse_m"), testing::positionRmse(summary), 1e-9);
  EXPECT_GT(rows.at("after").at("log_density"), rows.at("before").at("log_density"));

  const Settings kept = Settings::load(calibrated / "calibration.ini", localizationKeys());
  EXPECT_DOUBLE_EQ(kept.number("Sensor_stereo", "delay_s"), adopted(summary, "Sensor_stereo.delay_s"));
  EXPECT_NE(readTextFile(calibrated / "report.html").find("Calibrated from the log"), std::string::npos);
  EXPECT_NE(readTextFile(calibrated / "log.txt").find("[Sensor_stereo] delay_s"), std::string::npos);
}

TEST(AutoCalibration, NeverSeesTheTruth)
{
  const testing::ScratchFolder folder;
  const testing::LogFiles log = erroneousLog(folder.path());
  const auto seeing = run(folder.path() / "seeing", log, kCalibrated);
  const auto blind = testing::localized(
      folder.path() / "blind", "half-field",
      joined(joined({log.rawlog, "--map", log.map, "--set", "LocalizationExperiment.ground_truth_path_file="},
                    kFilterAlone),
             kCalibrated));
  EXPECT_EQ(readTextFile(seeing / "calibration.ini"), readTextFile(blind / "calibration.ini"));
}

TEST(AutoCalibration, IsTheSameForEveryTrialAndPart)
{
  const testing::ScratchFolder folder;
  const testing::LogFiles log = erroneousLog(folder.path());
  const auto whole = run(folder.path() / "whole", log, joined(kCalibrated, {"--repeat", "2", "--jobs", "2"}));
  const auto part = run(folder.path() / "part", log, joined(kCalibrated, {"--trials", "1:2"}));
  EXPECT_EQ(readTextFile(whole / "trial_001" / "steps.csv"), readTextFile(part / "trial_001" / "steps.csv"));
}

TEST(AutoCalibration, LeavesAGoodLogAsItIs)
{
  const testing::ScratchFolder folder;
  const testing::LogFiles log =
      testing::simulated(folder.path(), "half-field",
                         {"--set", "Odometry.std_xy_per_m=0.04", "--set", "Odometry.std_phi_deg_per_deg=0.15", "--set",
                          "Odometry.std_phi_deg_per_m=1.5"});
  const auto calibrated = run(folder.path() / "calibrated", log, kCalibrated),
             plain = run(folder.path() / "plain", log, kAsConfigured);
  EXPECT_TRUE(testing::summaryOf(calibrated).at("calibration").is_null())
      << testing::summaryOf(calibrated).at("calibration");
  EXPECT_EQ(readTextFile(calibrated / "steps.csv"), readTextFile(plain / "steps.csv"));
  EXPECT_FALSE(std::filesystem::exists(calibrated / "calibration.ini"));
}

TEST(AutoCalibration, RangesThatAreTakenForDepthsAreToldAndTrackedAgain)
{
  const testing::ScratchFolder folder;
  const testing::LogFiles log =
      testing::simulated(folder.path(), "half-field",
                         {"--set", "Simulation.duration_s=150", "--set", "Sensor_stereo.field_of_view_deg=90"});
  const auto calibrated = run(folder.path() / "calibrated", log,
                              joined(kCalibrated, {"--set", "Sensor_stereo.range_along_axis=true"})),
             plain = run(folder.path() / "plain", log, kAsConfigured);
  const Json summary = testing::summaryOf(calibrated);
  ASSERT_FALSE(summary.at("calibration").is_null());
  EXPECT_NE(readTextFile(calibrated / "calibration.ini").find("range_along_axis = false\n"), std::string::npos)
      << summary.at("calibration");
  const Json& rows = summary.at("calibration").at("rows");
  EXPECT_GT(rows.at("after").at("log_density"), rows.at("before").at("log_density"));
  EXPECT_LT(testing::positionRmse(summary), rows.at("before").at("position_rmse_m"));
  EXPECT_LT(testing::positionRmse(summary), 1.2 * testing::positionRmse(testing::summaryOf(plain)));
}

TEST(AutoCalibration, WithAnonymousBearingsOdometryThatErrsIsTrackedAgainWithItsErrorsAsStates)
{
  if (testing::isShort()) GTEST_SKIP() << "a run of two passes";
  const testing::ScratchFolder folder;
  const testing::LogFiles log = testing::simulated(
      folder.path(), "bad-odometry",
      {"--set", "Simulation.duration_s=90", "--seed", "14", "--set", "Sensor_camera.identity=anonymous", "--set",
       "Sensor_camera.kind=bearings", "--set", "Sensor_camera.delay_s=0.3", "--set", "RandomErrors.delay_s=0", "--set",
       "Map.box=0 15 0 8 0 0", "--set", "Map.count=15"});
  const auto out = folder.path() / "run";
  const testing::AppOutcome outcome = testing::localize(
      joined(joined(log.arguments(), kFilterAlone),
             {"--set", "LocalizationExperiment.particles_count=500", "--set",
              "LocalizationExperiment.initial_particles_count=5000", "--seed", "2", "-o", out, "-q"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json summary = testing::summaryOf(out);
  EXPECT_NEAR(adopted(summary, "MotionModel.odometry_delay_s"), 0.3, 0.03);
  EXPECT_EQ(adopted(summary, "Bias.odometry_veer_std_deg_per_m"), 2);
  EXPECT_EQ(adopted(summary, "Bias.odometry_rotation_scale_std"), 0.05);
  EXPECT_EQ(adopted(summary, "Bias.odometry_distance_scale_std"), 0.05);
  const Json& rows = summary.at("calibration").at("rows");
  EXPECT_TRUE(rows.at("before").at("log_density").is_null());
  const double before = rows.at("before").at("verdict_shares").at("ok");
  EXPECT_GT(rows.at("after").at("verdict_shares").at("ok"), before + 0.2);
  EXPECT_LT(testing::positionRmse(summary), 0.5);
  // What it used can be kept and run again.
  const testing::AppOutcome again =
      testing::localize({out / "config_resolved.ini", "-q", "-o", folder.path() / "again"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(readTextFile(folder.path() / "again" / "steps.csv"), readTextFile(out / "steps.csv"));
}

TEST(AutoCalibration, IsNotForShortLogs)
{
  const testing::ScratchFolder folder;
  const testing::LogFiles log = testing::simulated(
      folder.path(), "half-field", {"--set", "Simulation.duration_s=50", "--set", "Sensor_stereo.delay_s=0.25"});
  EXPECT_TRUE(testing::summaryOf(run(folder.path() / "run", log, kCalibrated)).at("calibration").is_null());
}

TEST(BuiltInConfiguration, NeedsALogAndAMapOnly)
{
  const testing::ScratchFolder folder;
  const testing::LogFiles log =
      testing::simulated(folder.path(), "half-field",
                         {"--set", testing::isShort() ? "Simulation.duration_s=20" : "Simulation.duration_s=90"});
  const auto out = folder.path() / "run";
  const testing::AppOutcome outcome = testing::localize(joined(log.arguments(), {"-o", out, "-q"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json summary = testing::summaryOf(out);
  if (!testing::isShort())
  {
    EXPECT_LT(testing::positionRmse(summary), 0.1);
  }
  EXPECT_EQ(summary.at("config"), "built-in configuration");
  // What it used can be kept and run again.
  const testing::AppOutcome again =
      testing::localize({out / "config_resolved.ini", "-q", "-o", folder.path() / "again"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(readTextFile(folder.path() / "again" / "steps.csv"), readTextFile(out / "steps.csv"));
}

TEST(BuiltInConfiguration, SaysThatTheMapIsMissing)
{
  const testing::ScratchFolder folder;
  const testing::LogFiles log = testing::simulated(folder.path(), "half-field", {"--set", "Simulation.duration_s=10"});
  const testing::AppOutcome outcome = testing::localize({log.rawlog, "-o", folder.path() / "run"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("--map FILE"), std::string::npos) << outcome.err;
}
}  // namespace mrpt_ext::test_auto_calibration
