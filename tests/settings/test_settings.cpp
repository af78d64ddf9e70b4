#include "mrpt_ext/settings/settings.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "mrpt_ext/geometry/angle.h"
#include "scratch_folder.h"

namespace mrpt_ext
{
namespace
{
KeyTable table()
{
  return std::vector<KeySpec>{
      {.section = "Run", .name = "log", .type = KeyType::path, .help = "The log."},
      {.section = "Run", .name = "seed", .type = KeyType::integer, .default_value = "1", .range = {0, 1e18}},
      {.section = "Run",
       .name = "mode",
       .type = KeyType::choice,
       .default_value = "uniform",
       .choices = {{"uniform", 0}, {"gaussian", 1}, {"analytic", {}}},
       .help = "How it starts."},
      {.section = "Run", .name = "quick", .type = KeyType::flag, .default_value = "false"},
      {.section = "Run", .name = "origin", .type = KeyType::numbers, .unit = "m m deg"},
      {.section = "Run", .name = "note"},
      {.section = "Sensor_<label>",
       .name = "max_range_m",
       .type = KeyType::number,
       .unit = "m",
       .range = {0.1, 100},
       .help = "Farthest landmark seen."},
      {.section = "Sensor_<label>",
       .name = "field_of_view_deg",
       .type = KeyType::number,
       .unit = "deg",
       .default_value = "360",
       .range = {0, 360}},
      {.section = "MetricMap_<name>_opts", .name = "*"}};
}

Settings parse(const std::string& text, const std::vector<std::string>& overrides = {})
{
  return Settings::parse(text, "/data/my.ini", table(), overrides);
}

std::string errorOf(const std::string& text, const std::vector<std::string>& overrides = {})
{
  try
  {
    (void)parse(text, overrides);
  }
  catch (const InputError& error)
  {
    EXPECT_EQ(error.kind(), InputError::Kind::configuration);
    return error.what();
  }
  return "no error";
}
}  // namespace

TEST(Settings, DefaultsComeFromTheTable)
{
  const Settings settings = parse("");
  EXPECT_EQ(settings.integer("Run", "seed"), 1);
  EXPECT_EQ(settings.choice("Run", "mode"), "uniform");
  EXPECT_FALSE(settings.flag("Run", "quick"));
  EXPECT_FALSE(settings.isSet("Run", "seed"));
  EXPECT_TRUE(settings.hasValue("Run", "seed"));
  EXPECT_FALSE(settings.hasValue("Run", "note"));
  EXPECT_FALSE(settings.hasSection("Run"));
}

TEST(Settings, ReadsEveryType)
{
  const Settings settings = parse(
      "[Run]\nlog = ../a/b.rawlog\nseed = 7\nmode = 1\nquick = yes\norigin = 1, -2.5 90\nnote = two words\n"
      "[Sensor_left]\nmax_range_m = 5\nfield_of_view_deg = 90\n[Sensor_right]\n");
  EXPECT_EQ(settings.path("Run", "log"), "/a/b.rawlog");
  EXPECT_EQ(settings.integer("Run", "seed"), 7);
  EXPECT_EQ(settings.choice("Run", "mode"), "gaussian");
  EXPECT_TRUE(settings.flag("Run", "quick"));
  EXPECT_EQ(settings.numbers("Run", "origin"), (std::vector<double>{1, -2.5, 90}));
  EXPECT_EQ(settings.text("Run", "note"), "two words");
  EXPECT_EQ(settings.sectionsMatching("Sensor_"), (std::vector<std::string>{"Sensor_left", "Sensor_right"}));
  EXPECT_DOUBLE_EQ(settings.radians("Sensor_left", "field_of_view_deg"), kPi / 2);
  EXPECT_EQ(settings.optionalNumber("Sensor_left", "max_range_m"), 5.0);
  EXPECT_FALSE(settings.optionalNumber("Sensor_right", "max_range_m"));
}

TEST(Settings, NamesUnknownThingsAndWhatWasMeant)
{
  EXPECT_EQ(errorOf("[Run]\nsed = 1\n"), "/data/my.ini:2: unknown key 'sed' in [Run], did you mean 'seed'?");
  EXPECT_EQ(errorOf("\n[Rum]\n"), "/data/my.ini:2: unknown section [Rum], did you mean [Run]?");
  EXPECT_EQ(errorOf("[Sensor_a]\nseed = 1\n"), "/data/my.ini:2: unknown key 'seed' in [Sensor_a], it belongs in [Run]");
  EXPECT_EQ(errorOf("[Sensor_a]\nmax_range = 1\n"),
            "/data/my.ini:2: unknown key 'max_range' in [Sensor_a], did you mean 'max_range_m'?");
  EXPECT_EQ(errorOf("[Sensor_]\n"), "/data/my.ini:1: unknown section [Sensor_], did you mean [Sensor_<label>]?");
  EXPECT_EQ(errorOf("[Senor_left_front]\n"),
            "/data/my.ini:1: unknown section [Senor_left_front], did you mean [Sensor_<label>]?");
}

TEST(Settings, ChecksValues)
{
  EXPECT_EQ(errorOf("[Sensor_a]\n\nmax_range_m = far\n"),
            "/data/my.ini:3: max_range_m = far: expected a number in [0.1, 100] m");
  EXPECT_EQ(errorOf("[Sensor_a]\nmax_range_m = 1e3\n"),
            "/data/my.ini:2: max_range_m = 1e3: expected a number in [0.1, 100] m");
  EXPECT_EQ(errorOf("[Sensor_a]\nmax_range_m = nan\n"),
            "/data/my.ini:2: max_range_m = nan: expected a number in [0.1, 100] m");
  EXPECT_EQ(errorOf("[Run]\nseed = 1.5\n"), "/data/my.ini:2: seed = 1.5: expected a whole number in [0, 1e+18]");
  EXPECT_EQ(errorOf("[Run]\nquick = maybe\n"), "/data/my.ini:2: quick = maybe: expected true or false");
  EXPECT_EQ(errorOf("[Run]\nmode = 2\n"), "/data/my.ini:2: mode = 2: expected uniform | gaussian | analytic");
  EXPECT_EQ(errorOf("[Run]\norigin = 1 x\n"),
            "/data/my.ini:2: origin = 1 x: expected numbers separated by blanks, each finite m m deg");
}

TEST(Settings, OverridesWinAndNameTheOptionWhenWrong)
{
  const Settings settings = parse("[Run]\nseed = 7\n", {"Run.seed=9", "Sensor_new.max_range_m=2"});
  EXPECT_EQ(settings.integer("Run", "seed"), 9);
  EXPECT_EQ(settings.number("Sensor_new", "max_range_m"), 2);
  EXPECT_EQ(settings.raw().find("Run", "seed")->value, "9");
  EXPECT_EQ(errorOf("", {"Run.seed=x"}), "--set Run.seed=x: expected a whole number in [0, 1e+18]");
  EXPECT_EQ(errorOf("", {"Run.sed=1"}), "--set Run.sed=1: unknown key 'sed' in [Run], did you mean 'seed'?");
  EXPECT_EQ(errorOf("", {"seed=1"}), "--set seed=1: expected Section.key=value");
  EXPECT_EQ(errorOf("", {"Run.seed"}), "--set Run.seed: expected Section.key=value");
}

TEST(Settings, PathsOfOverridesCountFromTheCurrentFolder)
{
  const Settings settings = parse("[Run]\nlog = a.rawlog\n", {"Run.log=b.rawlog"});
  EXPECT_EQ(settings.path("Run", "log"), std::filesystem::current_path() / "b.rawlog");
}

TEST(Settings, MissingValueIsAUsersMistakeAndMissingSpecOurs)
{
  const Settings settings = parse("");
  EXPECT_THROW((void)settings.path("Run", "log"), InputError);
  EXPECT_THROW((void)settings.number("Run", "nothing"), std::logic_error);
}

TEST(Settings, ErrorAtNamesTheWrittenPlace)
{
  const Settings settings = parse("[Run]\norigin = 1 2\n", {"Run.seed=9"});
  EXPECT_STREQ(settings.errorAt("Run", "origin", "expected three numbers").what(),
               "/data/my.ini:2: origin = 1 2: expected three numbers");
  EXPECT_STREQ(settings.errorAt("Run", "seed", "too large").what(), "Run.seed=9: too large");
  EXPECT_STREQ(settings.errorAt("Run", "quick", "no").what(), "/data/my.ini: [Run] quick: no");
}

TEST(Settings, ResolvedTextLoadsAgainToTheSame)
{
  const Settings settings = parse(
      "[Sensor_b]\nmax_range_m = 2\n[Run]\nlog = a.rawlog\nmode = 1\n[MetricMap_x_opts]\nanything = 1 2\n"
      "[Sensor_a]\n");
  const std::string resolved = settings.resolvedText();
  EXPECT_EQ(resolved,
            "[Run]\nlog = /data/a.rawlog\nseed = 1\nmode = gaussian\nquick = false\n; origin is not set\n"
            "; note is not set\n[Sensor_b]\nmax_range_m = 2\nfield_of_view_deg = 360\n[Sensor_a]\n"
            "; max_range_m is not set\nfield_of_view_deg = 360\n[MetricMap_x_opts]\nanything = 1 2\n");
  EXPECT_EQ(Settings::parse(resolved, "/elsewhere/config_resolved.ini", table()).resolvedText(), resolved);
}

TEST(Settings, ValuesThatAnIniFileCannotHoldAreRefused)
{
  for (const std::string folder : {"my #1 runs", "a ;b"})
  {
    const std::string text = testing::messageOf<InputError>(
        [&] { (void)Settings::parse("[Run]\nlog = a.rawlog\n", "/" + folder + "/run.ini", table()).resolvedText(); });
    EXPECT_NE(text.find("'/" + folder + "/a.rawlog' cannot be written into config_resolved.ini"), std::string::npos);
  }
  EXPECT_NO_THROW((void)Settings::parse("[Run]\nlog = a.rawlog\n", "/a#1;b//c/run.ini", table()).resolvedText());
  // A path is written with single slashes, which begin no comment.
  EXPECT_NO_THROW((void)Settings::parse("[Run]\nlog = a.rawlog\n", "/x //y/run.ini", table()).resolvedText());
}

TEST(KeyTable, ListsAndExplainsItself)
{
  EXPECT_NE(table().list().find("  field_of_view_deg = 360  [deg]  (a number in [0, 360] deg)\n"), std::string::npos);
  const std::string text = table().explain("Run.mode");
  EXPECT_NE(text.find("How it starts."), std::string::npos);
  EXPECT_NE(text.find("gaussian is 1 in MRPT's files"), std::string::npos);
  EXPECT_NE(table().explain("Sensor_left.max_range_m").find("Farthest landmark seen."), std::string::npos);
  EXPECT_EQ(table().explain("Sensor_<label>.max_range_m"), table().explain("Sensor_left.max_range_m"));
  EXPECT_NE(table().explain("Sensor_left").find("field_of_view_deg"), std::string::npos);
  EXPECT_THROW((void)table().explain("Run.mod"), InputError);
  EXPECT_THROW((void)table().explain("Nothing"), InputError);
}

TEST(KeyTable, PatternsNeedSomethingInThePlaceholder)
{
  EXPECT_TRUE(fitsPattern("Sensor_a", "Sensor_<label>"));
  EXPECT_FALSE(fitsPattern("Sensor_", "Sensor_<label>"));
  EXPECT_TRUE(fitsPattern("MetricMap_x_00_opts", "MetricMap_<name>_opts"));
  EXPECT_FALSE(fitsPattern("MetricMap__opts", "MetricMap_<name>_opts"));
  EXPECT_FALSE(fitsPattern("Runs", "Run"));
}
TEST(Settings, ASectionTakesWhatItDoesNotSayFromTheOneItContinues)
{
  const std::string text =
      "[Sensor_eye]\nmax_range_m = 5\nfield_of_view_deg = 90\n[Sensor_eye.left]\nmax_range_m = 7\n";
  const Settings settings = parse(text);
  EXPECT_EQ(settings.number("Sensor_eye.left", "max_range_m"), 7);
  EXPECT_EQ(settings.number("Sensor_eye.left", "field_of_view_deg"), 90);
  EXPECT_FALSE(settings.isSet("Sensor_eye.left", "field_of_view_deg"));
  EXPECT_EQ(settings.generalSection("Sensor_eye.left"), "Sensor_eye");
  EXPECT_FALSE(settings.generalSection("Sensor_eye"));
  EXPECT_EQ(parse(text, {"Sensor_eye.max_range_m=6"}).number("Sensor_eye.left", "max_range_m"), 7);
  const Settings again = parse(settings.resolvedText());
  EXPECT_EQ(again.number("Sensor_eye.left", "field_of_view_deg"), 90);
  EXPECT_FALSE(again.isSet("Sensor_eye.left", "field_of_view_deg"));
}
}  // namespace mrpt_ext
