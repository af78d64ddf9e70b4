#include "mrpt_ext/relocalization/window_bearings.h"

#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kStdParallax = degToRad(0.7);  // of bearings taken within a look, from one place to the other
constexpr double kRigid = degToRad(3.0);        // standard deviation of heading up to which looks are joined
constexpr double kTypicalRange = 3;             // [m] at which an error of the way is felt as one of bearing
constexpr std::size_t kMostJoined = 10;         // bearings on either side, from which on no further look is joined

class Joiner
{
 public:
  explicit Joiner(std::span<const TrajectoryStep> way) : way_(way) {}

  /// The look's own bearings and those of the looks after it.
  void joinForward(std::size_t at)
  {
    HypothesisTrack there{{{}, Matrix3d::Zero()}, 0};
    const std::size_t before = joined_.size();
    for (std::size_t k = at;;)
    {
      add(way_[k], there.pose);
      if (++k == way_.size() || joined_.size() >= before + kMostJoined) return;
      predict(there, way_[k]);
      if (!isRigid(there.pose)) return;
    }
  }

  void joinBackward(std::size_t at)
  {
    HypothesisTrack there{{{}, Matrix3d::Zero()}, 0};
    const std::size_t before = joined_.size();
    for (std::size_t k = at; k > 0 && joined_.size() < before + kMostJoined; --k)
    {
      retrodict(there, way_[k]);
      if (!isRigid(there.pose)) return;
      add(way_[k - 1], there.pose);
    }
  }

  [[nodiscard]] std::vector<WindowBearing> take() { return std::move(joined_); }

 private:
  static bool isRigid(const GaussianPose& there) { return there.covariance(2, 2) < square(kRigid); }

  void add(const TrajectoryStep& step, const GaussianPose& there)
  {
    const double of_way =
        there.covariance(2, 2) + there.covariance.topLeftCorner<2, 2>().trace() / square(kTypicalRange);
    for (const Scan& place : step.seen)
      for (const AnonymousDetection& d : place.detections)
        if (d.bearing && d.category != kUnknownCategory)
          joined_.push_back({compose(there.mean, place.T_robot_sensor), *d.bearing,
                             std::sqrt(square(d.std_bearing) + square(kStdParallax) + of_way), d.category});
  }

  std::span<const TrajectoryStep> way_;
  std::vector<WindowBearing> joined_;
};
}  // namespace

std::vector<WindowBearing> windowBearings(std::span<const TrajectoryStep> way, std::size_t at)
{
  Joiner joiner(way);
  joiner.joinForward(at);
  joiner.joinBackward(at);
  return joiner.take();
}
}  // namespace mrpt_ext
