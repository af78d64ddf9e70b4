#pragma once

#include <utility>
#include <vector>

#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"

namespace mrpt_ext
{
/// Pose hypotheses for a filter that has to be initialized, or that searches for the robot elsewhere.
struct Proposal
{
  Proposal() = default;
  Proposal(HypothesisSet set) : hypotheses(std::move(set)) {}  // NOLINT(google-explicit-constructor)

  HypothesisSet hypotheses;
  /// Readings of the window, transformed to the newest frame, which is included: the measurements to initialize with.
  /// Empty: those of the frame alone.
  std::vector<Reading> window_readings;
  /// False while the window is not full: without hypotheses, or with anonymous detections that leave several modes, an
  /// initialization is better postponed.
  bool complete = true;
};

/// Smallest standard deviations of a hypothesis that a filter starts from: x, y [m], phi [rad].
inline const Vector3d kMinSeedStd{0.03, 0.03, degToRad(1.0)};
}  // namespace mrpt_ext
