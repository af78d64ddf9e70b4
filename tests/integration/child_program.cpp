#include "child_program.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

namespace mrpt_ext::testing
{
namespace
{
namespace fs = std::filesystem;
using namespace std::chrono_literals;

fs::path procFile(pid_t pid, const char* name) { return fs::path("/proc") / std::to_string(pid) / name; }
}  // namespace

ChildProgram::ChildProgram(const std::string& app, const Arguments& arguments, const fs::path& out, const fs::path& err,
                           bool ignores_interrupts)
{
  Arguments words = joined({fs::path(MRPT_EXT_BINARY_DIR) / "bin" / app}, arguments);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_ = fork();
  if (pid_ != 0) return;
  // No program outlives its test, which may itself run under nohup.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
  if (ignores_interrupts) std::signal(SIGINT, SIG_IGN);
  dup2(open(out.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDOUT_FILENO);
  dup2(open(err.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDERR_FILENO);
  execv(argv[0], argv.data());
  _exit(127);
}

ChildProgram::~ChildProgram()
{
  if (!ended_) kill(pid_, SIGKILL), waitpid(pid_, nullptr, 0);
}

void ChildProgram::waitUntilItHandles(int signal)
{
  for (bool handled = false; !handled && running(); std::this_thread::sleep_for(5ms))
  {
    std::ifstream lines(procFile(pid_, "status"));
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("SigCgt:")) handled = (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1) != 0;
  }
}

void ChildProgram::waitUntilItHasWorked(double seconds)
{
  const double until = processorTime() + seconds;
  while (running() && processorTime() < until) std::this_thread::sleep_for(20ms);
}

double ChildProgram::processorTime() const
{
  std::ifstream file(procFile(pid_, "stat"));
  std::string text;
  std::getline(file, text);
  // After the name in brackets: state and ten numbers, then user and system time in ticks.
  std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

bool ChildProgram::running()
{
  if (!ended_) ended_ = waitpid(pid_, &status_, WNOHANG) == pid_;
  return !ended_;
}

int ChildProgram::exitCode()
{
  if (!ended_) waitpid(pid_, &status_, 0);
  ended_ = true;
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}
}  // namespace mrpt_ext::testing
