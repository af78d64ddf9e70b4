#include "mrpt_ext/pipeline/vision_front_end.h"

#include <stdexcept>

#include "mrpt_ext/pipeline/conic_mirror_front_end.h"
#include "mrpt_ext/pipeline/stereo_goal_front_end.h"

namespace mrpt_ext
{
std::vector<std::string> imageRoles(const Settings& settings)
{
  if (settings.choice("Images", "sensor") == "stereo_goal") return {"left", "right"};
  return {"image"};
}

std::unique_ptr<VisionFrontEnd> makeFrontEnd(const Settings& settings, const nlohmann::json& camera)
{
  const std::string sensor = settings.choice("Images", "sensor");
  if (sensor == "conic_mirror") return std::make_unique<ConicMirrorFrontEnd>(settings, camera);
  if (sensor == "stereo_goal") return std::make_unique<StereoGoalFrontEnd>(settings, camera);
  throw std::logic_error("no front end for sensor " + sensor);
}
}  // namespace mrpt_ext
