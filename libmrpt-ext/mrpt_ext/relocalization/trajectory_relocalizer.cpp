#include "mrpt_ext/relocalization/trajectory_relocalizer.h"

#include <algorithm>
#include <vector>

namespace mrpt_ext
{
namespace
{
constexpr double kRemembered = 240, kLook = 1;  // [s] of the way that is searched, and of what makes one look
constexpr std::size_t kMostHeld = 10;           // modes that are judged with what the search proposes
}  // namespace

TrajectoryRelocalizer::TrajectoryRelocalizer(const LandmarkTable& map, std::shared_ptr<const GlobalPoseSearch> search,
                                             const PoseRegion& region, const MotionModel& motion)
    : map_(map), search_(std::move(search)), region_(region), motion_(motion)
{
}

void TrajectoryRelocalizer::add(const Frame& frame)
{
  for (const Reading& reading : frame.readings)
    names_ = names_ || std::any_of(reading.detections.begin(), reading.detections.end(),
                                   [](const Detection& d) { return d.id != kNoId; });
  if (frames_.empty() && !hasAnonymous(frame)) return;
  frames_.push_back(frame);
  while (frame.time - frames_.front().time > kRemembered) frames_.pop_front();
}

HypothesisSet TrajectoryRelocalizer::search(const ModeSet& held)
{
  if (frames_.empty() || frames_.back().time - searched_at_ < pause_) return {};
  pause_ = std::min(2 * pause_, kLongestPause);
  searched_at_ = frames_.back().time;
  const OdometryMotion& last = frames_.back().motion;
  std::vector<GaussianPose> supposed;
  for (std::size_t m = 0; m < std::min(kMostHeld, held.modes.size()); ++m)
  {
    HypothesisTrack place{held.modes[m].pose, 0};
    predict(place, {believedMotion(motion_, last).increment, incrementCovariance(motion_, last), {}});
    supposed.push_back(place.pose);
  }
  std::vector<Frame> way(frames_.begin(), frames_.end());
  way.front().motion = {};
  return localizeOverTrajectory(trajectorySteps(way, motion_, map_, search_->index(), kLook), *search_, region_,
                                supposed)
      .hypotheses;
}
}  // namespace mrpt_ext
