#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/files/tum.h"
#include "scratch_folder.h"
#include "whole_runs.h"

// The real program as a child: what Ctrl-C leaves, and that nothing but the one line reaches stderr.
namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;
using testing::Arguments;
using namespace std::chrono_literals;

/// A running landmark-localization with its output in files.
class Child
{
 public:
  Child(const Arguments& arguments, const fs::path& out, const fs::path& err)
  {
    Arguments words = testing::joined({fs::path(MRPT_EXT_BINARY_DIR) / "bin" / "landmark-localization"}, arguments);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_ = fork();
    if (pid_ != 0) return;
    dup2(open(out.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDERR_FILENO);
    execv(argv[0], argv.data());
    _exit(127);
  }
  ~Child()
  {
    if (!ended_) kill(pid_, SIGKILL), waitpid(pid_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void interrupt() const { kill(pid_, SIGINT); }
  [[nodiscard]] bool running()
  {
    if (!ended_) ended_ = waitpid(pid_, &status_, WNOHANG) == pid_;
    return !ended_;
  }
  /// The exit code; -1 when a signal ended it.
  int exitCode()
  {
    if (!ended_) waitpid(pid_, &status_, 0);
    ended_ = true;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
  }

 private:
  pid_t pid_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

long lines(const fs::path& file)
{
  const std::string text = readTextFile(file);
  return std::count(text.begin(), text.end(), '\n');
}
}  // namespace

TEST(Program, InterruptedLeavesValidPartialOutput)
{
  const testing::ScratchFolder folder;
  const auto log = testing::simulated(folder.path(), "long", {"--set", "Simulation.duration_s=400"});
  const fs::path run = folder.path() / "run", out = folder.path() / "out.txt", err = folder.path() / "err.txt";
  // So many particles that the whole log would take minutes.
  Child child(testing::joined({testing::shipped("landmark-localization", "long")},
                              testing::joined(log.arguments(),
                                              {"-o", run, "--set", "LocalizationExperiment.particles_count=100000"})),
              out, err);
  while (child.running() && !fs::exists(run / "config_resolved.ini")) std::this_thread::sleep_for(50ms);
  std::this_thread::sleep_for(2s);
  child.interrupt();
  EXPECT_EQ(child.exitCode(), 1);

  EXPECT_EQ(lines(err), 1) << readTextFile(err);
  EXPECT_NE(readTextFile(err).find("interrupted"), std::string::npos);
  EXPECT_EQ(testing::summaryOf(run).at("schema"), 1);
  EXPECT_TRUE(readTextFile(run / "steps.csv").ends_with('\n'));
  const auto steps = testing::stepsOf(run);
  const Trajectory truth = readTum(log.truth);
  ASSERT_FALSE(steps.empty());
  EXPECT_LT(steps.back().time, truth.back().time - 1) << "it was not interrupted at all";
  EXPECT_EQ(TextTable(run / "hypotheses.csv", {}).size(), steps.size()) << "one mode per step";
  for (const auto& entry : fs::directory_iterator(run))
    EXPECT_EQ(entry.path().filename().string().find(".tmp-"), std::string::npos) << entry.path() << " is left over";
}

TEST(Program, SaysOneLineAboutDamage)
{
  const testing::ScratchFolder folder;
  const fs::path out = folder.path() / "out.txt", err = folder.path() / "err.txt";
  const std::string bytes = readTextFile(fs::path(MRPT_EXT_SOURCE_DIR) / "datasets" / "room_map.csv");
  Child child({testing::shipped("landmark-localization", "room"), folder.write("not_a.rawlog", bytes), "-o",
               folder.path() / "run"},
              out, err);
  EXPECT_EQ(child.exitCode(), 1);
  EXPECT_EQ(lines(err), 1) << readTextFile(err);
  EXPECT_EQ(readTextFile(out), "");
}
}  // namespace mrpt_ext
