#include "golden_vectors.h"
#include "mrpt_ext/solvers/movis_frame.h"
#include "mrpt_ext/solvers/object_position.h"
#include "mrpt_ext/solvers/omni_stereo.h"
#include "mrpt_ext/solvers/origin_correction.h"
#include "mrpt_ext/solvers/two_pole_pose.h"

namespace mrpt_ext::test_golden_movis
{
namespace
{
using golden::Json;

/// Our status for a name of the vectors.
SolveStatus statusNamed(const std::string& name)
{
  if (name == "ok") return SolveStatus::ok;
  if (name == "behind") return SolveStatus::behind;
  if (name == "parallel" || name == "coincident_poles" || name == "singular") return SolveStatus::degenerate;
  if (name == "not_finite") return SolveStatus::bad_input;
  ADD_FAILURE() << "unknown status " << name;
  return SolveStatus::none;
}

double tolerance(const Json& c, double size)
{
  if (!c.contains("tol")) return 1e-9 * size;
  const Json& tol = c.at("tol");
  return tol.contains("abs") ? tol.at("abs").get<double>() : tol.at("rel").get<double>() * size;
}

PoleField fieldOf(const Json& in) { return {golden::number(in.at("Fw")), golden::number(in.at("Fd"))}; }

void checkTriangulation(const Json& c)
{
  const Json &in = c.at("input"), &expected = c.at("expect");
  const double L = golden::number(in.at("L"));
  const auto cam_i = movisCamera(in.at("cam_i").get<int>(), L), cam_j = movisCamera(in.at("cam_j").get<int>(), L);
  ASSERT_TRUE(cam_i && cam_j);
  const Triangulation result =
      triangulate({cam_i->position, cam_i->slantFromTheta(golden::number(in.at("theta_i"))), 0.01},
                  {cam_j->position, cam_j->slantFromTheta(golden::number(in.at("theta_j"))), 0.01});
  EXPECT_EQ(result.status, statusNamed(expected.at("status").get<std::string>()));
  EXPECT_TRUE(result.point.mean.allFinite() && result.point.covariance.allFinite());
  if (result.status != SolveStatus::ok) return;
  const Vector2d wanted(golden::number(expected.at("x")), golden::number(expected.at("y")));
  golden::expectPoint(result.point.mean, wanted, tolerance(c, std::max(1.0, wanted.norm())));
}

void checkPolePose(const Json& c)
{
  const Json &in = c.at("input"), &expected = c.at("expect");
  const TwoPolePose pose = solveTwoPolePose(golden::point(in.at("p")), golden::point(in.at("q")), fieldOf(in));
  ASSERT_EQ(pose.status, statusNamed(expected.at("status").get<std::string>()));
  if (pose.status != SolveStatus::ok) return;
  const double tol = tolerance(c, 1000);
  golden::expectAngle(pose.beta, golden::number(expected.at("beta")), tol);
  golden::expectPoint(pose.turned_q, golden::point(expected.at("Xr_paper_frame")), tol);
  golden::expectPoint(pose.turned_p, golden::point(expected.at("Xr_paper_frame_from_p")), tol);
  golden::expectPoint(pose.world_q, golden::point(expected.at("world_from_q")), tol);
  golden::expectPoint(pose.world_p, golden::point(expected.at("world_from_p")), tol);
}

void checkScaledPoseAndObject(const Json& c)
{
  const Json &in = c.at("input"), &expected = c.at("expect");
  const SolveStatus wanted = statusNamed(expected.at("status").get<std::string>());
  const PoleField field = fieldOf(in);
  const OriginCorrection correction =
      calibrateAtOrigin(golden::point(in.at("p_at_origin")), golden::point(in.at("q_at_origin")), field);
  ASSERT_EQ(correction.status, wanted);
  if (wanted != SolveStatus::ok) return;
  const double tol = tolerance(c, 1000);
  const Vector2d p = correctLeftPole(correction, golden::point(in.at("p")));
  const Vector2d q = correctRightPole(correction, golden::point(in.at("q")));
  golden::expectPoint(p, golden::point(expected.at("p")), tol);
  golden::expectPoint(q, golden::point(expected.at("q")), tol);
  const TwoPolePose pose = solveTwoPolePose(p, q, field);
  ASSERT_EQ(pose.status, SolveStatus::ok);
  golden::expectAngle(pose.beta, golden::number(expected.at("beta")), tol);
  golden::expectPoint(pose.turned_q, golden::point(expected.at("Xr_paper_frame")), tol);
  golden::expectPoint(pose.world_q, golden::point(expected.at("world")), tol);
  const GaussianPose robot{{pose.world_q.x(), pose.world_q.y(), headingFromSlope(pose.beta)}, Matrix3d::Zero()};
  const GaussianPoint seen{robotFromMovis(golden::point(in.at("object_robot"))), Matrix2d::Zero()};
  golden::expectPoint(objectPosition(robot, seen).mean, golden::point(expected.at("object_world")), tol);
}
}  // namespace

TEST(GoldenVectors, Movis)
{
  for (const Json& c : golden::load("movis"))
  {
    SCOPED_TRACE(c.at("id").get<std::string>());
    const std::string op = c.at("op").get<std::string>();
    if (op == "triangulate")
      checkTriangulation(c);
    else if (op == "pose_from_poles")
      checkPolePose(c);
    else if (op == "scale_then_pose_then_object")
      checkScaledPoseAndObject(c);
    else
      ADD_FAILURE() << "unknown op " << op;
  }
}
}  // namespace mrpt_ext::test_golden_movis
