#pragma once

#include <optional>
#include <string>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/pose_estimate.h"
#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"

namespace mrpt_ext
{
/// What a method says after one frame.
struct Estimate
{
  SolveStatus status = SolveStatus::too_few;
  std::optional<PoseEstimate> point;  ///< absent: no estimate, or candidates that it cannot rank
  HypothesisSet candidates;           ///< all poses consistent with the frame, best first
  bool ambiguous = false;             ///< several candidates, none preferred
};

/// One way to localize: frame in, estimate out. Never sees ground truth.
class Localizer
{
 public:
  virtual ~Localizer() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  /// True for methods that carry their pose from frame to frame (odometry, EKF, filter).
  [[nodiscard]] virtual bool continuous() const = 0;
  virtual Estimate process(const Frame& frame) = 0;
};
}  // namespace mrpt_ext
