#include "mrpt_ext/app/app_shell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "mrpt_ext/app/version.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::test_app_shell
{
namespace
{
struct Outcome
{
  int exit_code = -1;
  std::string out, err;
  CommonOptions options;
  bool ran = false;
};

Outcome runApp(
    const std::vector<std::string>& arguments, const std::function<int()>& job = [] { return 0; })
{
  std::ostringstream out, err;
  AppShell shell({.name = "my-app", .purpose = "Does things", .examples = {"a.ini", "a.ini -q"}}, out, err);
  std::string config;
  shell.commandLine().add({.names = "CONFIG", .target = &config, .help = "Configuration", .required = true});
  shell.answerQuestionsAbout(std::vector<KeySpec>{{.section = "Run", .name = "seed", .help = "Random seed."}});
  Outcome outcome;
  outcome.exit_code = shell.run(arguments,
                                [&]
                                {
                                  outcome.ran = true;
                                  return job();
                                });
  outcome.out = out.str();
  outcome.err = err.str();
  outcome.options = shell.options();
  return outcome;
}

long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }
}  // namespace

TEST(AppShell, HandsTheOptionsToTheJob)
{
  const Outcome o =
      runApp({"a.ini", "-o", "out", "-q", "--set", "A.x=1", "--set", "A.y=2", "--seed", "18446744073709551615"});
  EXPECT_TRUE(o.ran);
  EXPECT_EQ(o.exit_code, kExitDone);
  EXPECT_EQ(o.options.output, "out");
  EXPECT_TRUE(o.options.quiet);
  EXPECT_EQ(o.options.overrides, (std::vector<std::string>{"A.x=1", "A.y=2"}));
  EXPECT_EQ(o.options.seed, 18446744073709551615ULL);
}

TEST(AppShell, OverrideDoesNotSwallowThePositional) { EXPECT_TRUE(runApp({"--set", "A.x=1", "a.ini"}).ran); }

TEST(AppShell, ReturnsTheExitCodeOfTheJob)
{
  EXPECT_EQ(runApp({"a.ini"}, [] { return int{kExitLost}; }).exit_code, kExitLost);
}

TEST(AppShell, AnswersQuestionsWithoutRunning)
{
  for (const auto& [question, answer] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--help"}, "CONFIG"},
           {{"--version"}, "my-app " + std::string(version())},
           {{"--list-keys"}, "seed"},
           {{"--explain", "Run.seed"}, "Random seed."}})
  {
    const Outcome o = runApp(question);
    EXPECT_FALSE(o.ran) << question.front();
    EXPECT_EQ(o.exit_code, kExitDone) << question.front();
    EXPECT_NE(o.out.find(answer), std::string::npos) << question.front();
    EXPECT_EQ(o.err, "") << question.front();
  }
}

TEST(AppShell, HelpEndsWithExamplesAndWhereToReadOn)
{
  EXPECT_TRUE(
      runApp({"--help"}).out.ends_with("Examples:\n  my-app a.ini\n  my-app a.ini -q\n\nMore: apps/my-app/README.md\n"))
      << runApp({"--help"}).out;
}

TEST(AppShell, AMissingConfigurationIsToldWithItsArgument)
{
  std::ostringstream out, err;
  AppShell shell({.name = "my-app", .purpose = "Does things"}, out, err);
  const auto load = [&] { return (void)shell.loadSettings("/nowhere/none.ini", {}), 0; };
  EXPECT_EQ(shell.run({}, load), kExitUsage);
  EXPECT_EQ(err.str(), "CONFIG /nowhere/none.ini: cannot be read, no such file; expected an .ini file\n");
}

TEST(AppShell, WrongUsageIsOneLineAndTwo)
{
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"a.ini", "--nonsense"},
                                                    {"a.ini", "b.ini"},
                                                    {"a.ini", "--seed", "-1"},
                                                    {"a.ini", "--seed", "x"},
                                                    {"a.ini", "--set"},
                                                    {"--explain", "Run.sed"}})
  {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    const Outcome o = runApp(arguments);
    EXPECT_FALSE(o.ran);
    EXPECT_EQ(o.exit_code, kExitUsage);
    EXPECT_EQ(lines(o.err), 1) << o.err;
    EXPECT_LT(o.err.size(), 120U) << o.err;
    EXPECT_EQ(o.out, "");
  }
}

TEST(AppShell, ErrorsAreOneLineWithTheirExitCode)
{
  const Outcome configuration = runApp({"a.ini"}, []() -> int { throw configurationError("a.ini:1: wrong"); });
  EXPECT_EQ(configuration.exit_code, kExitUsage);
  EXPECT_EQ(configuration.err, "a.ini:1: wrong\n");
  const Outcome data = runApp({"a.ini"}, []() -> int { throw dataError("a.rawlog: record 3: damaged"); });
  EXPECT_EQ(data.exit_code, kExitFailed);
  EXPECT_EQ(data.err, "a.rawlog: record 3: damaged\n");
  const Outcome other = runApp({"a.ini"}, []() -> int { throw std::runtime_error("disk full\nbacktrace\n"); });
  EXPECT_EQ(other.exit_code, kExitFailed);
  EXPECT_EQ(other.err, "my-app: disk full\n");
  const auto no_thread = std::make_error_code(std::errc::resource_unavailable_try_again);
  const Outcome thread = runApp({"a.ini"}, [&]() -> int { throw std::system_error(no_thread); });
  EXPECT_EQ(thread.exit_code, kExitFailed);
  EXPECT_EQ(thread.err,
            "my-app: no further thread can be started: expected more memory (ulimit -v) or processes (ulimit -u)\n");
}

TEST(OneLine, TakesTheMessageOutOfMrptsReport)
{
  EXPECT_EQ(
      oneLine(
          "\n\n =============== MRPT EXCEPTION =============\nwhat, line 7:\nMessage:  file is gone\nLocation: x\n"),
      "file is gone");
  EXPECT_EQ(oneLine("plain"), "plain");
  EXPECT_EQ(oneLine("\n"), "failed without saying why");
}
}  // namespace mrpt_ext::test_app_shell
