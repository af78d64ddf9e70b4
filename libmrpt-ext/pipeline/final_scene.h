#pragma once

#include <filesystem>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/pipeline/trial_runner.h"

namespace mrpt_ext
{
/// Writes a scene for MRPT's SceneViewer3D: landmarks, particles as MRPT's CPosePDFParticles shows them, the best pose
/// and the covariance ellipse of every mode.
void writeFinalScene(const std::filesystem::path& path, const LandmarkTable& map, const TrialOutcome& outcome);
}  // namespace mrpt_ext
