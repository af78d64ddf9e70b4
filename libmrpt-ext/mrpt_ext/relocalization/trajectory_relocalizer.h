#pragma once

#include <deque>
#include <limits>
#include <memory>

#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/relocalization/trajectory_search.h"
#include "mrpt_ext/relocalization/trajectory_steps.h"

namespace mrpt_ext
{
/// What a robot saw along the last minutes of its way where detections have no names, to be searched for all of it at
/// once (relocalization/trajectory_search.h). A search takes a quarter of a second where a frame takes a millisecond,
/// so each one doubles the pause before the next.
class TrajectoryRelocalizer
{
 public:
  TrajectoryRelocalizer(const LandmarkTable& map, std::shared_ptr<const GlobalPoseSearch> search,
                        const PoseRegion& region, const MotionModel& motion);

  void add(const Frame& frame);
  /// True when all that was seen has no name: where some has, the way alone does not tell all that is known.
  [[nodiscard]] bool isApplicable() const { return !frames_.empty() && !names_; }
  /// Where the robot may be at the newest frame. `held`: the modes before that frame's motion, the likeliest of which
  /// are judged too. Empty while it pauses.
  [[nodiscard]] HypothesisSet search(const ModeSet& held);
  /// The place is not sure any more: it may be searched soon again.
  void resetInterval() { pause_ = kShortestPause; }

 private:
  static constexpr double kShortestPause = 5, kLongestPause = 40;  // [s]

  LandmarkTable map_;
  std::shared_ptr<const GlobalPoseSearch> search_;
  PoseRegion region_;
  MotionModel motion_;
  std::deque<Frame> frames_;
  bool names_ = false;
  double searched_at_ = -std::numeric_limits<double>::infinity();  // [s] along the way
  double pause_ = kShortestPause;
};
}  // namespace mrpt_ext
