#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iomanip>

#include "filter_scenario.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/online/online_localizer.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr double kRate = 10;                       // [Hz] of odometry and camera
constexpr int kDay = 24;                           // [h]
constexpr double kHour = 3600;                     // [s]
constexpr double kRadius = 1.25, kTurnRate = 0.4;  // [m], [rad/s] of the circle that the robot drives
const LandmarkTable kMap({{1, {0, 0, 0}}, {2, {6, 0, 0}}, {3, {6, 5, 0}}, {4, {0, 5, 0}}});

Pose2 truthAt(double time)
{
  const double a = wrap(kTurnRate * time);
  return {3 + kRadius * std::sin(a), 1.2 + kRadius * (1 - std::cos(a)), a};
}

std::vector<Detection> detectionsAt(double time, RandomStream& random)
{
  std::vector<Detection> detections;
  for (const Landmark& landmark : kMap.all())
    detections.push_back(
        {.id = landmark.id,
         .bearing = wrap(predictBearing(truthAt(time), landmark.position.head<2>()) + degToRad(1) * random.gaussian()),
         .std_bearing = degToRad(1)});
  return detections;
}

/// [MB] that this process holds in memory.
double residentMemory()
{
  std::ifstream file("/proc/self/statm");
  double size = 0, resident = 0;
  file >> size >> resident;
  return resident * 4096 / 1e6;
}

void oneDay(std::ostream& out)
{
  OnlineOptions options;
  options.filter.region = {{0, 0}, {6, 5}};
  OnlineLocalizer robot(options, kMap);
  RandomStream random(1);
  const int hours = studyRuns(kDay);
  double worst = 0, after_hour = 0, worst_error = 0;
  std::size_t estimates = 0, ok = 0;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(hours * kHour * kRate); ++k)
  {
    const double t = static_cast<double>(k) / kRate;
    const auto before = std::chrono::steady_clock::now();
    robot.addOdometry(t, truthAt(t));
    robot.addDetections(t, "camera", detectionsAt(t, random));
    for (const OnlineEstimate& estimate : robot.estimates())
    {
      ++estimates;
      if (estimate.verdict != Verdict::ok) continue;
      ++ok;
      worst_error =
          std::max(worst_error, (estimate.best->pose.mean.position() - truthAt(estimate.time).position()).norm());
    }
    const std::chrono::duration<double, std::milli> call = std::chrono::steady_clock::now() - before;
    worst = std::max(worst, call.count());
    if (t == kHour) after_hour = residentMemory();
  }
  out << std::setprecision(4)
      << "| estimates | ok | worst error of these | memory after an hour | after all | worst call |\n"
      << "|---|---|---|---|---|---|\n| " << estimates << " | "
      << 100.0 * static_cast<double>(ok) / static_cast<double>(estimates) << " % | " << worst_error << " m | "
      << after_hour << " MB | " << residentMemory() << " MB | " << worst << " ms |\n";
}

const RegisterStudy kOnlineDay(
    "online_day",
    "A day of live input at 10 Hz (STUDY_RUNS: hours): does memory grow, and how long does a call take at most?",
    oneDay);
}  // namespace
}  // namespace mrpt_ext
