#pragma once

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "whole_runs.h"

namespace mrpt_ext::testing
{
/// One of our apps as a running program, with its output in files; killed when the test is done with it.
class ChildProgram
{
 public:
  ChildProgram(const std::string& app, const Arguments& arguments, const std::filesystem::path& out,
               const std::filesystem::path& err, bool ignores_interrupts = false);
  ~ChildProgram();
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  void interrupt(int signal = SIGINT) const { kill(pid_, signal); }
  /// Until the program has begun: before, its libraries are loaded.
  void waitUntilItHandles(int signal);
  /// Until it has used this much more processor time [s] than now, or has ended.
  void waitUntilItHasWorked(double seconds);
  [[nodiscard]] bool running();
  /// Waits for the end: the exit code; -1 when a signal ended it.
  int exitCode();

 private:
  [[nodiscard]] double processorTime() const;

  pid_t pid_ = -1;
  int status_ = 0;
  bool ended_ = false;
};
}  // namespace mrpt_ext::testing
