#include "mrpt_ext/relocalization/trajectory_relocalizer.h"

#include <algorithm>
#include <vector>

#include "mrpt_ext/geometry/identified.h"

namespace mrpt_ext
{
namespace
{
constexpr double kBuffered = 240;              // [s]
constexpr double kStepDuration = 1;            // [s]
constexpr std::size_t kMostCurrentModes = 10;  // that compete with the poses found
}  // namespace

TrajectoryRelocalizer::TrajectoryRelocalizer(const LandmarkTable& map, std::shared_ptr<const GlobalPoseSearch> search,
                                             const PoseRegion& region, const MotionModel& motion)
    : map_(map), search_(std::move(search)), region_(region), motion_(motion)
{
}

void TrajectoryRelocalizer::add(const Frame& frame)
{
  has_identified_ = has_identified_ || hasIdentified(frame);
  if (frames_.empty() && !hasAnonymous(frame)) return;
  frames_.push_back(frame);
  while (frame.time - frames_.front().time > kBuffered) frames_.pop_front();
}

HypothesisSet TrajectoryRelocalizer::search(const ModeSet& current, WorkBudget& budget)
{
  if (frames_.empty() || frames_.back().time - last_search_ < interval_) return {};
  interval_ = std::min(2 * interval_, kLongestInterval);
  last_search_ = frames_.back().time;
  const OdometryMotion& last = frames_.back().motion;
  std::vector<GaussianPose> predicted;
  for (std::size_t m = 0; m < std::min(kMostCurrentModes, current.modes.size()); ++m)
    predicted.push_back(
        compound(current.modes[m].pose, nominalMotion(motion_, last).increment, incrementCovariance(motion_, last)));
  std::vector<Frame> frames(frames_.begin(), frames_.end());
  frames.front().motion = {};
  const auto steps = trajectorySteps(frames, motion_, map_, search_->index(), kStepDuration);
  return localizeOverTrajectory(steps, *search_, region_, predicted, budget).hypotheses;
}
}  // namespace mrpt_ext
