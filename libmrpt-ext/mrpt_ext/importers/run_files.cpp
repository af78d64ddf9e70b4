#include "mrpt_ext/importers/run_files.h"

#include <optional>
#include <set>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

/// The <run> in the name of a file; nothing for other files.
std::optional<std::string> runInName(std::string file, const RunFileName& name)
{
  if (file.ends_with(".gz")) file.resize(file.size() - 3);
  const bool fits = file.size() > name.before.size() + name.after.size() && file.starts_with(name.before) &&
                    file.ends_with(name.after);
  if (!fits) return std::nullopt;
  return file.substr(name.before.size(), file.size() - name.before.size() - name.after.size());
}

std::set<std::string> runsIn(const fs::path& folder, const RunFileName& name)
{
  std::set<std::string> runs;
  for (const auto& entry : fs::directory_iterator(folder))
    if (const auto run = runInName(entry.path().filename().string(), name)) runs.insert(*run);
  return runs;
}
}  // namespace

fs::path RunFiles::file(const RunFileName& name) const
{
  const fs::path path = folder / (name.before + run + name.after);
  return findPlainOrGzipped(path).value_or(path);
}

RunFiles chooseRun(const fs::path& input, const RunFileName& name)
{
  const std::string expected = name.before + "<run>" + name.after;
  if (!fs::is_directory(input))
  {
    const fs::path folder = input.has_parent_path() ? input.parent_path() : fs::path(".");
    const std::string file = input.filename().string();
    const RunFiles files{folder, runInName(file, name).value_or(file)};
    if (fs::exists(files.file(name))) return files;
    throw dataError(input.string() + ": no such folder or run, expected a folder with " + expected + ", or FOLDER/RUN");
  }
  const std::set<std::string> runs = runsIn(input, name);
  if (runs.empty()) throw dataError(input.string() + ": no file " + expected + " in this folder");
  if (runs.size() == 1) return {input, *runs.begin()};
  std::string list;
  for (const std::string& run : runs) list += ' ' + (input / run).string();
  throw configurationError(input.string() + ": holds several runs, expected one of" + list);
}
}  // namespace mrpt_ext
