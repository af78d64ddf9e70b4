#include "mrpt_ext/report/calibration_text.h"

#include <algorithm>

#include "mrpt_ext/geometry/formatted.h"
#include "mrpt_ext/report/comparison_text.h"
#include "mrpt_ext/report/html_parts.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/number_text.h"

namespace mrpt_ext
{
namespace
{
using Cells = std::vector<std::string>;

const Cells kCalibrationTitles{"", "log density per reading", "verdict", "ok", "position RMSE"};

Cells calibrationCells(const std::string& name, const CalibrationRow& row)
{
  const std::string rmse = magnitudeText(row.position_rmse_m);
  return {name, numberText(row.log_density, 3), toString(row.verdict), percentText(row.shares.ok),
          row.position_rmse_m ? rmse + " m" : rmse};
}

std::vector<Cells> calibrationRows(const RunContext& context, const RunScore& score)
{
  return {calibrationCells("as configured", context.calibration->before),
          calibrationCells("calibrated", calibratedRow(context, score))};
}
}  // namespace

CalibrationRow calibratedRow(const RunContext& context, const RunScore& score)
{
  CalibrationRow row{.verdict = score.verdict, .shares = score.verdict_shares};
  if (context.calibration) row.log_density = context.calibration->log_density_after;
  if (const MethodScore* judged = judgedScore(score)) row.position_rmse_m = judged->position_error_m.rmse;
  return row;
}

std::string calibrationText(const RunContext& context, const RunScore& score)
{
  if (!context.calibration) return {};
  std::string text = "calibrated from the log, without the truth (auto_calibrate = false runs as configured):\n";
  for (const CalibratedValue& value : context.calibration->values)
    text += "  [" + value.section + "] " + value.key + " = " + withDeviation(value, " ") + '\n';
  std::vector<Cells> rows = calibrationRows(context, score);
  rows.insert(rows.begin(), kCalibrationTitles);
  for (const Cells& row : rows)
    text += formatted("  %-13s  %23s  %-9s  %6s  %13s\n", row[0].c_str(), row[1].c_str(), row[2].c_str(),
                      row[3].c_str(), row[4].c_str());
  return text + '\n';
}

std::string calibrationSection(const RunContext& context, const RunScore& score)
{
  if (!context.calibration) return {};
  std::string values, rows;
  for (const CalibratedValue& value : context.calibration->values)
    values +=
        htmlRow({escapeHtml("[" + value.section + "] " + value.key), escapeHtml(value.value), deviationText(value)});
  for (const Cells& row : calibrationRows(context, score)) rows += htmlRow(row);
  return htmlSection("Calibrated from the log",
                     htmlTable({"key", "value", "standard deviation"}, values) + htmlTable(kCalibrationTitles, rows),
                     "Estimated in a first pass, without the truth. The log density counts the second half of the log, "
                     "predicted with values from its first half. The lines are in calibration.ini.");
}
}  // namespace mrpt_ext
