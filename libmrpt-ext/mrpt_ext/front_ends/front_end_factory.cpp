#include "mrpt_ext/front_ends/front_end_factory.h"

#include <stdexcept>

#include "mrpt_ext/front_ends/conic_mirror_front_end.h"
#include "mrpt_ext/front_ends/movis_front_end.h"
#include "mrpt_ext/front_ends/stereo_goal_front_end.h"
#include "mrpt_ext/front_ends/tags_front_end.h"
#include "mrpt_ext/solvers/movis_frame.h"

namespace mrpt_ext
{
std::vector<std::string> imageRoles(const Settings& settings)
{
  if (settings.choice("Images", "sensor") == "movis") return {"M1", "M2", "M3"};
  if (settings.choice("Images", "sensor") == "stereo_goal") return {"left", "right"};
  return {"image"};
}

double headingOffset(const Settings& settings)
{
  // Paper 001 counts the heading from the robot's axis to the right.
  return settings.choice("Images", "sensor") == "movis" ? headingFromSlope(0) : 0;
}

std::unique_ptr<VisionFrontEnd> makeFrontEnd(const Settings& settings, const CameraFile& camera)
{
  const std::string sensor = settings.choice("Images", "sensor");
  if (sensor == "conic_mirror") return std::make_unique<ConicMirrorFrontEnd>(settings, camera);
  if (sensor == "movis") return std::make_unique<MovisFrontEnd>(settings, camera);
  if (sensor == "stereo_goal") return std::make_unique<StereoGoalFrontEnd>(settings, camera);
  if (sensor == "tags") return std::make_unique<TagsFrontEnd>(settings, camera);
  throw std::logic_error("no front end for sensor " + sensor);
}
}  // namespace mrpt_ext
