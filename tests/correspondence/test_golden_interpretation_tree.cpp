#include <set>

#include "golden_vectors.h"
#include "mrpt_ext/correspondence/tree/interpretation_tree.h"
#include "paper_interpretation_tree.h"

namespace mrpt_ext::test_golden_interpretation_tree
{
namespace
{
using golden::Json;

struct Case
{
  std::vector<Vector2d> landmarks;
  std::vector<AnonymousBearing> bearings;
  InterpretationOptions options;
};

Case readCase(const Json& in)
{
  Case c;
  c.landmarks = golden::points(in.at("landmarks"));
  for (const double b : golden::numbers(in.at("bearings"))) c.bearings.push_back({b, {}});
  c.options.max_residual = golden::number(in.at("eps"));
  c.options.max_unmatched = in.value("max_unmatched", 0);
  const std::vector<double> bounds = golden::numbers(in.at("bounds"));
  c.options.area = Box2{{bounds.at(0), bounds.at(1)}, {bounds.at(2), bounds.at(3)}};
  return c;
}

void checkSolutions(const Interpretations& result, const Json& c)
{
  const Json& expected = c.at("expect");
  const Json tol = c.value("tol", Json::object());
  ASSERT_TRUE(result.finished);
  std::set<std::vector<int>> found, wanted;
  for (const Interpretation& s : result.solutions) found.insert(s.assignment);
  for (const Json& s : expected.at("solutions")) wanted.insert(s.at("assignment").get<std::vector<int>>());
  EXPECT_EQ(found, wanted);
  EXPECT_EQ(result.solutions.size(), expected.at("count").get<std::size_t>());
  EXPECT_EQ(result.status == SolveStatus::ok, !wanted.empty());
  for (const Json& s : expected.at("solutions"))
    for (const Interpretation& mine : result.solutions)
    {
      if (mine.assignment != s.at("assignment").get<std::vector<int>>()) continue;
      golden::expectPoint(mine.pose.mean.position(), golden::point(s.at("pose")), tol.value("pose_abs", 1e-6));
      golden::expectAngle(mine.pose.mean.phi, golden::number(s.at("pose").at(2)), tol.value("heading_abs", 1e-7));
      EXPECT_NEAR(mine.max_residual, golden::number(s.at("max_abs_residual")), 1e-6);
    }
}

void checkPaperRule(const Case& c, const Json& expected, const Json& truth)
{
  const Interpretations result = interpretByPaperRule(c.landmarks, c.bearings, c.options);
  EXPECT_EQ(result.tested_by_depth, expected.at("tested_by_depth").get<std::vector<std::uint64_t>>());
  EXPECT_EQ(result.valid_by_depth, expected.at("valid_by_depth").get<std::vector<std::uint64_t>>());
  EXPECT_EQ(result.solutions.size(), expected.at("solutions").get<std::size_t>());
  if (!truth.is_object()) return;
  const std::vector<int> wanted = truth.at("assignment").get<std::vector<int>>();
  const bool found = std::any_of(result.solutions.begin(), result.solutions.end(),
                                 [&](const Interpretation& s) { return s.assignment == wanted; });
  EXPECT_EQ(found, expected.at("truth_found").get<bool>());
}

/// Bad input, or three bearings, which nothing can verify.
SolveStatus statusOfRefusal(const Json& expected)
{
  return expected.value("failure", false) ? SolveStatus::bad_input : SolveStatus::too_few;
}

void checkCase(const Json& json)
{
  const Json& expected = json.at("expect");
  const Case c = readCase(json.at("input"));
  const Interpretations result = interpretBearings(c.landmarks, c.bearings, c.options);
  if (expected.contains("solutions"))
    checkSolutions(result, json);
  else
    EXPECT_EQ(result.status, statusOfRefusal(expected));
  EXPECT_EQ(result.solutions.empty(), result.status != SolveStatus::ok);
  if (json.contains("paper_rule")) checkPaperRule(c, json.at("paper_rule"), json.value("truth", Json()));
}
}  // namespace

TEST(GoldenVectors, InterpretationTree)
{
  for (const Json& c : golden::load("it_search"))
  {
    SCOPED_TRACE(c.at("id").get<std::string>());
    checkCase(c);
  }
}
}  // namespace mrpt_ext::test_golden_interpretation_tree
