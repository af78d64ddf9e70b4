#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/app/command_line.h"
#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/app/printable_stream.h"
#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
/// Options that every app has.
struct CommonOptions
{
  std::filesystem::path output;
  bool quiet = false;
  bool verbose = false;
  std::vector<std::string> overrides;  ///< of --set, "Section.key=value"
  std::optional<std::uint64_t> seed;
};

/// The words of an app's help.
struct AppDescription
{
  std::string name, purpose;
  std::vector<std::string> examples;  ///< arguments behind the name
  std::string more = {};              ///< further lines before the examples
};

/// What all apps have in common around their job: the command line, one clear line for an error, the exit code.
/// Apps add their own options to `commandLine()` and pass their job to `run`; results go to out(), all else to err().
class AppShell
{
 public:
  AppShell(const AppDescription& app, std::ostream& out, std::ostream& err);

  /// Adds --list-keys and --explain, answered from `table` without the other arguments being needed.
  void answerQuestionsAbout(const KeyTable& table);

  [[nodiscard]] CommandLine& commandLine() { return command_line_; }
  [[nodiscard]] const CommonOptions& options() const { return options_; }
  /// Where results and everything else go, free of control characters.
  [[nodiscard]] std::ostream& out() { return out_; }
  [[nodiscard]] std::ostream& err() { return err_; }

  /// The configuration that the argument CONFIG names, with --set on top.
  [[nodiscard]] Settings loadSettings(const std::filesystem::path& config, const KeyTable& table) const;

  /// Parses `arguments` (without the program's name) and runs `job`, which returns an exit code. An InputError or any
  /// other exception becomes one line on err(): exit code 2 for a mistake in usage or configuration, else 1; so does a
  /// signal (interrupt.h), and output that cannot be written.
  int run(const std::vector<std::string>& arguments, const std::function<int()>& job);

 private:
  [[nodiscard]] int answer(const std::vector<std::string>& arguments, const std::function<int()>& job);

  std::string name_;
  PrintableStream out_, err_;
  CommandLine command_line_;
  CommonOptions options_;
};

/// An exception's text as one line; of MRPT's many-line messages only what is wrong, without location and backtrace.
[[nodiscard]] std::string oneLine(const std::string& what);
}  // namespace mrpt_ext
