#include "mrpt_ext/app/command_line.h"

#include <CLI/CLI.hpp>
#include <sstream>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
struct CommandLine::Parser
{
  CLI::App cli;
};

namespace
{
/// Thrown by an option that asks for a text instead of a run.
struct TextRequested
{
  std::string text;
};

/// CLI11's own check complains with all 309 digits of the largest double.
CLI::Validator numberCheck(AllowedNumbers allowed)
{
  const auto complaint = [allowed](std::string& value)
  {
    const bool zero_allowed = allowed == AllowedNumbers::not_negative;
    const auto number = parseNumber(value);
    if (number && (*number > 0 || (zero_allowed && *number == 0))) return std::string();
    return value + ": expected a number " + (zero_allowed ? "of at least 0" : "above 0");
  };
  return {complaint, ""};
}

/// Adds an option with the call that its target needs.
struct Adder
{
  CLI::App& cli;
  const OptionSpec& spec;

  CLI::Option* operator()(bool* target) const { return cli.add_flag(spec.names, *target, spec.help); }
  CLI::Option* operator()(const std::function<std::string()>& answer) const
  {
    return cli.add_flag_callback(
        spec.names, [answer] { throw TextRequested{answer()}; }, spec.help);
  }
  CLI::Option* operator()(const std::function<std::string(const std::string&)>& answer) const
  {
    return cli.add_option_function<std::string>(
        spec.names, [answer](const std::string& word) { throw TextRequested{answer(word)}; }, spec.help);
  }
  template <typename Value>
  CLI::Option* operator()(std::vector<Value>* target) const
  {
    CLI::Option* option = cli.add_option(spec.names, *target, spec.help);
    if (spec.values > 0) option->expected(spec.values);
    if (spec.values == 1) option->take_all();
    return option;
  }
  template <typename Value>
  CLI::Option* operator()(Value* target) const
  {
    return cli.add_option(spec.names, *target, spec.help);
  }
};
}  // namespace

CommandLine::CommandLine(const std::string& name, const std::string& description, const std::string& version)
    : parser_(std::make_unique<Parser>())
{
  parser_->cli.name(name);
  parser_->cli.description(description);
  parser_->cli.set_version_flag("--version", name + " " + version);
}

CommandLine::~CommandLine() = default;

CommandLine& CommandLine::add(const OptionSpec& spec)
{
  CLI::App& cli = parser_->cli;
  CLI::Option* option = std::visit(Adder{cli, spec}, spec.target);
  option->required(spec.required);
  if (spec.numbers != AllowedNumbers::any) option->check(numberCheck(spec.numbers));
  if (!spec.choices.empty()) option->check(CLI::IsMember(spec.choices))->type_name("NAME");
  if (!spec.excludes.empty()) option->excludes(cli.get_option(spec.excludes));
  if (!spec.needs.empty()) option->needs(cli.get_option(spec.needs));
  if (spec.hidden) option->group("");
  return *this;
}

void CommandLine::setFooter(const std::string& text) { parser_->cli.footer(text); }

std::optional<std::string> CommandLine::parse(std::vector<std::string> arguments)
{
  CLI::App& cli = parser_->cli;
  try
  {
    cli.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // the order CLI11 wants
    return std::nullopt;
  }
  catch (const TextRequested& request)
  {
    return request.text;
  }
  catch (const CLI::ParseError& error)
  {
    std::ostringstream out, err;
    if (cli.exit(error, out, err) == 0) return out.str();  // --help, --version
    const std::string what = error.what();
    throw configurationError(cli.get_name() + ": " + what.substr(0, what.find('\n')) + " (see --help)");
  }
}
}  // namespace mrpt_ext
