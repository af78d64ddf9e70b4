#include "mrpt_ext/app/command_line.h"

#include <gtest/gtest.h>

#include "error_message.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::test_command_line
{
namespace
{
struct Values
{
  std::string config;
  std::vector<std::filesystem::path> inputs;
  bool quiet = false;
  int repeat = 0;
  std::optional<double> limit;
  std::vector<std::string> overrides;
  std::vector<double> origin;
  std::string identity;
};

/// The text that is printed instead of a run; empty for a run.
std::string parse(Values& values, const std::vector<std::string>& arguments)
{
  CommandLine line("my-app", "Does things", "1.2");
  line.add({.names = "CONFIG", .target = &values.config, .help = "Configuration", .required = true})
      .add({.names = "INPUT", .target = &values.inputs, .help = "Files"})
      .add({.names = "-q,--quiet", .target = &values.quiet, .help = "Quiet"})
      .add({.names = "--repeat", .target = &values.repeat, .help = "Trials", .numbers = AllowedNumbers::positive})
      .add({.names = "--limit", .target = &values.limit, .help = "Limit", .excludes = "--repeat"})
      .add({.names = "--set", .target = &values.overrides, .help = "Changes", .values = 1})
      .add({.names = "--origin", .target = &values.origin, .help = "x y phi", .values = 3, .needs = "--quiet"})
      .add({.names = "--identity", .target = &values.identity, .help = "Identity", .choices = {"known", "none"}})
      .add({.names = "--old-name", .target = &values.quiet, .help = "Quiet", .hidden = true})
      .add({.names = "--list", .target = std::function([] { return std::string("a list"); }), .help = "List"})
      .add({.names = "--explain",
            .target = std::function([](const std::string& word) { return "about " + word; }),
            .help = "Explain"});
  line.setFooter("The end");
  return line.parse(arguments).value_or("");
}

std::string errorOf(const std::vector<std::string>& arguments)
{
  Values values;
  return testing::messageOf<InputError>([&] { (void)parse(values, arguments); });
}
}  // namespace

TEST(CommandLine, FillsTargetsOfEveryType)
{
  Values values;
  EXPECT_EQ(parse(values, {"a.ini", "b", "c", "-q", "--repeat", "3", "--set", "A.x=1", "--set", "A.y=2", "--origin",
                           "1", "-2", "90", "--identity", "none"}),
            "");
  EXPECT_EQ(values.config, "a.ini");
  EXPECT_EQ(values.inputs, (std::vector<std::filesystem::path>{"b", "c"}));
  EXPECT_TRUE(values.quiet);
  EXPECT_EQ(values.repeat, 3);
  EXPECT_FALSE(values.limit);
  EXPECT_EQ(values.overrides, (std::vector<std::string>{"A.x=1", "A.y=2"}));
  EXPECT_EQ(values.origin, (std::vector<double>{1, -2, 90}));
  EXPECT_EQ(values.identity, "none");
  EXPECT_EQ(parse(values, {"a.ini", "--limit", "0.5"}), "");
  EXPECT_EQ(values.limit, 0.5);
}

TEST(CommandLine, AnswersQuestionsWithoutTheOtherArguments)
{
  Values values;
  EXPECT_EQ(parse(values, {"--list"}), "a list");
  EXPECT_EQ(parse(values, {"--explain", "x"}), "about x");
  EXPECT_EQ(parse(values, {"--version"}), "my-app 1.2\n");
  const std::string help = parse(values, {"--help"});
  EXPECT_NE(help.find("--quiet"), std::string::npos);
  EXPECT_EQ(help.find("--old-name"), std::string::npos) << "hidden";
  EXPECT_TRUE(help.ends_with("The end\n")) << help;
}

TEST(CommandLine, HiddenOptionsWork)
{
  Values values;
  EXPECT_EQ(parse(values, {"a.ini", "--old-name"}), "");
  EXPECT_TRUE(values.quiet);
}

TEST(CommandLine, WrongUsageIsOneLineWithTheNameOfTheProgram)
{
  EXPECT_EQ(errorOf({}), "my-app: CONFIG is required (see --help)");
  EXPECT_EQ(errorOf({"a.ini", "--repeat", "0"}), "my-app: --repeat: 0: expected a number above 0 (see --help)");
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"a.ini", "--nonsense"},
                                                    {"a.ini", "--repeat", "x"},
                                                    {"a.ini", "--repeat", "2", "--limit", "1"},
                                                    {"a.ini", "--origin", "1", "2", "3"},
                                                    {"a.ini", "-q", "--origin", "1", "2"},
                                                    {"a.ini", "--identity", "all"}})
  {
    const std::string error = errorOf(arguments);
    EXPECT_TRUE(error.starts_with("my-app: ")) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}
}  // namespace mrpt_ext::test_command_line
