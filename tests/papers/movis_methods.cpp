#include "movis_methods.h"

#include <Eigen/Cholesky>

#include "mrpt_ext/solvers/object_position.h"
#include "mrpt_ext/solvers/omni_stereo.h"
#include "mrpt_ext/solvers/plane.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext::papers
{
namespace
{
const double kTold = degToRad(0.001);  // standard deviation of a heading that is told

PoseMeasurement toldHeading() { return {PoseMeasurement::Kind::heading, {0, 0}, headingFromSlope(0), kTold, {}}; }

Vector2d inField(const Pose2& robot, const Vector2d& ball_in_robot)
{
  return objectPosition({robot, Matrix3d::Zero()}, {robotFromMovis(ball_in_robot), Matrix2d::Zero()}).mean;
}

template <int N>
Eigen::Matrix<double, N, 1> drawn(const Eigen::Matrix<double, N, N>& covariance, RandomStream& random)
{
  Eigen::Matrix<double, N, 1> unit;
  for (int i = 0; i < N; ++i) unit[i] = random.gaussian();
  return covariance.llt().matrixL() * unit;
}
}  // namespace

std::optional<MovisAnswer> paperAnswer(const MovisLattice& lattice, const MovisLook& look,
                                       const OriginCorrection& correction)
{
  const auto p = meeting(lattice, look.slant[0]), q = meeting(lattice, look.slant[1]);
  const auto ball = meeting(lattice, look.slant[2]);
  if (!p || !q || !ball) return std::nullopt;
  const TwoPolePose pose =
      solveTwoPolePose(correctLeftPole(correction, *p), correctRightPole(correction, *q), lattice.field);
  if (pose.status != SolveStatus::ok) return std::nullopt;
  return MovisAnswer{pose.turned_q, pose.beta, *ball, rotation(pose.beta) * (*ball + pose.turned_q)};
}

OriginCorrection paperCorrection(const MovisLattice& lattice, const MovisLook& at_origin)
{
  const auto p = meeting(lattice, at_origin.slant[0]), q = meeting(lattice, at_origin.slant[1]);
  return p && q ? calibrateAtOrigin(*p, *q, lattice.field) : OriginCorrection{};
}

std::optional<MovisAnswer> likeliestAnswer(const MovisLattice& lattice, const MovisLook& look, bool heading_told)
{
  const auto p = meeting(lattice, look.slant[0]), q = meeting(lattice, look.slant[1]);
  const auto ball = meeting(lattice, look.slant[2]);
  if (!p || !q || !ball) return std::nullopt;
  std::vector<PoseMeasurement> measurements = poleMeasurements(lattice, look);
  if (heading_told) measurements.push_back(toldHeading());
  const PoseMl ml = refinePose(measurements, robotPose(solveTwoPolePose(*p, *q, lattice.field)));
  if (ml.status != SolveStatus::ok) return std::nullopt;
  const Pose2& robot = ml.pose.mean;
  return MovisAnswer{robot.position(), slopeFromHeading(robot.phi), *ball, inField(robot, *ball)};
}

MovisAnswer answerAtBound(const MovisLattice& lattice, const Vector2d& place, bool heading_told, RandomStream& random)
{
  MovisLattice straight = lattice;
  straight.yaw = {0, 0};
  straight.std_bearing = 0;
  MovisLook exact = lookFrom(straight, place, random);
  std::vector<PoseMeasurement> measurements = poleMeasurements(lattice, exact);
  if (heading_told) measurements.push_back(toldHeading());
  const Pose2 truth{place.x(), place.y(), headingFromSlope(0)};
  const auto bound = covarianceFromInformation(poseInformation(measurements, truth));
  if (!bound) return {};
  const Vector3d error = drawn<3>(*bound, random);
  const auto ray = [&](std::size_t k) {
    return SightRay{lattice.camera(k).position, exact.slant[2][k], lattice.std_bearing};
  };
  const GaussianPoint ball = triangulate(ray(0), ray(1)).point;
  const Vector2d seen = ball.mean + drawn<2>(ball.covariance, random);
  const Pose2 robot{truth.x + error.x(), truth.y + error.y(), truth.phi + error.z()};
  return {robot.position(), error.z(), seen, inField(robot, seen)};
}
}  // namespace mrpt_ext::papers
