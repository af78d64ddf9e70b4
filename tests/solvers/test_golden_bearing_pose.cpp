#include "bearing_pose_gls.h"
#include "golden_vectors.h"
#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "mrpt_ext/solvers/bearing_pose_ml.h"

namespace mrpt_ext::test_golden_bearing_pose
{
namespace
{
using golden::Json;

/// Our status for a name of the vectors; lists of different length are refused by pairBearings before.
SolveStatus statusNamed(const std::string& name)
{
  if (name == "ok") return SolveStatus::ok;
  if (name == "behind") return SolveStatus::behind;
  if (name == "too_few") return SolveStatus::too_few;
  if (name == "singular" || name == "duplicate_landmark") return SolveStatus::degenerate;
  if (name == "not_finite") return SolveStatus::bad_input;
  ADD_FAILURE() << "unknown status " << name;
  return SolveStatus::none;
}

/// Nothing when the lists differ in length.
std::optional<std::vector<KnownBearing>> pairBearings(const std::vector<Vector2d>& landmarks,
                                                      const std::vector<double>& bearings)
{
  if (landmarks.size() != bearings.size()) return std::nullopt;
  std::vector<KnownBearing> pairs;
  for (std::size_t i = 0; i < landmarks.size(); ++i) pairs.push_back({landmarks[i], bearings[i]});
  return pairs;
}

void expectNumbers(const std::vector<double>& actual, const std::vector<double>& expected, double tolerance)
{
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], tolerance);
}

void checkClosedForm(const std::vector<KnownBearing>& bearings, const Json& expected, double tolerance)
{
  const BearingPoseLinear linear = solveBearingPoseLinear(bearings);
  EXPECT_EQ(linear.status, statusNamed(expected.at("status").get<std::string>()));
  if (expected.contains("det_ratio"))
  {
    EXPECT_NEAR(linear.det_ratio, golden::number(expected.at("det_ratio")), std::max(tolerance, 1e-10));
  }
  if (expected.contains("f")) golden::expectPoint(linear.f, golden::point(expected.at("f")), tolerance);
  if (expected.contains("r"))
  {
    const std::vector<double> wanted = golden::numbers(expected.at("r"));
    ASSERT_EQ(linear.r.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_NEAR(linear.r[i], wanted[i], tolerance * std::max(1.0, std::abs(wanted[i])));
  }
  if (linear.status != SolveStatus::ok)
  {
    EXPECT_EQ(linear.pose.vector(), Vector3d::Zero()) << "a failed solve must not return a pose";
    EXPECT_TRUE(linear.residuals.empty());
    return;
  }
  golden::expectPoint(linear.pose.position(), {golden::number(expected.at("x")), golden::number(expected.at("y"))},
                      tolerance);
  golden::expectAngle(linear.pose.phi, golden::number(expected.at("th")), tolerance);
  golden::expectAngle(linear.mean_phi, golden::number(expected.at("th_mean")), tolerance);
  expectNumbers(linear.residuals, golden::numbers(expected.at("residuals")), tolerance);
}

void checkMaximumLikelihood(const std::vector<KnownBearing>& bearings, const Json& expected, double tolerance)
{
  const PoseMl ml = solveBearingPoseMl(bearings);
  ASSERT_EQ(ml.status, SolveStatus::ok);
  golden::expectPoint(ml.pose.mean.position(), {golden::number(expected.at("x")), golden::number(expected.at("y"))},
                      tolerance);
  golden::expectAngle(ml.pose.mean.phi, golden::number(expected.at("th")), tolerance);
  const double cost = golden::number(expected.at("cost"));
  EXPECT_NEAR(ml.chi2, cost, 1e-6 * cost + 1e-16);
}
}  // namespace

TEST(GoldenVectors, BearingPose)
{
  for (const Json& c : golden::load("bearing_pose_ls"))
  {
    SCOPED_TRACE(c.at("id").get<std::string>());
    const Json &in = c.at("input"), &expected = c.at("expect");
    const auto bearings = pairBearings(golden::points(in.at("landmarks")), golden::numbers(in.at("bearings")));
    const std::string status = expected.at("closed_form").at("status").get<std::string>();
    EXPECT_EQ(!bearings, status == "size_mismatch");
    if (!bearings) continue;
    const Json tol = c.value("tol", Json::object());
    checkClosedForm(*bearings, expected.at("closed_form"), tol.value("closed_form_abs", 1e-8));
    if (expected.contains("ml_equal_sigma"))
      checkMaximumLikelihood(*bearings, expected.at("ml_equal_sigma"), tol.value("ml_abs", 1e-6));
    if (status != "ok" && status != "duplicate_landmark")
    {
      EXPECT_NE(solveBearingPoseGls(*bearings).status, SolveStatus::ok);
      EXPECT_NE(solveBearingPoseMl(*bearings).status, SolveStatus::ok);
    }
    if (c.at("kind") == "exact")
    {
      const Vector2d truth = golden::point(c.at("truth"));
      golden::expectPoint(solveBearingPoseGls(*bearings).pose.position(), truth, 1e-5);
      golden::expectPoint(solveBearingPoseMl(*bearings).pose.mean.position(), truth, 1e-5);
    }
  }
}
}  // namespace mrpt_ext::test_golden_bearing_pose
