#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/settings/key_table.h"

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

/// What all apps have in common around their job: the command line, one clear line for an error, the exit code.
/// Apps add their own options to `cli()` and hand their job to `run`; results go to `out`, everything else to `err`.
class AppShell
{
 public:
  AppShell(const std::string& name, const std::string& description, std::ostream& out, std::ostream& err);
  AppShell(const AppShell&) = delete;
  AppShell& operator=(const AppShell&) = delete;

  /// Adds --list-keys and --explain, answered from `table` without the other arguments being needed.
  void answerQuestionsAbout(const KeyTable& table);

  [[nodiscard]] CLI::App& cli() { return cli_; }
  [[nodiscard]] const CommonOptions& options() const { return options_; }
  [[nodiscard]] std::ostream& out() { return out_; }
  [[nodiscard]] std::ostream& err() { return err_; }

  /// Parses `arguments` (without the program's name) and runs `job`, which returns an exit code. An InputError or any
  /// other exception becomes one line on `err`: exit code 2 for a mistake in usage or configuration, else 1.
  int run(std::vector<std::string> arguments, const std::function<int()>& job);

 private:
  int parse(std::vector<std::string> arguments);

  std::ostream& out_;
  std::ostream& err_;
  CLI::App cli_;
  CommonOptions options_;
};

/// Checks of an option's number. CLI11's own ones complain with all 309 digits of the largest double.
[[nodiscard]] CLI::Validator positiveNumber();
[[nodiscard]] CLI::Validator nonNegativeNumber();

/// The arguments of main() without the program's name.
[[nodiscard]] std::vector<std::string> argumentsOf(int argc, const char* const* argv);

/// An exception's text as one line; of MRPT's many-line messages only what is wrong, without place and backtrace.
[[nodiscard]] std::string oneLine(const std::string& what);
}  // namespace mrpt_ext
