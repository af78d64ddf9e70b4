#include "mrpt_ext/configuration/localization_config.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "error_message.h"
#include "mrpt_ext/configuration/default_configuration.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/settings/setting_value.h"

namespace mrpt_ext::test_localization_config
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {0, -1, 0}}, {.id = 2, .position = {6, 4, 0}}});

LocalizationConfig configOf(const std::string& text)
{
  return localizationConfig(Settings::parse(text, "/a/b.ini", localizationKeys()), kMap);
}

std::string errorOf(const std::string& text)
{
  return testing::configurationErrorOf([&] { (void)configOf(text); });
}
}  // namespace

TEST(LocalizationKeys, EveryKeyExplainsItselfAndItsDefaultIsAcceptable)
{
  std::set<std::string> names;
  const KeyTable table = localizationKeys();
  for (const KeySpec& key : table.keys())
  {
    const std::string name = key.section + "." + key.name;
    EXPECT_TRUE(names.insert(name).second) << name << " is there twice";
    EXPECT_FALSE(key.help.empty()) << name;
    if (key.help.empty()) continue;
    EXPECT_EQ(key.help.back(), '.') << name;
    if (!key.default_value.empty())
    {
      EXPECT_FALSE(key.complaintAbout(key.default_value)) << name;
    }
    EXPECT_EQ(key.type == KeyType::choice || key.type == KeyType::names, !key.choices.empty()) << name;
    EXPECT_NE(table.explain(name).find(key.help.substr(0, 20)), std::string::npos) << name;
  }
}

TEST(LocalizationKeys, HoldWhatTheContractNames)
{
  const std::vector<std::pair<std::string, std::vector<std::string>>> contract{
      {"LocalizationExperiment", {"rawlog_file",          "ground_truth_path_file",
                                  "logOutput_dir",        "experimentRepetitions",
                                  "particles_count",      "init_PDF_min_x",
                                  "init_PDF_max_x",       "init_PDF_min_y",
                                  "init_PDF_max_y",       "random_seed",
                                  "init_PDF_mode",        "filter_engine",
                                  "frame_window_s",       "join_window_s",
                                  "independent_frames",   "ground_truth_format",
                                  "ground_truth_origin",  "converged_within_m",
                                  "converged_within_deg", "max_convergence_s",
                                  "heading_source",       "objects"}},
      {"MotionModel",
       {"type", "std_xy_per_m", "std_phi_deg_per_deg", "std_phi_deg_per_m", "std_xy_min", "std_phi_min_deg",
        "odometry_delay_s", "odometry_scale"}},
      {"Sensor_anything",
       {"delay_s", "std_bearing_deg", "std_range_m", "std_range_per_m", "bias_bearing_deg", "bias_range_m",
        "scale_range", "field_of_view_deg", "max_range_m", "clutter_probability", "detection_probability",
        "association", "scan_duration_s"}},
      {"PF_options", {"sampleSize", "PF_algorithm", "resamplingMethod", "adaptiveSampleSize", "BETA"}},
      {"KLD_options",
       {"KLD_binSize_XY", "KLD_binSize_PHI_deg", "KLD_delta", "KLD_epsilon", "KLD_minSampleSize", "KLD_maxSampleSize"}},
      {"MetricMap", {"landmarkMap2D_count"}},
      {"MetricMap_landmarkMap2D_00_creationOpts", {"landmarks_file"}}};
  const KeyTable table = localizationKeys();
  for (const auto& [section, keys] : contract)
    for (const std::string& key : keys) EXPECT_NE(table.find(section, key), nullptr) << section << " " << key;
}

TEST(LocalizationKeys, AFewAreMarkedForBeginners)
{
  const std::vector<KeySpec> keys = localizationKeys().keys();
  EXPECT_EQ(std::count_if(keys.begin(), keys.end(), [](const KeySpec& key) { return key.for_beginners; }), 10);
}

TEST(LocalizationKeys, ContractNamesOfTheNoiseAtStandstillAreAliases)
{
  const LocalizationConfig config = configOf("[MotionModel]\nstd_xy_min = 0.07\nstd_phi_min_deg = 2\n");
  EXPECT_EQ(config.filter.motion.std_xy_per_s, 0.07);
  EXPECT_EQ(config.filter.motion.std_phi_per_s, degToRad(2.0));
}

TEST(LocalizationKeys, TakeTheContractsChoicesByNameAndByMrptsNumber)
{
  const KeyTable table = localizationKeys();
  const auto accepts = [&](const char* section, const char* key, const char* value)
  { return !table.find(section, key)->complaintAbout(value); };
  for (const char* mode : {"analytic", "uniform", "gaussian"})
    EXPECT_TRUE(accepts("LocalizationExperiment", "init_PDF_mode", mode));
  for (const char* engine : {"batch", "mrpt"}) EXPECT_TRUE(accepts("LocalizationExperiment", "filter_engine", engine));
  for (const char* source : {"bearing", "compass", "filter", "none"})
    EXPECT_TRUE(accepts("LocalizationExperiment", "heading_source", source));
  for (const char* format : {"tum", "mrpt-index"})
    EXPECT_TRUE(accepts("LocalizationExperiment", "ground_truth_format", format));
  for (const char* type : {"odometry", "velocity", "random_walk"}) EXPECT_TRUE(accepts("MotionModel", "type", type));
  for (const char* names : {"known", "category", "anonymous"}) EXPECT_TRUE(accepts("Sensor_a", "association", names));
  for (const char* method : {"prMultinomial", "prResidual", "prStratified", "prSystematic", "0", "1", "2", "3"})
    EXPECT_TRUE(accepts("PF_options", "resamplingMethod", method));
  EXPECT_FALSE(accepts("LocalizationExperiment", "init_PDF_mode", "somewhere"));
}

TEST(LocalizationConfig, DefaultsAreThoseOfTheContract)
{
  const LocalizationConfig config = configOf("");
  EXPECT_EQ(config.filter.particles, 2000u);
  EXPECT_EQ(config.filter.initial_mode, InitialMode::analytic);
  EXPECT_EQ(config.engine, FilterEngine::batch);
  EXPECT_EQ(config.filter.resampling, ResamplingMethod::systematic);
  EXPECT_EQ(config.frames.window, 0.05);
  EXPECT_FALSE(config.frames.independent);
  EXPECT_EQ(config.join_window, 0);
  EXPECT_EQ(config.limits.within_m, 0.5);
  EXPECT_EQ(config.limits.within_deg, 15);
  EXPECT_EQ(config.limits.max_convergence_s, 60);
  EXPECT_EQ(config.running_fix.heading_source, HeadingSource::bearing);
  EXPECT_FALSE(config.running_fix.start_heading);
  EXPECT_TRUE(config.methods.empty());
  EXPECT_EQ(config.filter.motion.type, MotionType::odometry);
}

TEST(LocalizationConfig, TheBoxIsTheMapWithAMarginUnlessGiven)
{
  const PoseRegion around = configOf("[LocalizationExperiment]\ninit_PDF_margin_m = 2\n").filter.region;
  EXPECT_EQ(around.low, Vector2d(-2, -3));
  EXPECT_EQ(around.high, Vector2d(8, 6));
  const LocalizationConfig given = configOf("[LocalizationExperiment]\ninit_PDF_min_x = 1\ninit_PDF_max_y = 2\n");
  EXPECT_EQ(given.filter.region.low, Vector2d(1, -4));
  EXPECT_EQ(given.filter.region.high, Vector2d(9, 2));
  EXPECT_EQ(given.running_fix.region.low, given.filter.region.low);
  EXPECT_FALSE(given.region_assumed);
  EXPECT_FALSE(configOf("[LocalizationExperiment]\ninit_PDF_margin_m = 3\n").region_assumed);
  EXPECT_TRUE(configOf("").region_assumed);
}

TEST(LocalizationConfig, ContradictoryBoundsAreAnError)
{
  EXPECT_EQ(errorOf("[LocalizationExperiment]\ninit_PDF_min_x = 5\ninit_PDF_max_x = 5\n"),
            "/a/b.ini:3: init_PDF_max_x = 5: expected a value above init_PDF_min_x");
  EXPECT_EQ(errorOf("[LocalizationExperiment]\ninit_PDF_max_y = -9\n"),
            "/a/b.ini:2: init_PDF_max_y = -9: expected a value above init_PDF_min_y");
  EXPECT_NE(errorOf("[LocalizationExperiment]\ninit_PDF_min_y = 70\n").find("the box of possible positions is empty"),
            std::string::npos);
  EXPECT_EQ(errorOf("[KLD_options]\nKLD_minSampleSize = 5000\nKLD_maxSampleSize = 300\n"),
            "/a/b.ini:3: KLD_maxSampleSize = 300: expected KLD_minSampleSize <= KLD_maxSampleSize");
  EXPECT_EQ(errorOf("[KLD_options]\nKLD_minSampleSize = 200000\n"),
            "/a/b.ini:2: KLD_minSampleSize = 200000: expected KLD_minSampleSize <= KLD_maxSampleSize");
}

TEST(LocalizationConfig, AuxiliaryProposalsNeedMrptsEngine)
{
  const std::string algorithm = "[PF_options]\nPF_algorithm = pfAuxiliaryPFOptimal\n";
  EXPECT_NE(errorOf(algorithm).find("/a/b.ini:2: PF_algorithm = pfAuxiliaryPFOptimal: needs filter_engine = mrpt"),
            std::string::npos);
  EXPECT_EQ(configOf(algorithm + "[LocalizationExperiment]\nfilter_engine = mrpt\n").mrpt_algorithm, 3);
}

TEST(LocalizationConfig, ParticlesCountWinsOverSampleSize)
{
  EXPECT_EQ(configOf("[PF_options]\nsampleSize = 700\n").filter.particles, 700u);
  EXPECT_EQ(
      configOf("[PF_options]\nsampleSize = 700\n[LocalizationExperiment]\nparticles_count = 300\n").filter.particles,
      300u);
}

TEST(LocalizationConfig, DegreesBecomeRadians)
{
  const LocalizationConfig config = configOf(
      "[MotionModel]\nstd_phi_deg_per_m = 2\nstd_phi_min_deg = 0.5\nstd_phi_deg_per_deg = 0.4\n"
      "[LocalizationExperiment]\ninit_PDF_mode = gaussian\ninit_PDF_mean_phi_deg = 270\ninit_PDF_std_phi_deg = 3\n"
      "[KLD_options]\nKLD_binSize_PHI_deg = 9\n");
  EXPECT_NEAR(config.filter.motion.std_phi_per_m, degToRad(2), 1e-12);
  EXPECT_NEAR(config.filter.motion.std_phi_per_s, degToRad(0.5), 1e-12);
  EXPECT_EQ(config.filter.motion.std_phi_per_deg, 0.4);
  EXPECT_NEAR(config.filter.initial_pose.mean.phi, -kPi / 2, 1e-12);
  EXPECT_NEAR(config.filter.initial_pose.covariance(2, 2), square(degToRad(3)), 1e-12);
  EXPECT_NEAR(config.filter.kld.bin_phi, degToRad(9), 1e-12);
  ASSERT_TRUE(config.running_fix.start_heading);  // a known start is a heading
  EXPECT_NEAR(config.running_fix.start_heading->heading, -kPi / 2, 1e-12);
}

TEST(LocalizationConfig, OkIsAsPreciseAsLocalizedUnlessSetOtherwise)
{
  const VerdictOptions usual =
      configOf("[LocalizationExperiment]\nconverged_within_m = 1\nconverged_within_deg = 20\n").filter.verdict;
  EXPECT_EQ(usual.max_std_xy, 1);
  EXPECT_NEAR(usual.max_std_phi, degToRad(20), 1e-12);
  const VerdictOptions set = configOf("[ParticleFilter]\nok_max_std_m = 0.2\nok_max_std_deg = 3\n").filter.verdict;
  EXPECT_EQ(set.max_std_xy, 0.2);
  EXPECT_NEAR(set.max_std_phi, degToRad(3), 1e-12);
}

TEST(LocalizationConfig, ListsOfWords)
{
  EXPECT_EQ(parseWords(" ball, cup\tthing,,"), (std::vector<std::string>{"ball", "cup", "thing"}));
  EXPECT_TRUE(parseWords("").empty());
  const LocalizationConfig config =
      configOf("[LocalizationExperiment]\nobjects = ball cup\nmethods = odometry, running_fix\n");
  EXPECT_EQ(config.frames.object_categories, (std::set<std::string>{"ball", "cup"}));
  EXPECT_EQ(config.methods, (std::vector<std::string>{"odometry", "running_fix"}));
}
TEST(LocalizationConfig, KnowsWhetherAnybodyStatedTheNoiseOfOdometry)
{
  EXPECT_FALSE(configOf("[LocalizationExperiment]\nparticles_count = 100\n").odometry_noise_stated);
  EXPECT_TRUE(configOf("[MotionModel]\nstd_xy_per_m = 0.04\n").odometry_noise_stated);
  EXPECT_FALSE(configOf("[MotionModel]\nstd_xy_per_m = 0.05\nstd_phi_deg_per_m = 1\n").odometry_noise_stated)
      << "the defaults, as in the configuration that a run leaves";
  const auto built_in = [](const std::vector<std::string>& overrides)
  {
    return localizationConfig(
        Settings::parse(std::string(defaultConfiguration()), kDefaultConfigurationName, localizationKeys(), overrides),
        kMap);
  };
  EXPECT_FALSE(built_in({}).odometry_noise_stated);
  EXPECT_TRUE(built_in({"MotionModel.std_phi_deg_per_m=1"}).odometry_noise_stated);
}
}  // namespace mrpt_ext::test_localization_config
