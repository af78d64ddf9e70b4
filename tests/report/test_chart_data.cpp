#include "mrpt_ext/report/chart_data.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "mrpt_ext/evaluation/run_scoring.h"
#include "synthetic_run.h"

namespace mrpt_ext::test_chart_data
{
using namespace testing;
using Json = nlohmann::ordered_json;

TEST(ConfidenceData, OfALongRunMergesNeighboursByTheirLowestValue)
{
  const RunContext context = syntheticContext(6 * 3600);
  const Json data = confidenceData(context, syntheticRecord(context));
  EXPECT_LE(data["t"].size(), 2400u);
  EXPECT_EQ(data["t"].size(), data["weight"].size());
  EXPECT_DOUBLE_EQ(data["weight"][0], 0.5);
}

TEST(ConfidenceData, WithoutAJudgedMethodIsNull) { EXPECT_TRUE(confidenceData({}, {}).is_null()); }

TEST(ConfidenceData, HasTheTimeSpansOfEachVerdict)
{
  RunContext context;
  context.start_time = 100;
  context.duration_s = 70;  // 0.1 s are resolved
  RunRecord record;
  record.methods.push_back({.name = "particle_filter", .continuous = true});
  const auto add = [&](double time, Verdict verdict)
  {
    PoseEstimate point;
    point.time = 100 + time;
    point.verdict = verdict;
    record.methods[0].points.push_back(point);
  };
  add(0, Verdict::ambiguous);
  add(1, Verdict::ambiguous);
  add(2, Verdict::ok);  // the span ends with the estimate that ends it
  add(20, Verdict::lost);
  add(20.04, Verdict::ok);
  add(20.08, Verdict::lost);
  add(20.5, Verdict::ok);
  add(69, Verdict::lost);
  const Json data = confidenceData(context, record);
  EXPECT_EQ(data["ambiguous"], Json::parse("[[0, 2]]"));
  EXPECT_EQ(data["lost"], (Json{{20, 20.5}, {69, 69.1}}));
}

TEST(NeesData, HasTheBandOfThreeDegreesOfFreedom)
{
  const RunContext context = syntheticContext();
  const Json data = neesData(context, scoreRun(context, syntheticRecord(context), {}));
  EXPECT_NEAR(data["low"], 0.2158, 1e-4);
  EXPECT_NEAR(data["high"], 9.3484, 1e-4);
  EXPECT_EQ(data["covariance"][0].size(), 6u);
}

TEST(BiasData, IsACurvePerBiasInTheOrderOfTheirNames)
{
  RunContext context;
  context.start_time = 100;
  RunRecord record;
  for (int i = 0; i < 5000; ++i)
    for (const char* name : {"stereo.range_scale", "bearing_offset_deg"})
      record.biases.push_back({100 + 0.1 * i, name, 0.001 * i, 0.5});
  const Json data = biasData(context, record);
  ASSERT_EQ(data.size(), 2u);
  EXPECT_EQ(data[0]["name"], "bearing_offset_deg");
  EXPECT_EQ(data[1]["name"], "stereo.range_scale");
  EXPECT_LE(data[0]["t"].size(), 2400u);
  EXPECT_DOUBLE_EQ(data[0]["t"][1], 0.3);
  EXPECT_DOUBLE_EQ(data[0]["mean"][1], 0.003);
  EXPECT_DOUBLE_EQ(data[0]["std"][1], 0.5);
}

TEST(GeometryData, HasAColumnPerMethodAndNoneForOracles)
{
  RunScore score;
  score.methods.resize(2);
  score.methods[1].oracle = true;
  const std::vector<ErrorsByGeometry> tables{
      {"landmarks in view", {{"1", 9, {{3, 0.5, 0.25, 0.75}, {}}}, {"2", 4, {{}, {}}}}}};
  const Json data = geometryData(tables, score);
  ASSERT_EQ(data.size(), 1u);
  EXPECT_EQ(data[0]["classes"], (Json{"1", "2"}));
  EXPECT_EQ(data[0]["median"], (Json{{0.25, nullptr}, nullptr}));
  EXPECT_EQ(data[0]["p95"], (Json{{0.75, nullptr}, nullptr}));
}

TEST(ResidualData, ListsLandmarksWithResidualsByNumber)
{
  RunScore score;
  score.landmarks["10"] = {5, 5, 0.95, 0.2, 0.9};
  score.landmarks["2"] = {5, 5, 0.95, 1.5, 0.9};
  score.landmarks["3"] = {0, 0, {}, {}, {}};
  const Json data = residualData(score);
  EXPECT_EQ(data["ids"], (Json{"2", "10"}));
  EXPECT_EQ(data["warning"], (Json{"biased", ""}));
  EXPECT_TRUE(residualData(RunScore{}).is_null());
}
}  // namespace mrpt_ext::test_chart_data
