#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace mrpt_ext
{
/// The variable that an option fills (a flag: bool), or a function whose answer is printed instead of a run.
using OptionTarget = std::variant<bool*, int*, double*, std::optional<int>*, std::optional<double>*,
                                  std::optional<std::uint64_t>*, std::string*, std::filesystem::path*,
                                  std::vector<std::string>*, std::vector<double>*, std::vector<std::filesystem::path>*,
                                  std::function<std::string()>, std::function<std::string(const std::string&)>>;

enum class AllowedNumbers
{
  any,
  not_negative,
  positive
};

/// One option or argument of a program; meant to be written with designated initializers.
struct OptionSpec
{
  std::string names;  ///< "-o,--output"; without a dash: an argument
  OptionTarget target;
  std::string help;
  bool required = false;
  AllowedNumbers numbers = AllowedNumbers::any;
  std::vector<std::string> choices = {};  ///< allowed words; empty: any
  int values = 0;                         ///< of a list: how many follow each use of the option; 0: any number
  std::string excludes = {}, needs = {};  ///< another option that was added before
  bool hidden = false;                    ///< not in the help
};

/// The command line of a program: all that the apps need of the command line library, whose header takes long to
/// compile.
class CommandLine
{
 public:
  CommandLine(const std::string& name, const std::string& description, const std::string& version);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  CommandLine& add(const OptionSpec& option);
  /// Text at the end of the help.
  void setFooter(const std::string& text);

  /// Fills the targets from `arguments` (without the program's name). Returns the text to print instead of a run, for
  /// --help, --version and functions. Throws InputError (configuration) for wrong usage.
  [[nodiscard]] std::optional<std::string> parse(std::vector<std::string> arguments);

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};
}  // namespace mrpt_ext
