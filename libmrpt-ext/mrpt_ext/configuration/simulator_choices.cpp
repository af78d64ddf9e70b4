#include "mrpt_ext/configuration/simulator_choices.h"

namespace mrpt_ext
{
NamedValues<MapSource> mapSources()
{
  return {{MapSource::written, {"explicit", {}, "the keys landmarks, ids and categories"}},
          {MapSource::file, {"file", {}, "a map CSV"}},
          {MapSource::random, {"random", {}, "uniform in a box"}},
          {MapSource::grid, {"grid", {}, "rows and columns over a box"}}};
}

NamedValues<PathKind> pathKinds()
{
  return {{PathKind::waypoints, {"waypoints", {}, "from waypoint to waypoint"}},
          {PathKind::circle, {"circle", {}, "around centre, starting at its right end"}},
          {PathKind::square, {"square", {}, "around centre"}},
          {PathKind::random_walk, {"random_walk", {}, "random turns within bounds"}},
          {PathKind::standstill, {"standstill", {}, "stays at start"}}};
}

NamedValues<SensorKind> sensorKinds()
{
  return {{SensorKind::bearings, {"bearings", {}, "bearings of landmarks"}},
          {SensorKind::ranges, {"ranges", {}, "ranges of landmarks"}},
          {SensorKind::range_bearing, {"range_bearing", {}, "both"}},
          {SensorKind::running_fix, {"running_fix", {}, "the range of one landmark, and again after a displacement"}},
          {SensorKind::compass, {"compass", {}, "the robot's heading"}}};
}
}  // namespace mrpt_ext
