#pragma once

#include <optional>
#include <string>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/pose_estimate.h"
#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"

namespace mrpt_ext
{
inline constexpr double kMinReportedWeight = 0.002;  ///< of a mode among the candidates of a filter

/// Output of a method after one frame.
struct Estimate
{
  SolveStatus status = SolveStatus::too_few;
  std::optional<PoseEstimate> point;  ///< absent: no solution, or candidates that cannot be ranked
  HypothesisSet candidates;           ///< all poses consistent with the frame, best first
  bool ambiguous = false;             ///< several candidates, none preferred
};

/// Interface of all localization methods: frame in, estimate out. They never see the ground truth.
class Localizer
{
 public:
  virtual ~Localizer() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  /// True for methods that track the pose from frame to frame (odometry, Kalman and particle filters).
  [[nodiscard]] virtual bool continuous() const = 0;
  virtual Estimate process(const Frame& frame) = 0;
};
}  // namespace mrpt_ext
