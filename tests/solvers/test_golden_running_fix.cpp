#include "circle_relation_text.h"
#include "golden_vectors.h"
#include "mrpt_ext/solvers/heading_from_landmark.h"
#include "mrpt_ext/solvers/landmark_in_robot_frame.h"
#include "mrpt_ext/solvers/pose_ring.h"
#include "mrpt_ext/solvers/running_fix.h"

namespace mrpt_ext::test_golden_running_fix
{
namespace
{
using golden::Json;

double tolerance(const Json& c) { return c.contains("tol") ? c.at("tol").at("abs").get<double>() : 1e-9; }

void checkRunningFix(const Json& c)
{
  const Json &in = c.at("input"), &expected = c.at("expect");
  const Vector2d landmark = golden::point(in.at("landmark"));
  const RunningFix fix = runningFix({landmark, golden::point(in.at("displacement_world")), golden::number(in.at("r1")),
                                     golden::number(in.at("r2")), 0.1, 0.1});
  EXPECT_EQ(toString(fix.relation), expected.at("status").get<std::string>());
  const Json& wanted = expected.at("candidates");
  ASSERT_EQ(fix.intersects ? fix.candidates.size() : 0, wanted.size());
  std::vector<bool> taken(wanted.size(), false);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    std::size_t best = 0;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < wanted.size(); ++k)
      if (const double d = (golden::point(wanted[k].at("p2")) - fix.candidates[i].second.mean).norm();
          !taken[k] && d < distance)
      {
        distance = d;
        best = k;
      }
    taken[best] = true;
    golden::expectPoint(fix.candidates[i].second.mean, golden::point(wanted[best].at("p2")), tolerance(c));
    golden::expectPoint(fix.candidates[i].first, golden::point(wanted[best].at("p1")), tolerance(c));
    const auto heading = headingFromBearing(landmark, fix.candidates[i].second.mean, golden::number(in.at("bearing2")));
    ASSERT_TRUE(heading);
    golden::expectAngle(*heading, golden::number(wanted[best].at("th2")), tolerance(c));
  }
  if (!expected.contains("closest")) return;
  ASSERT_EQ(fix.candidates.size(), 1u);
  golden::expectPoint(fix.candidates[0].second.mean, golden::point(expected.at("closest")), tolerance(c));
  EXPECT_NEAR(fix.gap, golden::number(expected.at("gap")), tolerance(c));
}

void checkLandmarkInRobotFrame(const Json& c)
{
  const Json &in = c.at("input"), &expected = c.at("expect");
  const LandmarkInRobotFrame result = landmarkInRobotFrame(golden::point(in.at("displacement_robot")),
                                                           golden::number(in.at("r1")), golden::number(in.at("r2")));
  EXPECT_EQ(toString(result.relation), expected.at("status").get<std::string>());
  const std::vector<Vector2d> wanted =
      expected.contains("landmark_robot") ? golden::points(expected.at("landmark_robot")) : std::vector<Vector2d>{};
  golden::expectSamePoints({result.candidates.begin(), result.candidates.begin() + result.count}, wanted, tolerance(c));
}

void checkRing(const Json& c)
{
  const Json& in = c.at("input");
  const PoseRing ring = makePoseRing(golden::point(in.at("landmark")), golden::number(in.at("r2")), 0.1,
                                     golden::number(in.at("bearing2")), 0.01);
  const std::vector<double> headings = golden::numbers(in.at("headings"));
  const std::vector<Vector2d> wanted = golden::points(c.at("expect").at("p2"));
  ASSERT_EQ(headings.size(), wanted.size());
  for (std::size_t i = 0; i < headings.size(); ++i)
  {
    const Pose2 pose = poseOnRing(ring, headings[i]);
    golden::expectPoint(pose.position(), wanted[i], tolerance(c));
    golden::expectAngle(pose.phi, headings[i], 1e-12);
  }
}

void checkOrientation(const Json& c)
{
  const Json& in = c.at("input");
  const auto heading = headingFromLandmark(golden::point(in.at("landmark")), golden::point(in.at("position")),
                                           golden::point(in.at("landmark_robot")));
  ASSERT_TRUE(heading);
  golden::expectAngle(*heading, golden::number(c.at("expect").at("th")), tolerance(c));
}
}  // namespace

TEST(GoldenVectors, RunningFix)
{
  for (const Json& c : golden::load("running_fix"))
  {
    SCOPED_TRACE(c.at("id").get<std::string>());
    const std::string op = c.at("op").get<std::string>();
    if (op == "running_fix")
      checkRunningFix(c);
    else if (op == "landmark_in_robot_frame")
      checkLandmarkInRobotFrame(c);
    else if (op == "ring")
      checkRing(c);
    else if (op == "orientation")
      checkOrientation(c);
    else
      ADD_FAILURE() << "unknown op " << op;
  }
}
}  // namespace mrpt_ext::test_golden_running_fix
