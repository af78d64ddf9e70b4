#include "mrpt_ext/report/svg_shapes.h"

#include <gtest/gtest.h>

#include "mrpt_ext/report/map_view.h"
#include "mrpt_ext/report/svg_chart.h"

namespace mrpt_ext
{
TEST(NiceStep, IsOneTwoOrFive)
{
  EXPECT_NEAR(niceStep(0.034), 0.02, 1e-12);
  EXPECT_NEAR(niceStep(1), 1, 1e-12);
  EXPECT_NEAR(niceStep(7.7), 5, 1e-12);
  EXPECT_NEAR(niceStep(1000), 1000, 1e-9);
  EXPECT_EQ(niceText(0.04, 0.02), "0.04");
  EXPECT_EQ(niceText(40, 20), "40");
}

TEST(ThinnedCurve, KeepsTheOutliers)
{
  SvgPoints points;
  for (int i = 0; i < 10000; ++i) points.emplace_back(i, i == 4321 ? 9 : i == 1234 ? -7 : 0);
  const SvgPoints thin = thinnedCurve(points, 200);
  EXPECT_LE(thin.size(), 200u);
  EXPECT_NE(std::find(thin.begin(), thin.end(), Vector2d(4321, 9)), thin.end());
  EXPECT_NE(std::find(thin.begin(), thin.end(), Vector2d(1234, -7)), thin.end());
  for (std::size_t i = 1; i < thin.size(); ++i) EXPECT_LT(thin[i - 1].x(), thin[i].x());
}

TEST(ThinnedByDistance, KeepsBothEnds)
{
  SvgPoints points;
  for (int i = 0; i <= 100; ++i) points.emplace_back(0.1 * i, 0);
  const SvgPoints thin = thinnedByDistance(points, 1.05);
  EXPECT_EQ(thin.front().x(), 0);
  EXPECT_EQ(thin.back().x(), 10);
  EXPECT_LT(thin.size(), 12u);
  EXPECT_TRUE(thinnedByDistance({}, 1).empty());
}

TEST(MapView, KeepsTheShapeAndPointsUpwards)
{
  const MapView view({0, 0}, {10, 5});
  const Vector2d low = view.draw({0, 0}), high = view.draw({10, 5});
  EXPECT_LT(low.x(), high.x());
  EXPECT_GT(low.y(), high.y());
  EXPECT_NEAR((high.x() - low.x()) / (low.y() - high.y()), 2, 1e-9);
  EXPECT_TRUE(view.contains(low) && view.contains(high));
  EXPECT_FALSE(view.contains(view.draw({20, 0})));
}

TEST(MapView, OfNothingOrOnePointIsFinite)
{
  EXPECT_TRUE(viewOf(RunContext{}, nullptr).draw({0, 0}).allFinite());
  EXPECT_GT(MapView({3, 3}, {3, 3}).scale(), 0);
}

TEST(SvgChart, IsLogarithmicOnlyWhenTheValuesSpanFar)
{
  Chart chart;
  chart.duration = 10;
  chart.unit = "m";
  chart.series = {{"filter", false, {{0, 0.5}, {1, 1.0}, {2, 0.7}}}};
  EXPECT_EQ(svgChart(chart).find("logarithmic"), std::string::npos);
  chart.series.front().points.emplace_back(3, 100);
  EXPECT_NE(svgChart(chart).find("logarithmic"), std::string::npos);
}

TEST(SvgChart, CurvesAreInterruptedByGaps)
{
  Chart chart;
  chart.duration = 100;
  chart.break_after = 2.5;
  chart.series = {{"filter", false, {{0, 1}, {1, 1}, {2, 1}, {50, 1}, {51, 1}}}};
  const std::string svg = svgChart(chart);
  std::size_t lines = 0;
  for (std::size_t at = svg.find("line filter"); at != std::string::npos; at = svg.find("line filter", at + 1)) ++lines;
  EXPECT_EQ(lines, 2u);
}
}  // namespace mrpt_ext
