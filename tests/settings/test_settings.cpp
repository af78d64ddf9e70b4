#include "mrpt_ext/settings/settings.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "error_message.h"
#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/settings/key_section.h"

namespace mrpt_ext::test_settings
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
  return testing::configurationErrorOf([&] { (void)parse(text, overrides); });
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

TEST(Settings, NumbersBeyondAnyMeaningAreRefused)
{
  EXPECT_EQ(errorOf("[Run]\norigin = 1e308 0 0\n"),
            "/data/my.ini:2: origin = 1e308 0 0: expected numbers separated by blanks, each finite m m deg, and none "
            "beyond 1e+09");
  EXPECT_EQ(parse("[Run]\nseed = 1000000000000\n").integer("Run", "seed"), 1'000'000'000'000) << "a seed may be any";
}

TEST(Settings, OverridesWinAndNameTheOptionWhenWrong)
{
  const Settings settings = parse("[Run]\nseed = 7\n", {"Run.seed=9", "Sensor_new.max_range_m=2"});
  EXPECT_EQ(settings.integer("Run", "seed"), 9);
  EXPECT_EQ(settings.number("Sensor_new", "max_range_m"), 2);
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
  EXPECT_STREQ(settings.errorAt("Run", "seed", "too large").what(), "--set Run.seed=9: too large");
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
  EXPECT_NE(table().list().find("  field_of_view_deg = 360 deg\n"), std::string::npos);
  EXPECT_NE(table().list().find("  max_range_m [m]                         Farthest landmark seen.\n"),
            std::string::npos)
      << table().list();
  const std::string text = table().explain("Run.mode");
  EXPECT_NE(text.find("How it starts."), std::string::npos);
  EXPECT_NE(text.find("    gaussian  1 in MRPT's files\n"), std::string::npos);
  EXPECT_NE(table().explain("Sensor_left.max_range_m").find("Farthest landmark seen."), std::string::npos);
  EXPECT_EQ(table().explain("Sensor_<label>.max_range_m"), table().explain("Sensor_left.max_range_m"));
  EXPECT_NE(table().explain("Sensor_left").find("field_of_view_deg"), std::string::npos);
  EXPECT_THROW((void)table().explain("Run.mod"), InputError);
  EXPECT_THROW((void)table().explain("Nothing"), InputError);
}

TEST(KeyTable, ListMarksWhatABeginnerNeedsAndFitsIntoAHundredColumns)
{
  const std::string words = "word word word word word word word word word word word word word word word word.";
  const KeyTable keys({{.section = "A", .name = "x", .help = words + " More.", .for_beginners = true},
                       {.section = "A", .name = std::string(60, 'y'), .help = words}});
  const std::string list = keys.list();
  EXPECT_NE(list.find("Keys marked * are the ones to set first."), std::string::npos);
  EXPECT_NE(list.find("\n* x                                       word word"), std::string::npos) << list;
  EXPECT_EQ(list.find("More."), std::string::npos) << "the first sentence only";
  std::istringstream lines(list);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  EXPECT_EQ(table().list().find("marked"), std::string::npos) << "no key is marked";
}

TEST(KeyTable, ExplainsAKeyWithoutItsSection)
{
  EXPECT_EQ(table().explain("mode"), table().explain("Run.mode"));
  const KeyTable two(
      {{.section = "A", .name = "x", .help = "First."}, {.section = "B", .name = "x", .help = "Second."}});
  EXPECT_EQ(two.explain("x"), two.explain("A.x") + two.explain("B.x"));
}

TEST(KeyTable, ExplainSuggestsSimilarNames)
{
  const auto messageOf = [](const std::string& name)
  { return testing::messageOf<InputError>([&] { (void)table().explain(name); }); };
  EXPECT_EQ(messageOf("sed"), "--explain sed: unknown key or section, did you mean 'seed'?");
  EXPECT_EQ(messageOf("range"), "--explain range: unknown key or section, did you mean 'max_range_m'?");
  EXPECT_EQ(messageOf("Rum"), "--explain Rum: unknown key or section, did you mean 'Run'?");
  EXPECT_EQ(messageOf("Ran.mode_"), "--explain Ran.mode_: unknown key or section, did you mean 'mode'?");
  EXPECT_EQ(messageOf("zzzzz"), "--explain zzzzz: unknown key or section, --list-keys shows the known ones");
}

TEST(Settings, AliasIsAnotherNameOfAKey)
{
  const KeyTable keys({{.section = "A", .name = "x", .type = KeyType::number, .default_value = "1", .alias = "old_x"}});
  const auto read = [&](const std::string& text, const std::vector<std::string>& overrides = {})
  { return Settings::parse(text, "a.ini", keys, overrides); };
  EXPECT_EQ(read("[A]\nold_x = 3\n").number("A", "x"), 3);
  EXPECT_TRUE(read("[A]\nold_x = 3\n").isSet("A", "x"));
  EXPECT_EQ(read("[A]\nx = 2\n", {"A.old_x=4"}).number("A", "x"), 4);
  EXPECT_EQ(read("[A]\nold_x = 3\n").resolvedText(), "[A]\nx = 3\n");
  EXPECT_EQ(testing::messageOf<InputError>([&] { (void)read("[A]\nx = 2\nold_x = 3\n"); }),
            "a.ini:3: old_x and x are two names of one key, expected one of them");
  EXPECT_NE(keys.explain("old_x").find("also read as old_x"), std::string::npos);
}

TEST(Settings, NamesAreSomeOfTheChoices)
{
  const KeyTable keys({{.section = "A", .name = "m", .type = KeyType::names, .choices = {{"odometry"}, {"filter"}}}});
  EXPECT_EQ(Settings::parse("[A]\nm = odometry, filter\n", "a.ini", keys).words("A", "m"),
            (std::vector<std::string>{"odometry", "filter"}));
  EXPECT_EQ(testing::messageOf<InputError>([&] { (void)Settings::parse("[A]\nm = filtr\n", "a.ini", keys); }),
            "a.ini:2: m = filtr: unknown name 'filtr', did you mean 'filter'?");
}

TEST(Settings, AMissingFileIsReportedWithItsKeyOrOption)
{
  Settings settings = parse("[Run]\n\nlog = none.rawlog\n");
  const auto message = [&]
  { return testing::messageOf<InputError>([&] { (void)settings.existingPath("Run", "log"); }); };
  EXPECT_EQ(message(), "/data/my.ini:3: log = none.rawlog: no such file /data/none.rawlog");
  settings.set("Run", "log", "/x/none.rawlog", "--log none.rawlog");
  EXPECT_EQ(message(), "--log none.rawlog: no such file /x/none.rawlog");
  settings.set("Run", "log", MRPT_EXT_SOURCE_DIR, "--log");
  EXPECT_EQ(settings.existingPath("Run", "log"), std::filesystem::path(MRPT_EXT_SOURCE_DIR).lexically_normal());
}

TEST(KeySection, WritesKeysWithTheirDefaults)
{
  const KeyTable keys = KeySection("S")
                            .number("a", "m", 0.1, ranges::kPositive, "A.")
                            .alias("old_a")
                            .degrees("b_deg", "deg", degToRad(0.3), ranges::kAny, "B.")
                            .forBeginners()
                            .number("c", "", kUnset, ranges::kAny, "C.")
                            .numbers("d", "m", {0, -1.5}, ranges::kAny, "D.")
                            .flag("e", true, "E.")
                            .choice("f", 2, NamedValues<int>{{1, {"one"}}, {2, {"two"}}}, "F.");
  ASSERT_EQ(keys.keys().size(), 6U);
  EXPECT_EQ(keys.find("S", "old_a")->default_value, "0.1");
  EXPECT_EQ(keys.find("S", "b_deg")->default_value, "0.3");
  EXPECT_TRUE(keys.find("S", "b_deg")->for_beginners);
  EXPECT_EQ(keys.find("S", "c")->default_value, "");
  EXPECT_EQ(keys.find("S", "d")->default_value, "0 -1.5");
  EXPECT_EQ(keys.find("S", "e")->default_value, "true");
  EXPECT_EQ(keys.find("S", "f")->default_value, "two");
  EXPECT_EQ(Settings::parse("", "a.ini", keys).radians("S", "b_deg"), degToRad(0.3)) << "to the last bit";
}

TEST(KeyTable, PatternsNeedSomethingInThePlaceholder)
{
  EXPECT_TRUE(fitsPattern("Sensor_a", "Sensor_<label>"));
  EXPECT_FALSE(fitsPattern("Sensor_", "Sensor_<label>"));
  EXPECT_TRUE(fitsPattern("MetricMap_x_00_opts", "MetricMap_<name>_opts"));
  EXPECT_FALSE(fitsPattern("MetricMap__opts", "MetricMap_<name>_opts"));
  EXPECT_FALSE(fitsPattern("Runs", "Run"));
}

TEST(Settings, ASectionInheritsFromTheOneItContinues)
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
}  // namespace mrpt_ext::test_settings
