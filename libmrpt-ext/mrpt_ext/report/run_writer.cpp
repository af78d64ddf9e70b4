#include "mrpt_ext/report/run_writer.h"

#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "mrpt_ext/evaluation/odometry_alignment.h"
#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/report/html_page.h"
#include "mrpt_ext/report/run_csv.h"
#include "mrpt_ext/report/summary_json.h"
#include "mrpt_ext/report/trajectory_tum.h"

namespace mrpt_ext
{
namespace
{
/// Removes results of an earlier run that this one might not overwrite.
void removeOldResults(const std::filesystem::path& folder)
{
  std::error_code ignored;
  std::vector<std::filesystem::path> old{folder / "summary.json", folder / "objects.csv", folder / "biases.csv"};
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
  {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("trajectory_") && name.ends_with(".tum")) old.push_back(entry.path());
  }
  for (const std::filesystem::path& file : old) std::filesystem::remove(file, ignored);
}
}  // namespace

void writeTrial(const std::filesystem::path& folder, const RunContext& context, RunRecord record, const RunScore& score)
{
  const RunRecord aligned = withAlignedOdometry(std::move(record), context.truth);
  removeOldResults(folder);
  const auto write = [&folder](const char* name, auto table, const auto& rows)
  { writeFileAtomically(folder / name, [&](const TextSink& sink) { table(rows, sink); }); };
  write("steps.csv", stepsCsv, aligned);
  write("hypotheses.csv", hypothesesCsv, aligned.hypotheses);
  if (context.objects_wanted || !aligned.objects.empty()) write("objects.csv", objectsCsv, aligned.objects);
  if (!aligned.biases.empty()) write("biases.csv", biasesCsv, aligned.biases);
  for (const MethodTrajectory& method : aligned.methods) writeTrajectoryTum(folder, method);
  writeFileAtomically(folder / "report.html", trialPage(context, aligned, score));
  // Last: a summary exists only beside all other files.
  writeFileAtomically(folder / "summary.json", summaryJson(context, score));
}

void writeMerged(const std::filesystem::path& folder, const RunContext& context, const RunScore& merged)
{
  writeFileAtomically(folder / "report.html", mergedPage(context, merged));
  writeFileAtomically(folder / "summary.json", summaryJson(context, merged));
}
}  // namespace mrpt_ext
