#pragma once

#include <deque>
#include <limits>
#include <memory>

#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/relocalization/trajectory_search.h"
#include "mrpt_ext/relocalization/trajectory_steps.h"

namespace mrpt_ext
{
/// Buffers the frames of the last four minutes and searches them for robot poses (trajectory_search.h), if all
/// detections are anonymous. A search takes a quarter of a second where a frame takes a millisecond, so the interval
/// between searches doubles with each, from 5 s up to 40 s.
class TrajectoryRelocalizer
{
 public:
  TrajectoryRelocalizer(const LandmarkTable& map, std::shared_ptr<const GlobalPoseSearch> search,
                        const PoseRegion& region, const MotionModel& motion);

  void add(const Frame& frame);
  /// False once a detection was identified: the search would ignore it.
  [[nodiscard]] bool isApplicable() const { return !frames_.empty() && !has_identified_; }
  /// Poses at the newest frame, with weights; empty before the interval since the last search is over. `current`: modes
  /// before the motion of the newest frame; the likeliest of them compete with the poses found. Takes work from
  /// `budget`.
  [[nodiscard]] HypothesisSet search(const ModeSet& current, WorkBudget& budget);
  /// Back to the shortest interval: the pose is in doubt again.
  void resetInterval() { interval_ = kShortestInterval; }

 private:
  static constexpr double kShortestInterval = 5, kLongestInterval = 40;  // [s]

  LandmarkTable map_;
  std::shared_ptr<const GlobalPoseSearch> search_;
  PoseRegion region_;
  MotionModel motion_;
  std::deque<Frame> frames_;
  bool has_identified_ = false;
  double last_search_ = -std::numeric_limits<double>::infinity();  // [s] time of the frame
  double interval_ = kShortestInterval;
};
}  // namespace mrpt_ext
