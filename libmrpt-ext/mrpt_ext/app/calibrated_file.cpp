#include "mrpt_ext/app/calibrated_file.h"

#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
std::string readFileToCalibrate(const std::filesystem::path& file, std::string_view initial)
{
  const std::string option = "--calibrate " + file.string();
  if (!std::filesystem::exists(file))
  {
    if (initial.empty()) throw dataError(option + ": no such file");
    if (!std::filesystem::is_directory(std::filesystem::absolute(file).parent_path()))
      throw dataError(option + ": no such folder");
    return std::string(initial);
  }
  try
  {
    static_cast<void>(Settings::load(file, localizationKeys()));
  }
  catch (const InputError& error)
  {
    throw configurationError(option + ": only a configuration (.ini) of landmark-localization is written into (" +
                             error.what() + ")");
  }
  return readTextFile(file);
}
}  // namespace mrpt_ext
