#include "mrpt_ext/app/rawlog_output.h"

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
RawlogOutput rawlogOutput(const std::string& app, const std::filesystem::path& output)
{
  if (output.extension() != ".rawlog" || output.stem().empty())
    throw configurationError(app + ": output '" + output.string() + "', expected -o STEM.rawlog");
  const auto beside = [&](const std::string& ending)
  { return output.parent_path() / (output.stem().string() + ending); };
  return {output, beside("_map.csv"), beside("_ground_truth.tum")};
}
}  // namespace mrpt_ext
