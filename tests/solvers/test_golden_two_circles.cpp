#include "circle_relation_text.h"
#include "golden_vectors.h"

namespace mrpt_ext::test_golden_two_circles
{
TEST(GoldenVectors, TwoCircles)
{
  for (const golden::Json& c : golden::load("two_circles"))
  {
    SCOPED_TRACE(c.at("id").get<std::string>());
    const golden::Json &in = c.at("input"), &expected = c.at("expect");
    const TwoCircles result = intersectCircles({golden::point(in.at("c1")), golden::number(in.at("r1"))},
                                               {golden::point(in.at("c2")), golden::number(in.at("r2"))});
    EXPECT_EQ(toString(result.relation), expected.at("status").get<std::string>());
    const double tolerance = c.contains("tol") ? c.at("tol").at("point_abs").get<double>() : 1e-9;
    const std::vector<Vector2d> wanted =
        expected.contains("points") ? golden::points(expected.at("points")) : std::vector<Vector2d>{};
    golden::expectSamePoints({result.points.begin(), result.points.begin() + result.count}, wanted, tolerance);
    if (expected.contains("closest"))
      golden::expectPoint(result.closest, golden::point(expected.at("closest")), tolerance);
    if (expected.contains("gap"))
    {
      EXPECT_NEAR(result.gap, golden::number(expected.at("gap")), tolerance);
    }
    EXPECT_TRUE(result.points[0].allFinite() && result.points[1].allFinite() && result.closest.allFinite());
  }
}
}  // namespace mrpt_ext::test_golden_two_circles
