#pragma once

#include <filesystem>
#include <string>

namespace mrpt_ext
{
/// The files that a converter writes: STEM.rawlog, STEM_map.csv and STEM_ground_truth.tum.
struct RawlogOutput
{
  std::filesystem::path rawlog, map, truth;
};

/// From the option -o/--output of an app. Throws InputError (configuration) for anything but STEM.rawlog.
[[nodiscard]] RawlogOutput rawlogOutput(const std::string& app, const std::filesystem::path& output);
}  // namespace mrpt_ext
