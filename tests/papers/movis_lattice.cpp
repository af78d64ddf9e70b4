#include "movis_lattice.h"

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/solvers/camera_yaw_calibration.h"
#include "mrpt_ext/solvers/omni_stereo.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext::papers
{
MovisLattice readLattice(const Settings& settings)
{
  const std::string s = "Movis";
  MovisLattice lattice;
  lattice.field = {settings.number(s, "half_width_m"), settings.number(s, "depth_m")};
  const auto ball = settings.numbers(s, "ball");
  lattice.ball = {ball.at(0), ball.at(1)};
  lattice.names = settings.words(s, "points");
  const auto places = settings.numbers(s, "places");
  if (places.size() != 2 * lattice.names.size())
    throw settings.errorAt(s, "places", "expected x y of every one of the points");
  for (std::size_t i = 0; i < lattice.names.size(); ++i)
  {
    lattice.places.emplace_back(places[2 * i], places[2 * i + 1]);
    if (lattice.names[i] == settings.text(s, "origin")) lattice.origin = i;
  }
  lattice.mount_radius = settings.number(s, "mount_radius_m");
  lattice.std_bearing = settings.radians(s, "std_bearing_deg");
  const auto yaw = settings.numbers(s, "yaw_deg");
  lattice.yaw = {degToRad(yaw.at(0)), degToRad(yaw.at(1))};
  return lattice;
}

MovisLook lookFrom(const MovisLattice& lattice, const Vector2d& place, RandomStream& random)
{
  MovisLook look;
  const auto things = lattice.things();
  for (std::size_t thing = 0; thing < things.size(); ++thing)
    for (std::size_t k = 0; k < 2; ++k)
      look.slant[thing][k] = wrap(angleOf(things[thing] - place - lattice.camera(k).position) - lattice.yaw[k] +
                                  lattice.std_bearing * random.gaussian());
  return look;
}

std::optional<Vector2d> meeting(const MovisLattice& lattice, const std::array<double, 2>& slant)
{
  const auto ray = [&](std::size_t k) { return SightRay{lattice.camera(k).position, slant[k], lattice.std_bearing}; };
  const Triangulation met = triangulate(ray(0), ray(1));
  if (met.status != SolveStatus::ok) return std::nullopt;
  return met.point.mean;
}

std::vector<PoseMeasurement> poleMeasurements(const MovisLattice& lattice, const MovisLook& look)
{
  std::vector<PoseMeasurement> measurements;
  const auto things = lattice.things();
  for (std::size_t pole = 0; pole < 2; ++pole)
    for (std::size_t k = 0; k < 2; ++k)
    {
      const Vector2d mount = robotFromMovis(lattice.camera(k).position);
      measurements.push_back({PoseMeasurement::Kind::bearing,
                              things[pole],
                              forwardBearingFromSlant(look.slant[pole][k]),
                              lattice.std_bearing,
                              {mount.x(), mount.y(), 0}});
    }
  return measurements;
}

std::array<double, 2> calibratedYaw(const MovisLattice& lattice, const std::vector<MovisLook>& at_origin)
{
  const Vector2d place = lattice.places[lattice.origin];
  std::array<double, 2> yaw{};
  for (std::size_t k = 0; k < 2; ++k)
  {
    const Vector2d mount = robotFromMovis(lattice.camera(k).position);
    std::vector<CalibrationSighting> sightings;
    for (const MovisLook& look : at_origin)
      for (std::size_t pole = 0; pole < 2; ++pole)
        sightings.push_back({{place.x(), place.y(), headingFromSlope(0)},
                             lattice.things()[pole],
                             forwardBearingFromSlant(look.slant[pole][k])});
    // The offset is measured minus predicted: the opposite of what the camera is turned by.
    yaw[k] = -calibrateCameraYaw(sightings, {mount.x(), mount.y(), 0}).offset;
  }
  return yaw;
}

MovisLook straightened(MovisLook look, const std::array<double, 2>& yaw)
{
  for (auto& slants : look.slant)
    for (std::size_t k = 0; k < 2; ++k) slants[k] = wrap(slants[k] + yaw[k]);
  return look;
}
}  // namespace mrpt_ext::papers
