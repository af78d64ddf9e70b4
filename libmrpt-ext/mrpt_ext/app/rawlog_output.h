#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mrpt_ext
{
/// The files that a converter writes: STEM.rawlog, STEM_map.csv, STEM_ground_truth.tum and STEM_camera.json.
struct RawlogOutput
{
  std::filesystem::path rawlog, map, truth, camera;
};

/// From the option -o/--output of an app. Throws InputError (configuration) for anything but STEM.rawlog, and for
/// one of `inputs`: a recording is not written over.
[[nodiscard]] RawlogOutput rawlogOutput(const std::string& app, const std::filesystem::path& output,
                                        const std::vector<std::filesystem::path>& inputs = {});
}  // namespace mrpt_ext
