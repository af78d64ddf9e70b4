#include "mrpt_ext/app/app_shell.h"

#include <cerrno>
#include <cstring>
#include <system_error>

#include "mrpt_ext/app/interrupt.h"
#include "mrpt_ext/app/version.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
std::string footerOf(const AppDescription& app)
{
  std::string text = app.more.empty() ? "" : app.more + '\n';
  text += "Examples:\n";
  for (const std::string& example : app.examples) text += "  " + app.name + ' ' + example + '\n';
  return text + "\nMore: apps/" + app.name + "/README.md";
}
}  // namespace

AppShell::AppShell(const AppDescription& app, std::ostream& out, std::ostream& err)
    : name_(app.name), out_(out), err_(err), command_line_(app.name, app.purpose, std::string(version()))
{
  command_line_.setFooter(footerOf(app));
  command_line_.add({.names = "-o,--output", .target = &options_.output, .help = "Folder or file for the results"})
      .add({.names = "-q,--quiet", .target = &options_.quiet, .help = "Print results and errors only"})
      .add({.names = "-v,--verbose", .target = &options_.verbose, .help = "Verbose output on stderr"})
      .add({.names = "--set",
            .target = &options_.overrides,
            .help = "Section.key=value, replaces a key of the .ini (repeatable)",
            .values = 1})
      .add({.names = "--seed",
            .target = &options_.seed,
            .help = "Random seed, a whole number of at least 0",
            .numbers = AllowedNumbers::not_negative});
}

void AppShell::answerQuestionsAbout(const KeyTable& table)
{
  command_line_
      .add({.names = "--list-keys",
            .target = std::function([table] { return table.list(); }),
            .help = "List the keys of the .ini and stop"})
      .add({.names = "--explain",
            .target = std::function([table](const std::string& key) { return table.explain(key); }),
            .help = "Explain a key of the .ini (Section.key, section or key alone) and stop"});
}

Settings AppShell::loadSettings(const std::filesystem::path& config, const KeyTable& table) const
{
  if (!std::filesystem::exists(config))
    throw configurationError("CONFIG " + config.string() + ": cannot be read, no such file; expected an .ini file");
  return Settings::load(config, table, options_.overrides);
}

int AppShell::run(const std::vector<std::string>& arguments, const std::function<int()>& job)
{
  const InterruptGuard interrupt;
  const int code = answer(arguments, job);
  if (out_.flush()) return code;
  const int error = out_.error() != 0 ? out_.error() : EIO;
  err_ << name_ << ": standard output cannot be written (" << std::strerror(error) << ")\n" << std::flush;
  return kExitFailed;
}

int AppShell::answer(const std::vector<std::string>& arguments, const std::function<int()>& job)
{
  try
  {
    const auto text = command_line_.parse(arguments);
    if (!text) return job();
    out_ << *text;
    return kExitDone;
  }
  catch (const InputError& error)
  {
    err_ << oneLine(error.what()) << std::endl;
    return error.kind() == InputError::Kind::configuration ? kExitUsage : kExitFailed;
  }
  catch (const std::bad_alloc&)
  {
    err_ << name_
         << ": not enough memory: expected fewer particles (particles_count, initial_particles_count), a "
            "shorter part of the log (--duration), or a smaller map\n";
    return kExitFailed;
  }
  catch (const std::system_error& error)
  {
    err_ << name_ << ": "
         << (error.code() == std::errc::resource_unavailable_try_again
                 ? "no further thread can be started: expected more memory (ulimit -v) or processes (ulimit -u)"
                 : oneLine(error.what()))
         << std::endl;
    return kExitFailed;
  }
  catch (const std::exception& error)
  {
    err_ << name_ << ": " << oneLine(error.what()) << std::endl;
    return kExitFailed;
  }
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
