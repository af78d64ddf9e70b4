#include "movis_yaw_scan.h"
#include "mrpt_ext/solvers/camera_yaw_calibration.h"
#include "mrpt_ext/solvers/movis_frame.h"
#include "mrpt_ext/solvers/omni_stereo.h"
#include "mrpt_ext/solvers/origin_correction.h"
#include "mrpt_ext/solvers/plane.h"
#include "mrpt_ext/solvers/two_pole_pose.h"
#include "printed_formulas.h"
#include "proof.h"

namespace mrpt_ext::papers
{
namespace
{
const PoleField kField{250, 400};  // [cm]
constexpr double kMount = 15;      // [cm]

/// Exact poles from a robot anywhere on the half field.
struct Example
{
  Vector2d robot{0, 0};
  double beta = 0;
  Vector2d p{0, 0}, q{0, 0};  ///< in the robot frame

  Example(RandomStream& random, double max_beta)
      : robot(random.uniform(-200, 200), random.uniform(0, 200)), beta(random.uniform(-max_beta, max_beta))
  {
    p = seen({-kField.half_width, kField.depth});
    q = seen({kField.half_width, kField.depth});
  }
  [[nodiscard]] Vector2d seen(const Vector2d& world) const { return rotation(-beta) * (world - robot); }
  [[nodiscard]] TwoPolePose solved() const { return solveTwoPolePose(p, q, kField); }
};

/// Eq 1-2 with M1 on the left front, or, as one may read it, on the right.
Erratum sidesOfTheCameras()
{
  Proof proof;
  RandomStream random(1);
  for (int k = 0; k < kExamples; ++k)
  {
    const Vector2d target(random.uniform(-250, 250), random.uniform(100, 400));
    const auto slant = [&](int camera) { return angleOf(target - movisCamera(camera, kMount)->position); };
    proof.add((printed::triangulated(slant(2), slant(1), kMount) - target).norm(),
              (printed::triangulated(slant(1), slant(2), kMount) - target).norm());
  }
  return proof.erratum("001, eq 1-2", "M1 and M2 without sides; M1 read as the right one",
                       "M1 is the left front camera", "point [cm]");
}

Erratum tangents()
{
  Proof proof;
  for (int k = 0; k < kExamples; ++k)
  {
    // Straight ahead of the left camera, where the tangent has no value.
    const MovisCamera left = *movisCamera(1, kMount), right = *movisCamera(2, kMount);
    const Vector2d target = left.position + Vector2d(0, 100 + k);
    const double left_slant = kPi / 2, right_slant = angleOf(target - right.position);
    const double lost = std::abs(std::tan(left_slant)) > 1e15 ? 1 : 0;
    const Triangulation met = triangulate({left.position, left_slant, 0}, {right.position, right_slant, 0});
    proof.add(lost, (met.point.mean - target).norm());
  }
  return proof.erratum("001, eq 1-2, slant of 90 deg", "tangents", "rays cut by cross products",
                       "share without a finite tangent; point by rays [cm]");
}

Erratum equationFive()
{
  Proof proof;
  RandomStream random(2);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, kPi);
    if (std::abs(e.beta) < kPi / 2) continue;
    proof.add(radToDeg(std::abs(wrap(printed::slope(e.p, e.q) - e.beta))),
              radToDeg(std::abs(wrap(e.solved().beta - e.beta))));
  }
  return proof.erratum("001, eq 5", "tan^-1", "atan2", "slope beyond 90 deg [deg]");
}

Erratum equationsSixAndSeven()
{
  Proof proof;
  RandomStream random(3);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, 0);
    const Vector2d printed = printed::turnedPosition(e.p, e.beta, kField.half_width, kField.depth);
    proof.add((printed - e.robot).norm(), (e.solved().turned_q - e.robot).norm());
  }
  return proof.erratum("001, eq 6-7", "coordinates of p with the signs of q", "q, or p with -Fw",
                       "position at beta = 0: 2 Fw [cm]");
}

Erratum absoluteCoordinates()
{
  Proof proof;
  RandomStream random(4);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, degToRad(11.8));
    proof.add((e.solved().turned_q - e.robot).norm(), (e.solved().world_q - e.robot).norm());
  }
  return proof.erratum("001, sec 3.2", "(X_r, Y_r) are absolute coordinates", "Rot(beta) (X_r, Y_r) are",
                       "position, beta of at most 11.8 deg [cm]");
}

Erratum sidesOfThePoles()
{
  Proof proof;
  RandomStream random(5);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, 1);
    const double swapped = solveTwoPolePose(e.q, e.p, kField).beta;
    proof.add(radToDeg(std::abs(wrap(swapped - e.beta))), radToDeg(std::abs(wrap(e.solved().beta - e.beta))));
  }
  return proof.erratum("001, sec 3.3", "right and left pole p and q", "p is the left, q the right one (eq 3, 4, 8)",
                       "slope [deg]");
}

/// Cameras turned against each other by 0.4 deg: what eq 8 leaves of it, and what the calibration of the angles does.
Erratum equationEight()
{
  Proof proof;
  RandomStream random(6);
  const std::array<double, 2> turned{degToRad(0.2), degToRad(-0.2)};
  const auto slantsFrom = [&](const Vector2d& robot, const Vector2d& thing, const std::array<double, 2>& less)
  {
    std::array<SightRay, 2> rays;
    for (std::size_t k = 0; k < 2; ++k)
    {
      const Vector2d mount = movisCamera(static_cast<int>(k) + 1, kMount)->position;
      rays[k] = {mount, angleOf(thing - robot - mount) - turned[k] + less[k], 0};
    }
    return triangulate(rays[0], rays[1]).point.mean;
  };
  const Vector2d p(-kField.half_width, kField.depth), q(kField.half_width, kField.depth);
  const OriginCorrection eq_8 = calibrateAtOrigin(slantsFrom({0, 0}, p, {}), slantsFrom({0, 0}, q, {}), kField);
  std::array<double, 2> found{};
  for (std::size_t k = 0; k < 2; ++k)
  {
    const Vector2d mount = robotFromMovis(movisCamera(static_cast<int>(k) + 1, kMount)->position);
    std::vector<CalibrationSighting> sightings;
    for (const Vector2d& pole : {p, q})
      sightings.push_back({{0, 0, headingFromSlope(0)},
                           pole,
                           forwardBearingFromSlant(angleOf(pole - movisFromRobot(mount)) - turned[k])});
    found[k] = -calibrateCameraYaw(sightings, {mount.x(), mount.y(), 0}).offset;
  }
  for (int k = 0; k < kExamples; ++k)
  {
    const Vector2d robot(random.uniform(-200, 200), random.uniform(0, 200));
    const TwoPolePose scaled = solveTwoPolePose(correctLeftPole(eq_8, slantsFrom(robot, p, {})),
                                                correctRightPole(eq_8, slantsFrom(robot, q, {})), kField);
    const TwoPolePose straight = solveTwoPolePose(slantsFrom(robot, p, found), slantsFrom(robot, q, found), kField);
    proof.add((scaled.world_q - robot).norm(), (straight.world_q - robot).norm());
  }
  return proof.erratum("001, eq 8", "factors per axis against systematic errors",
                       "the angles of the cameras, taken off",
                       "position, cameras turned by 0.2 deg each, no noise [cm]");
}

Erratum improvement()
{
  Proof proof;
  const double lower = 1 - PrintedLattice::kMeanAfter / PrintedLattice::kMeanBefore;
  proof.add(100 * (0.5 - lower), std::abs(std::round(1000 * lower) - 236));
  return proof.erratum("001, sec 4", "accuracy higher by about 50 %", "23.6 % lower mean D, by its tables 2 and 3",
                       "improvement [percentage points]");
}

Erratum tableFour()
{
  Proof proof;
  RandomStream random(7);
  const Vector2d ball(0, 300);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, degToRad(11.8));
    const Vector2d position = e.solved().turned_q, seen = e.seen(ball);
    proof.add((seen + position - ball).norm(), (rotation(e.solved().beta) * (seen + position) - ball).norm());
  }
  return proof.erratum("001, table 4", "the robot stood parallel, so the object is the sum of tables 1 and 3",
                       "the sum turned by beta (eq 9-10)", "object, beta of at most 11.8 deg [cm]");
}
}  // namespace

std::vector<Erratum> errataOfPaper001()
{
  return {sidesOfTheCameras(),
          tangents(),
          equationFive(),
          equationsSixAndSeven(),
          absoluteCoordinates(),
          sidesOfThePoles(),
          equationEight(),
          improvement(),
          tableFour()};
}
}  // namespace mrpt_ext::papers
