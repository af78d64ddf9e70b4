#include "mrpt_ext/rawlog/step_clock.h"

#include <mrpt/obs/CAction.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3D.h>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/formatted.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/observations/observation_conversions.h"
#include "mrpt_ext/rawlog/action_frames.h"
#include "mrpt_ext/rawlog/rawlog_reader.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMostSpeed = 100;     ///< [m/s] faster than any robot
constexpr double kMostTurnRate = 100;  ///< [rad/s]
constexpr double kLeastPath = 0.1;     ///< [m, rad] less is no motion to judge by
constexpr double kMostTilt = degToRad(10.0);
constexpr double kMostHeight = 0.5;  ///< [m] that dead reckoning may wander off the plane ...
constexpr double kMostSlope = 0.1;   ///< ... and per metre of its path

/// What the stamps and the motion of a log have in common.
class StampStatistics
{
 public:
  void add(const mrpt::poses::CPose3D& increment)
  {
    pose_ = pose_ + increment;
    path_ += increment.norm();
    turned_ += std::abs(increment.yaw());
  }
  void add(std::optional<double> time)
  {
    ++frames_;
    if (time && latest_ && *time < *latest_) ++backward_;
    if (!time || (latest_ && *time <= *latest_)) return;
    ++new_times_;
    if (!first_) first_ = time;
    latest_ = time;
  }

  [[nodiscard]] std::string whyNoClock() const
  {
    if (backward_ > 0) return "go back in time";
    if (2 * new_times_ <= frames_) return "are missing or equal";
    const double seconds = first_ ? *latest_ - *first_ : 0;
    const bool moves = new_times_ > 1 && (path_ > kLeastPath || turned_ > kLeastPath);
    if (moves && (path_ > kMostSpeed * seconds || turned_ > kMostTurnRate * seconds))
      return formatted("span %.3g s for %.1f m of motion", seconds, path_);
    return {};
  }
  [[nodiscard]] std::size_t frames() const { return frames_; }

  /// What takes the robot out of the plane.
  [[nodiscard]] std::string whyNotPlanar() const
  {
    const double tilt = std::max(std::abs(pose_.pitch()), std::abs(pose_.roll()));
    if (tilt > kMostTilt)
      return formatted("pitch %.0f deg, roll %.0f deg", radToDeg(pose_.pitch()), radToDeg(pose_.roll()));
    if (std::abs(pose_.z()) > kMostHeight + kMostSlope * path_) return formatted("height %.1f m", pose_.z());
    return {};
  }

 private:
  mrpt::poses::CPose3D pose_;
  double path_ = 0, turned_ = 0;  // m, rad
  std::size_t frames_ = 0, new_times_ = 0, backward_ = 0;
  std::optional<double> first_, latest_;
};
}  // namespace

StepClock stepClockOf(const std::filesystem::path& path, double step)
{
  RawlogReader reader(path, translatedClasses());
  StampStatistics statistics;
  std::optional<double> action_time;
  const auto addAction = [&](const mrpt::obs::CAction& action)
  {
    if (const auto increment = incrementOf(action)) statistics.add(*increment);
    action_time = timeOf(action.timestamp);
    if (const std::string why = statistics.whyNotPlanar(); !why.empty())
      throw dataError(reader.where() + "the robot moves in 3-D (" + shortClassName(action) + ": " + why +
                      "), expected a robot on a plane");
  };
  while (const auto entry = reader.next())
  {
    if (const auto* actions = dynamic_cast<const mrpt::obs::CActionCollection*>(entry.get()))
      for (const auto& action : *actions) addAction(*action);
    else if (const auto* action = dynamic_cast<const mrpt::obs::CAction*>(entry.get()))
      addAction(*action);
    else if (const auto* frame = dynamic_cast<const mrpt::obs::CSensoryFrame*>(entry.get()))
    {
      const auto time = latestTime(*frame);
      statistics.add(time ? time : action_time);
      action_time.reset();
    }
  }
  const std::string why = statistics.whyNoClock();
  if (why.empty()) return {};
  return {step, formatted("one step of the log counts %.3g s (step_s): the stamps of its %zu sensory frames ", step,
                          statistics.frames()) +
                    why};
}
}  // namespace mrpt_ext
