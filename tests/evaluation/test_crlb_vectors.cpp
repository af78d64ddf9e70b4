#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "mrpt_ext/evaluation/information_bound.h"
#include "posterior_bounds.h"

namespace mrpt_ext::test_crlb_vectors
{
namespace
{
using Json = nlohmann::json;

Json readVectors()
{
  const char* folder = std::getenv("LANDMARK_VECTORS");
  const std::string path = (folder ? folder : MRPT_EXT_TEST_DATA "/vectors") + std::string("/crlb.json");
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": not readable, expected the test vectors");
  return Json::parse(file);
}

double number(const Json& json) { return json.get<double>(); }
Vector2d point(const Json& json) { return {number(json.at(0)), number(json.at(1))}; }
Pose2 pose(const Json& json) { return {number(json.at(0)), number(json.at(1)), number(json.at(2))}; }

Eigen::MatrixXd matrix(const Json& json)
{
  const auto n = static_cast<Eigen::Index>(json.size());
  Eigen::MatrixXd M(n, n);
  for (Eigen::Index r = 0; r < n; ++r)
    for (Eigen::Index c = 0; c < n; ++c) M(r, c) = json.at(r).at(c);
  return M;
}

/// One standard deviation for all, or one for each.
double entry(const Json& json, std::size_t index) { return number(json.is_array() ? json.at(index) : json); }

/// Relative to the scale of the entry: sqrt(|M_rr M_cc|).
void expectClose(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected, double relative)
{
  ASSERT_EQ(actual.rows(), expected.rows());
  for (Eigen::Index r = 0; r < expected.rows(); ++r)
    for (Eigen::Index c = 0; c < expected.cols(); ++c)
      EXPECT_NEAR(actual(r, c), expected(r, c), relative * std::sqrt(std::abs(expected(r, r) * expected(c, c))) + 1e-15)
          << "entry " << r << ", " << c;
}

Matrix3d bearings(const Json& in)
{
  Matrix3d information = Matrix3d::Zero();
  for (std::size_t i = 0; i < in.at("landmarks").size(); ++i)
    addInformation(information, bearingJacobian(pose(in.at("pose")), point(in.at("landmarks")[i])),
                   entry(in.at("sigma"), i));
  return information;
}

Eigen::MatrixXd ranges(const Json& in)
{
  Matrix3d information = Matrix3d::Zero();
  for (std::size_t i = 0; i < in.at("landmarks").size(); ++i)
    addInformation(information, rangeJacobian(pose(in.at("pose")), point(in.at("landmarks")[i])),
                   entry(in.at("sigma"), i));
  return information.topLeftCorner<2, 2>();
}

Matrix3d rangesAndBearings(const Json& in)
{
  Matrix3d information = Matrix3d::Zero();
  for (std::size_t i = 0; i < in.at("landmarks").size(); ++i)
  {
    addInformation(information, rangeJacobian(pose(in.at("pose")), point(in.at("landmarks")[i])),
                   entry(in.at("sigma_range"), i));
    addInformation(information, bearingJacobian(pose(in.at("pose")), point(in.at("landmarks")[i])),
                   entry(in.at("sigma_bearing"), i));
  }
  return information;
}

Matrix3d movisBearings(const Json& in)
{
  const double camera_angle_deg[] = {150, 30, -90};  // paper 001: x to the right, y forward
  Matrix3d information = Matrix3d::Zero();
  for (const int camera : in.at("cameras"))
  {
    const double angle = degToRad(camera_angle_deg[camera - 1]), radius = in.at("L");
    for (const Json& pole : in.at("poles"))
      addInformation(
          information,
          bearingJacobian(pose(in.at("pose")), point(pole), {radius * std::cos(angle), radius * std::sin(angle)}),
          in.at("sigma"));
  }
  return information;
}

/// Information of a running fix about its second position (x, y), heading known: the second range, and the first
/// with its variance enlarged by the displacement's along the line of sight, std^2 + u^T S u.
/// `displacement` and `displacement_covariance` in world axes.
Matrix2d runningFixInformation(const Vector2d& second_position, const Vector2d& displacement,
                               const Matrix2d& displacement_covariance, const Vector2d& landmark, double first_std,
                               double second_std)
{
  const Vector2d second = landmark - second_position, first = second + displacement;
  Matrix2d information = Matrix2d::Zero();
  if (second.norm() > 0)
  {
    const Vector2d u = second.normalized();
    information += u * u.transpose() / square(second_std);
  }
  if (first.norm() > 0)
  {
    const Vector2d u = first.normalized();
    information += u * u.transpose() / (square(first_std) + u.dot(displacement_covariance * u));
  }
  return information;
}

Matrix2d runningFix(const Json& in)
{
  return runningFixInformation(point(in.at("p2")), point(in.at("displacement_world")),
                               matrix(in.at("displacement_cov")), point(in.at("landmark")), in.at("sigma_r1"),
                               in.at("sigma_r2"));
}

void checkBound(const Json& test, const Eigen::MatrixXd& information)
{
  const Json& expect = test.at("expect");
  const double tolerance = test.contains("tol") ? test.at("tol").at("rel").get<double>() : 1e-9;
  expectClose(information, matrix(expect.at("fim")), tolerance);
  const auto bound = informationBound(information);
  if (expect.contains("status"))
  {
    ASSERT_EQ(expect.at("status"), "singular") << "unknown status";
    EXPECT_FALSE(bound);
    EXPECT_EQ(informationRank(information), expect.at("rank").get<int>());
    return;
  }
  ASSERT_TRUE(bound);
  expectClose(bound->covariance, matrix(expect.at("covariance")), tolerance);
  EXPECT_NEAR(bound->position_rms, expect.at("pos_rms"), tolerance * bound->position_rms);
}

void checkPosteriorBound(const Json& test)
{
  const Json &in = test.at("input"), &expect = test.at("expect");
  const std::string mode = in.at("mode");
  const auto has = [&](const char* kind) { return mode.find(kind) != std::string::npos; };
  Pose2 at = pose(in.at("start"));
  std::vector<BoundStep> steps;
  for (int k = 0; k < in.at("steps").get<int>(); ++k)
  {
    BoundStep step{pose(in.at("body_increment")), pose(in.at("odometry_sigma_body")).vector(), Matrix3d::Zero()};
    at = compose(at, step.increment);
    EXPECT_NEAR((at.position() - point(expect.at("states")[k + 1])).norm(), 0, 1e-9);
    const Vector2d landmark = point(in.at("landmarks")[k % 3]);
    if (has("bearing"))
      addInformation(step.measurement_information, bearingJacobian(at, landmark), in.at("sigma_bearing"));
    if (has("range")) addInformation(step.measurement_information, rangeJacobian(at, landmark), in.at("sigma_range"));
    steps.push_back(step);
  }
  const double tolerance = test.at("tol").at("rel");
  const auto bounds = testing::posteriorBounds(pose(in.at("start")), matrix(in.at("prior_cov")), steps);
  for (std::size_t k = 0; k < bounds.size(); ++k)
    expectClose(bounds[k].inverse(), matrix(expect.at("information")[k]), tolerance);
  expectClose(bounds.back(), matrix(expect.at("final_cov")), tolerance);
}

void check(const Json& test)
{
  const std::string op = test.at("op");
  const Json& in = test.at("input");
  if (op == "bearing")
    checkBound(test, bearings(in));
  else if (op == "range_position_only")
    checkBound(test, ranges(in));
  else if (op == "range_and_bearing")
    checkBound(test, rangesAndBearings(in));
  else if (op == "movis_two_cameras_two_poles")
    checkBound(test, movisBearings(in));
  else if (op == "running_fix_position")
    checkBound(test, runningFix(in));
  else if (op == "pcrlb_fixed_trajectory")
    checkPosteriorBound(test);
  else
    FAIL() << "unknown op " << op;
}
}  // namespace

TEST(CrlbVectors, AllCasesAgree)
{
  const Json vectors = readVectors();
  ASSERT_FALSE(vectors.at("cases").empty());
  for (const Json& test : vectors.at("cases"))
  {
    SCOPED_TRACE(test.at("id").get<std::string>());
    check(test);
  }
}
}  // namespace mrpt_ext::test_crlb_vectors
