#include "mrpt_ext/app/app_shell.h"

#include <ostream>

#include "mrpt_ext/app/version.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
/// Thrown by an option that asks for a text instead of a run.
struct TextRequested
{
  std::string text;
};

CLI::Validator numberCheck(const std::string& expected, bool zero_allowed)
{
  const auto complaint = [expected, zero_allowed](std::string& value)
  {
    const auto number = parseNumber(value);
    const bool good = number && (*number > 0 || (zero_allowed && *number == 0));
    return good ? std::string() : value + ": expected " + expected;
  };
  return {complaint, ""};
}
}  // namespace

CLI::Validator positiveNumber() { return numberCheck("a number above 0", false); }
CLI::Validator nonNegativeNumber() { return numberCheck("a number of at least 0", true); }

AppShell::AppShell(const std::string& name, const std::string& description, std::ostream& out, std::ostream& err)
    : out_(out), err_(err), cli_(description, name)
{
  cli_.add_option("-o,--output", options_.output, "Where the results go");
  cli_.add_flag("-q,--quiet", options_.quiet, "Only results and errors");
  cli_.add_flag("-v,--verbose", options_.verbose, "Tell more on stderr");
  cli_.add_option("--set", options_.overrides, "Section.key=value, wins over the .ini (repeatable)")
      ->expected(1)
      ->take_all();
  cli_.add_option("--seed", options_.seed, "Random seed, a whole number of at least 0")->check(nonNegativeNumber());
  cli_.set_version_flag("--version", name + " " + std::string(version()));
}

void AppShell::answerQuestionsAbout(const KeyTable& table)
{
  cli_.add_flag_callback(
      "--list-keys", [table] { throw TextRequested{table.list()}; }, "List the keys of the .ini and stop");
  cli_.add_option_function<std::string>(
      "--explain", [table](const std::string& key) { throw TextRequested{table.explain(key)}; },
      "Explain Section.key of the .ini and stop");
}

int AppShell::parse(std::vector<std::string> arguments)
{
  try
  {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // the order CLI11 wants
    cli_.parse(std::move(reversed));
    return kExitDone;
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) throw;
    throw configurationError(cli_.get_name() + ": " + oneLine(error.what()) + " (see --help)");
  }
}

int AppShell::run(std::vector<std::string> arguments, const std::function<int()>& job)
{
  try
  {
    parse(std::move(arguments));
    return job();
  }
  catch (const TextRequested& request)
  {
    out_ << request.text << std::flush;
    return kExitDone;
  }
  catch (const CLI::Success& request)  // --help, --version
  {
    return cli_.exit(request, out_, err_);
  }
  catch (const InputError& error)
  {
    err_ << oneLine(error.what()) << std::endl;
    return error.kind() == InputError::Kind::configuration ? kExitUsage : kExitFailed;
  }
  catch (const std::exception& error)
  {
    err_ << cli_.get_name() << ": " << oneLine(error.what()) << std::endl;
    return kExitFailed;
  }
}

std::vector<std::string> argumentsOf(int argc, const char* const* argv)
{
  return argc > 1 ? std::vector<std::string>(argv + 1, argv + argc) : std::vector<std::string>{};
}

std::string oneLine(const std::string& what)
{
  constexpr const char* kMrptMessage = "Message:";
  const std::size_t mark = what.find(kMrptMessage);
  std::size_t begin = mark == std::string::npos ? 0 : mark + std::string(kMrptMessage).size();
  begin = what.find_first_not_of(" \t\r\n=", begin);
  if (begin == std::string::npos) return "failed without saying why";
  const std::size_t end = what.find_first_of("\r\n", begin);
  return what.substr(begin, end == std::string::npos ? end : end - begin);
}
}  // namespace mrpt_ext
