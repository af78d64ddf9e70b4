#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mrpt_ext::testing
{
using SummaryKeys = std::vector<std::string>;

inline SummaryKeys keysOf(const nlohmann::ordered_json& object)
{
  SummaryKeys keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

/// Every key of summary.json, schema 1, in its order.
inline void expectSchema1(const nlohmann::ordered_json& json)
{
  using Keys = SummaryKeys;
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(keysOf(json), (Keys{"schema",
                                "version",
                                "config",
                                "seed",
                                "trials",
                                "success_rate",
                                "trials_detail",
                                "rawlog",
                                "inputs",
                                "observations",
                                "methods",
                                "judged_method",
                                "position_error_m_with_detections",
                                "time_per_step_ms",
                                "filter",
                                "landmarks",
                                "limit",
                                "verdict",
                                "verdict_reason",
                                "hints",
                                "calibration",
                                "verdict_shares",
                                "verdict_spells",
                                "cost"}));
  EXPECT_EQ(keysOf(json.at("verdict_shares")), (Keys{"ok", "ambiguous", "lost"}));
  for (const auto& spell : json.at("verdict_spells"))
    EXPECT_EQ(keysOf(spell), (Keys{"from_s", "to_s", "verdict", "reason"}));
  for (const auto& trial : json.at("trials_detail"))
    EXPECT_EQ(keysOf(trial), (Keys{"trial", "seed", "success", "verdict", "rmse", "converged_at_s"}));
  EXPECT_EQ(keysOf(json.at("rawlog")), (Keys{"path", "sha256", "entries", "duration_s"}));
  EXPECT_EQ(keysOf(json.at("inputs")), (Keys{"log", "map", "truth", "config"}));
  for (const auto& counts : json.at("observations")) EXPECT_EQ(keysOf(counts), (Keys{"total", "used", "ignored"}));
  for (const auto& [name, method] : json.at("methods").items())
  {
    EXPECT_EQ(keysOf(method),
              (Keys{"estimates", "availability", "position_error_m", "heading_error_deg", "position_error_whole_run_m",
                    "position_error_m_with_detections", "position_error_m_blind", "time_per_step_ms"}))
        << name;
    for (const char* error : {"position_error_m", "heading_error_deg", "position_error_whole_run_m"})
      EXPECT_EQ(keysOf(method.at(error)), (Keys{"rmse", "mean", "median", "std", "min", "max", "p95"})) << name;
    EXPECT_EQ(keysOf(method.at("time_per_step_ms")), (Keys{"median", "p95", "p99", "max"})) << name;
  }
  EXPECT_EQ(keysOf(json.at("filter")),
            (Keys{"particles", "nees", "coverage_95", "effective_sample_ratio_min", "converged_at_s", "lost_steps",
                  "reseeds", "late_estimates", "most_steps_late", "modes_at_end"}));
  EXPECT_EQ(keysOf(json.at("filter").at("particles")), (Keys{"min", "median", "max"}));
  EXPECT_EQ(keysOf(json.at("filter").at("nees")), (Keys{"mean", "band_low", "band_high"}));
  for (const auto& mode : json.at("filter").at("modes_at_end"))
    EXPECT_EQ(keysOf(mode), (Keys{"x", "y", "phi_deg", "weight"}));
  for (const auto& landmark : json.at("landmarks"))
    EXPECT_EQ(keysOf(landmark), (Keys{"seen", "associated", "inlier_rate", "residual_mean", "residual_std"}));
  EXPECT_EQ(keysOf(json.at("limit")), (Keys{"pcrlb_position_rmse_m", "pcrlb_heading_rmse_deg"}));
  EXPECT_EQ(keysOf(json.at("cost")), (Keys{"cpu_s", "wall_s", "peak_memory_mb", "realtime_factor"}));
}
}  // namespace mrpt_ext::testing
