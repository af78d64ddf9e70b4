#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>

#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/hypotheses/pose_region.h"
#include "mrpt_ext/localizers/closed_form_localizer.h"
#include "mrpt_ext/solvers/running_fix_pose.h"

namespace mrpt_ext
{
/// Source of the heading, without which the two range circles cannot be intersected.
enum class HeadingSource
{
  bearing,  ///< two landmarks in one frame, then eq 7 after every fix; odometry in between
  compass,  ///< compass readings; odometry in between
  filter,   ///< estimate of the particle filter, on which the method then depends
  none      ///< no heading: a ring, no estimate
};

struct RunningFixOptions
{
  HeadingSource heading_source = HeadingSource::bearing;
  std::optional<HeadingPrior> start_heading;  ///< known start, for HeadingSource::bearing
  PoseRegion region;                          ///< candidates outside are dropped
  MotionModel motion;
  ErrorLimits limits;
};

/// The running fix of paper 004: logged fixes, or two ranges to one landmark with odometry in between. The candidates
/// of a frame are scored by all its readings, so a bearing or a second landmark resolves the ambiguity.
class RunningFixLocalizer : public Localizer
{
 public:
  /// Heading at the time of the frame for HeadingSource::filter; nothing unless the verdict is `ok`.
  using FilterHeading = std::function<std::optional<HeadingPrior>()>;

  RunningFixLocalizer(const RunningFixOptions& options, const LandmarkTable& map, FilterHeading filter_heading = {})
      : options_(options), map_(map), heading_(options.start_heading), filter_heading_(std::move(filter_heading))
  {
  }

  [[nodiscard]] std::string name() const override { return "running_fix"; }
  [[nodiscard]] bool continuous() const override { return false; }
  Estimate process(const Frame& frame) override;

 private:
  /// A range waiting for a second one.
  struct PendingRange
  {
    double time = 0;
    double range = 0, std = 0;  // horizontal
    Pose2 T_robot_sensor;       // in the robot frame of its own time
    OdometryMotion since;       // motion from then to now
  };

  void predict(const OdometryMotion& measured);
  void updateHeading(const Frame& frame);
  [[nodiscard]] std::vector<RunningFixReading> fixesFromRanges(const Frame& frame);
  [[nodiscard]] HypothesisSet candidatesOf(const std::vector<RunningFixReading>& fixes, const Frame& frame) const;

  RunningFixOptions options_;
  LandmarkTable map_;
  std::optional<HeadingPrior> heading_;
  FilterHeading filter_heading_;
  std::map<int, std::deque<PendingRange>> pending_;  // by landmark id
};
}  // namespace mrpt_ext
