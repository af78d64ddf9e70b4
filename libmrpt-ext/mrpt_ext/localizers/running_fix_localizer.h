#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>

#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/hypotheses/pose_region.h"
#include "mrpt_ext/localizers/localizer.h"
#include "mrpt_ext/solvers/running_fix_pose.h"

namespace mrpt_ext
{
/// Where the running fix takes the heading from that its two circles need.
enum class HeadingSource
{
  bearing,  ///< two landmarks seen at once, then eq 7 after every fix, carried by odometry in between
  compass,  ///< readings of a compass, carried by odometry in between
  filter,   ///< the particle filter's estimate: the row depends on the filter and is marked so
  none      ///< no heading: a ring, no estimate
};

struct RunningFixOptions
{
  HeadingSource heading_source = HeadingSource::bearing;
  std::optional<HeadingPrior> start_heading;  ///< known start, for HeadingSource::bearing
  PoseRegion region;                          ///< candidates outside are dropped
  MotionModel motion;
  double min_displacement_stds = 10;  ///< two ranges are a fix when the way between them is this many range stds
  double max_age = 60;                ///< [s] ranges older than this are forgotten
};

/// The running fix of paper 004 over time: logged fixes, or two ranges to one landmark with odometry in between. All
/// candidates of a frame are scored by the frame's own readings, so a bearing or a second landmark breaks the tie.
class RunningFixLocalizer : public Localizer
{
 public:
  /// Heading at the frame's time for HeadingSource::filter; nothing while the filter is not sure.
  using FilterHeading = std::function<std::optional<HeadingPrior>()>;

  RunningFixLocalizer(const RunningFixOptions& options, const LandmarkTable& map, FilterHeading filter_heading = {})
      : options_(options), map_(map), heading_(options.start_heading), filter_heading_(std::move(filter_heading))
  {
  }

  [[nodiscard]] std::string name() const override { return "running_fix"; }
  [[nodiscard]] bool continuous() const override { return false; }
  Estimate process(const Frame& frame) override;

 private:
  /// A range that waits for its partner.
  struct PendingRange
  {
    double time = 0;
    double range = 0, std = 0;  // horizontal
    Pose2 T_robot_sensor;       // in the robot frame of its own time
    OdometryMotion since;       // motion from then to now
  };

  void carryForward(const OdometryMotion& measured);
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
