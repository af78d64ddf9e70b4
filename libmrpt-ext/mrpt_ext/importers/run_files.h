#pragma once

#include <filesystem>
#include <string>

namespace mrpt_ext
{
/// How the files of a run are named: <before><run><after>, each plain or with .gz behind.
struct RunFileName
{
  std::string before, after;
};

/// One of the runs in a folder.
struct RunFiles
{
  std::filesystem::path folder;
  std::string run;

  /// Path of the run's file of this name, with .gz where only that exists.
  [[nodiscard]] std::filesystem::path file(const RunFileName& name) const;
};

/// `input` is a folder, which must hold one run, or FOLDER/RUN; `name` is a file that every run has. Throws InputError:
/// data when there is no such run, configuration when the folder holds several (the message lists them).
[[nodiscard]] RunFiles chooseRun(const std::filesystem::path& input, const RunFileName& name);
}  // namespace mrpt_ext
