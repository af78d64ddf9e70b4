#include "mrpt_ext/relocalization/window_bearings.h"

#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kStdParallax = degToRad(0.7);    // of bearings taken at different positions within one step
constexpr double kMaxStdHeading = degToRad(3.0);  // of the odometry from the central step, up to which steps are used
constexpr double kTypicalRange = 3;               // [m] converts a position error of odometry into a bearing error
constexpr std::size_t kMostPerSide = 10;          // bearings, from which on no further step is used

class WindowBuilder
{
 public:
  explicit WindowBuilder(std::span<const TrajectoryStep> trajectory) : trajectory_(trajectory) {}

  /// The bearings of the central step and of those after it.
  void addForward(std::size_t centre)
  {
    HypothesisTrack relative{{{}, Matrix3d::Zero()}, 0};  // pose of step k in the frame of the central one
    const std::size_t before = bearings_.size();
    for (std::size_t k = centre;;)
    {
      add(trajectory_[k], relative.pose);
      if (++k == trajectory_.size() || bearings_.size() >= before + kMostPerSide) return;
      predict(relative, trajectory_[k]);
      if (!isAccurate(relative.pose)) return;
    }
  }

  void addBackward(std::size_t centre)
  {
    HypothesisTrack relative{{{}, Matrix3d::Zero()}, 0};
    const std::size_t before = bearings_.size();
    for (std::size_t k = centre; k > 0 && bearings_.size() < before + kMostPerSide; --k)
    {
      retrodict(relative, trajectory_[k]);
      if (!isAccurate(relative.pose)) return;
      add(trajectory_[k - 1], relative.pose);
    }
  }

  [[nodiscard]] std::vector<WindowBearing> take() { return std::move(bearings_); }

 private:
  static bool isAccurate(const GaussianPose& relative) { return relative.covariance(2, 2) < square(kMaxStdHeading); }

  void add(const TrajectoryStep& step, const GaussianPose& relative)
  {
    const double odometry_variance =
        relative.covariance(2, 2) + relative.covariance.topLeftCorner<2, 2>().trace() / square(kTypicalRange);
    for (const Scan& scan : step.scans)
      for (const AnonymousDetection& d : scan.detections)
        if (d.bearing && d.category != kUnknownCategory)
          bearings_.push_back({compose(relative.mean, scan.T_robot_sensor), *d.bearing,
                               std::sqrt(square(d.std_bearing) + square(kStdParallax) + odometry_variance),
                               d.category});
  }

  std::span<const TrajectoryStep> trajectory_;
  std::vector<WindowBearing> bearings_;
};
}  // namespace

std::vector<WindowBearing> windowBearings(std::span<const TrajectoryStep> trajectory, std::size_t step)
{
  WindowBuilder window(trajectory);
  window.addForward(step);
  window.addBackward(step);
  return window.take();
}
}  // namespace mrpt_ext
