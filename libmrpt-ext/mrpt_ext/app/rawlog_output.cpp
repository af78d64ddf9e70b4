#include "mrpt_ext/app/rawlog_output.h"

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
RawlogOutput rawlogOutput(const std::string& app, const std::filesystem::path& output,
                          const std::vector<std::filesystem::path>& inputs)
{
  if (output.extension() != ".rawlog" || output.stem().empty())
    throw configurationError(app + ": output '" + output.string() + "', expected -o STEM.rawlog");
  std::error_code not_there;
  for (const std::filesystem::path& input : inputs)
    if (std::filesystem::equivalent(input, output, not_there))
      throw configurationError(app + ": output '" + output.string() + "' is an input, expected another file");
  const auto beside = [&](const std::string& ending)
  { return output.parent_path() / (output.stem().string() + ending); };
  return {output, beside("_map.csv"), beside("_ground_truth.tum"), beside("_camera.json")};
}
}  // namespace mrpt_ext
