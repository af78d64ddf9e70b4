#include "mrpt_ext/report/summary_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "mrpt_ext/evaluation/run_merge.h"
#include "mrpt_ext/evaluation/run_scoring.h"
#include "summary_schema.h"
#include "synthetic_run.h"

namespace mrpt_ext::test_summary_json
{
using namespace testing;
using Json = nlohmann::ordered_json;

namespace
{
Json summaryOf(const RunContext& context, const RunRecord& record)
{
  return Json::parse(summaryJson(context, scoreRun(context, record, {})));
}

const SummaryKeys kStatistics{"rmse", "mean", "median", "std", "min", "max", "p95"};
}  // namespace

TEST(SummaryJson, HasEveryKeyOfTheContractInItsOrder)
{
  const RunContext context = syntheticContext();
  const Json json = summaryOf(context, syntheticRecord(context));
  expectSchema1(json);
  EXPECT_EQ(json["verdict_spells"].size(), 4u);
  EXPECT_EQ(json["landmarks"].count("3"), 1u);
  EXPECT_EQ(json["observations"].count("CObservationImage"), 1u);
  EXPECT_FALSE(json["filter"]["modes_at_end"].empty());
}

TEST(SummaryJson, HoldsTheNumbers)
{
  const RunContext context = syntheticContext();
  const Json json = summaryOf(context, syntheticRecord(context));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["trials"], 1);
  EXPECT_EQ(json["success_rate"], 1.0);
  EXPECT_EQ(json["trials_detail"][0]["seed"], 1000);
  EXPECT_EQ(json["trials_detail"][0]["success"], true);
  EXPECT_EQ(json["filter"]["converged_at_s"], 8.0);
  EXPECT_EQ(json["filter"]["particles"]["median"], 900);
  EXPECT_TRUE(json["filter"]["particles"]["median"].is_number_integer());
  EXPECT_EQ(json["filter"]["reseeds"], 2);
  EXPECT_EQ(json["filter"]["late_estimates"], 5);
  EXPECT_EQ(json["filter"]["most_steps_late"], 3);
  EXPECT_EQ(json["verdict"], "ok");
  ASSERT_EQ(json["verdict_spells"].size(), 4u);
  EXPECT_EQ(json["verdict_spells"][2]["verdict"], "lost");
  EXPECT_EQ(json["verdict_spells"][2]["from_s"], 70.5);
  EXPECT_EQ(json["verdict_spells"][2]["to_s"], 73.5);
  EXPECT_EQ(json["verdict_spells"][2]["reason"], "inlier ratio only 30 %");
  EXPECT_NEAR(json["verdict_shares"]["lost"], 7 / 241., 1e-9);
  EXPECT_EQ(json["inputs"]["map"], std::string(64, 'b'));
  EXPECT_TRUE(json["inputs"]["truth"].is_null());
  EXPECT_EQ(json["time_per_step_ms"], json["methods"]["particle_filter"]["time_per_step_ms"]);
  EXPECT_LE(json["time_per_step_ms"]["p99"], json["time_per_step_ms"]["max"]);
  EXPECT_LT(json["methods"]["particle_filter"]["position_error_m"]["rmse"], 0.2);
  EXPECT_GT(json["methods"]["particle_filter"]["position_error_whole_run_m"]["max"], 1.0);
  EXPECT_NEAR(json["cost"]["realtime_factor"].get<double>(), 120 / 1.7, 1e-9);
}

TEST(SummaryJson, WhatDoesNotExistIsNullNeverZero)
{
  RunContext context = syntheticContext(10);
  context.truth.clear();
  context.rawlog_sha256.clear();
  RunRecord record;
  record.methods.push_back({"running_fix"});
  record.landmarks["4"] = {};  // never seen
  const Json json = summaryOf(context, record);
  EXPECT_TRUE(json["success_rate"].is_null());
  EXPECT_TRUE(json["rawlog"]["sha256"].is_null());
  for (const char* key : {"success", "rmse", "converged_at_s"}) EXPECT_TRUE(json["trials_detail"][0][key].is_null());
  const Json& method = json["methods"]["running_fix"];
  EXPECT_EQ(method["estimates"], 0);
  EXPECT_TRUE(method["availability"].is_null());
  for (const char* error : {"position_error_m", "heading_error_deg", "position_error_whole_run_m"})
    for (const std::string& figure : kStatistics) EXPECT_TRUE(method[error][figure].is_null()) << error << figure;
  EXPECT_TRUE(method["time_per_step_ms"]["median"].is_null());
  EXPECT_TRUE(json["verdict_shares"]["ok"].is_null());
  for (const char* key : {"coverage_95", "effective_sample_ratio_min", "converged_at_s", "lost_steps", "reseeds",
                          "late_estimates", "most_steps_late", "modes_at_end"})
    EXPECT_TRUE(json["filter"][key].is_null()) << key;
  EXPECT_TRUE(json["filter"]["particles"]["min"].is_null());
  EXPECT_TRUE(json["filter"]["nees"]["mean"].is_null());
  EXPECT_TRUE(json["landmarks"]["4"]["inlier_rate"].is_null());
  EXPECT_TRUE(json["limit"]["pcrlb_position_rmse_m"].is_null());
  EXPECT_TRUE(json["cost"]["realtime_factor"].is_null());
}

TEST(SummaryJson, OfSeveralTrialsListsThem)
{
  const RunContext context = syntheticContext(30);
  std::vector<RunScore> scores;
  for (int trial = 0; trial < 3; ++trial) scores.push_back(scoreRun(context, syntheticRecord(context, trial), {}));
  const Json json = Json::parse(summaryJson(context, mergeScores(scores)));
  EXPECT_EQ(json["trials"], 3);
  ASSERT_EQ(json["trials_detail"].size(), 3u);
  EXPECT_EQ(json["trials_detail"][2]["trial"], 2);
  EXPECT_TRUE(json["filter"]["modes_at_end"].is_null());
  EXPECT_TRUE(json["verdict_spells"].is_null());
}

TEST(SummaryJson, SameRunSameBytes)
{
  const RunContext context = syntheticContext();
  const RunScore score = scoreRun(context, syntheticRecord(context), {});
  EXPECT_EQ(summaryJson(context, score), summaryJson(context, scoreRun(context, syntheticRecord(context), {})));
  EXPECT_EQ(summaryJson(context, score).back(), '\n');
}

TEST(SummaryJson, BytesThatAreNotUtf8DoNotStopIt)
{
  RunContext context = syntheticContext(10);
  context.rawlog_path = "caf\xe9.rawlog";
  EXPECT_EQ(summaryOf(context, syntheticRecord(context))["trials"], 1);
}
}  // namespace mrpt_ext::test_summary_json
