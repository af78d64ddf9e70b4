#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/version.h>

#include <cstring>
#include <memory>

#if MRPT_VERSION >= 0x030000  // before 2.10.2 the parts of a version are single digits: 0x258
#define MRPT_EXT_MRPT3
#include <mrpt/viz/viz_frwds.h>
#else
#include <mrpt/opengl/opengl_frwds.h>
#endif

/// What differs between the versions of MRPT that we build with (2.5.8 to 3.1), in one place. The objects of 3-D scenes
/// are in mrpt_scene.h; the names of packages and targets in libmrpt-ext/find_mrpt.cmake.
namespace mrpt_ext
{
/// The objects of 3-D scenes.
#ifdef MRPT_EXT_MRPT3
namespace scenes = mrpt::viz;
#else
namespace scenes = mrpt::opengl;
#endif

/// An observation of a sensor that is fixed on the robot. MRPT 3 asks for the pose by value.
class FixedSensorObservation : public mrpt::obs::CObservation
{
 public:
  mrpt::poses::CPose3D sensor_pose;  ///< on the robot

#ifdef MRPT_EXT_MRPT3
  [[nodiscard]] mrpt::poses::CPose3D getSensorPose() const override { return sensor_pose; }
#else
  void getSensorPose(mrpt::poses::CPose3D& pose) const override { pose = sensor_pose; }
#endif
  void setSensorPose(const mrpt::poses::CPose3D& pose) override { sensor_pose = pose; }
};

/// Hands a new map to MRPT, whose TMetricMapInitializer takes a plain pointer before 2.11.3 and a std::shared_ptr
/// since: `Result` is what the function that MAP_DEFINITION_END declares returns.
template <typename Result, typename Map>
[[nodiscard]] Result handOver(std::unique_ptr<Map> map)
{
  return Result(map.release());
}
}  // namespace mrpt_ext
