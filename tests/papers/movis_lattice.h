#pragma once

#include <array>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/settings/settings.h"
#include "mrpt_ext/solvers/movis_frame.h"
#include "mrpt_ext/solvers/pose_measurement.h"
#include "mrpt_ext/solvers/two_pole_pose.h"

namespace mrpt_ext::papers
{
/// The half field of paper 001 with its lattice, and the robot's two front cameras. All in the paper's frames: world x
/// to the right, y to the goal; robot x to the right, y forward, so that a robot put down straight has slope 0.
struct MovisLattice
{
  PoleField field;
  Vector2d ball{0, 0};
  std::vector<std::string> names;
  std::vector<Vector2d> places;
  std::size_t origin = 0;  ///< index of the point where the cameras are calibrated
  double mount_radius = 0;
  double std_bearing = 0;       ///< [rad]
  std::array<double, 2> yaw{};  ///< [rad] by which M1 and M2 are turned

  [[nodiscard]] Vector2d poleP() const { return {-field.half_width, field.depth}; }
  [[nodiscard]] Vector2d poleQ() const { return {field.half_width, field.depth}; }
  [[nodiscard]] std::array<Vector2d, 3> things() const { return {poleP(), poleQ(), ball}; }
  [[nodiscard]] MovisCamera camera(std::size_t k) const { return *movisCamera(static_cast<int>(k) + 1, mount_radius); }
};

[[nodiscard]] MovisLattice readLattice(const Settings& settings);

/// What M1 and M2 measure at one point: slants [rad] of p, q and the ball, in the paper's robot frame.
struct MovisLook
{
  std::array<std::array<double, 2>, 3> slant{};  ///< [thing][camera]
};

/// A robot put down straight at `place`: true slants, minus the yaw of the camera, plus noise.
[[nodiscard]] MovisLook lookFrom(const MovisLattice& lattice, const Vector2d& place, RandomStream& random);

/// Eq 1-2: where the lines of both cameras meet [m, paper's robot frame]; nothing when they do not meet ahead.
[[nodiscard]] std::optional<Vector2d> meeting(const MovisLattice& lattice, const std::array<double, 2>& slant);

/// The azimuths of the poles as measurements in our frames (robot x forward).
[[nodiscard]] std::vector<PoseMeasurement> poleMeasurements(const MovisLattice& lattice, const MovisLook& look);

/// How far each camera is turned, from looks at the origin.
[[nodiscard]] std::array<double, 2> calibratedYaw(const MovisLattice& lattice, const std::vector<MovisLook>& at_origin);

/// The look with the cameras turned back by `yaw`.
[[nodiscard]] MovisLook straightened(MovisLook look, const std::array<double, 2>& yaw);
}  // namespace mrpt_ext::papers
