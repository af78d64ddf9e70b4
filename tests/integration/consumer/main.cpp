#include <cstdio>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/online/online_localizer.h"

// A robot turns on the spot at (2, 1) and sees one landmark after the other; the filter is not told where it stands.
int main()
{
  using namespace mrpt_ext;
  const LandmarkTable map({{1, {0, 0, 0}}, {2, {6, 0, 0}}, {3, {6, 5, 0}}, {4, {0, 5, 0}}});
  OnlineOptions options{.seed_window = 5};
  options.filter.region = {{0, 0}, {6, 5}};
  OnlineLocalizer robot(options, map);
  for (std::size_t k = 0; k < 20; ++k)
  {
    const double time = static_cast<double>(k), heading = degToRad(10) * time;
    const Landmark& seen = map[k % map.size()];
    const double bearing = predictBearing({2, 1, heading}, seen.position.head<2>());
    robot.addOdometry(time, {0, 0, heading});
    robot.addDetections(time, "camera", {{.id = seen.id, .bearing = bearing, .std_bearing = degToRad(1)}});
  }
  const std::vector<OnlineEstimate> estimates = robot.finish();
  if (estimates.empty() || !estimates.back().best) return 1;
  const Pose2& pose = estimates.back().best->pose.mean;
  std::printf("estimate: %.2f %.2f %.0f\n", pose.x, pose.y, radToDeg(pose.phi));
}
