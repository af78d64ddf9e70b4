#pragma once

#include <filesystem>

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/observations/mrpt_scene.h"

namespace mrpt_ext
{
/// One step of a run for MRPT's viewers: landmarks, particles as MRPT's CPosePDFParticles shows them, the 95 % ellipse
/// of every mode, the best pose and its detections: a ray for a bearing, a ring for a range alone.
[[nodiscard]] MrptScene::Ptr runScene(const LandmarkTable& map, const PlaybackStep& step);

/// Writes the scene of `step` as a file of SceneViewer3D, whole or not at all. InputError when it cannot be written.
void writeScene(const std::filesystem::path& path, const LandmarkTable& map, const PlaybackStep& step);
}  // namespace mrpt_ext
