#include <cstdio>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/localizers/particle_filter_localizer.h"

// A robot turns on the spot at (2, 1) and sees one landmark after the other; the filter is not told where it stands.
int main()
{
  using namespace mrpt_ext;
  const LandmarkTable map({{1, {0, 0, 0}}, {2, {6, 0, 0}}, {3, {6, 5, 0}}, {4, {0, 5, 0}}});
  ParticleFilterLocalizer filter({.region = {{0, 0}, {6, 5}}}, map, /*seed_window=*/5.0, /*seed=*/1);
  Estimate estimate;
  for (std::size_t k = 0; k < 20; ++k)
  {
    const double time = static_cast<double>(k), turn = k > 0 ? degToRad(10) : 0;
    const Landmark& seen = map[k % map.size()];
    const double bearing = predictBearing({2, 1, degToRad(10) * time}, seen.position.head<2>());
    Frame frame{.time = time, .motion = {.increment = {0, 0, turn}, .turned = turn, .duration = 1}};
    frame.readings.push_back({.time = time, .sensor = "camera"});
    frame.readings[0].detections.push_back({.id = seen.id, .bearing = bearing, .std_bearing = degToRad(1)});
    estimate = filter.process(frame);
  }
  if (!estimate.point) return 1;
  const Pose2& pose = estimate.point->pose.mean;
  std::printf("estimate: %.2f %.2f %.0f\n", pose.x, pose.y, radToDeg(pose.phi));
}
