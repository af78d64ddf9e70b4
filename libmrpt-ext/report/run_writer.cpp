#include "mrpt_ext/report/run_writer.h"

#include "mrpt_ext/evaluation/odometry_anchor.h"
#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/report/html_page.h"
#include "mrpt_ext/report/hypotheses_csv.h"
#include "mrpt_ext/report/objects_csv.h"
#include "mrpt_ext/report/steps_csv.h"
#include "mrpt_ext/report/summary_json.h"
#include "mrpt_ext/report/trajectory_tum.h"

namespace mrpt_ext
{
void writeTrial(const std::filesystem::path& folder, const RunContext& context, const RunRecord& record,
                const RunScore& score)
{
  const RunRecord placed = withAnchoredOdometry(record, context.truth);
  writeFileAtomically(folder / "steps.csv", stepsCsv(placed));
  writeFileAtomically(folder / "hypotheses.csv", hypothesesCsv(placed.hypotheses));
  if (context.objects_wanted || !placed.objects.empty())
    writeFileAtomically(folder / "objects.csv", objectsCsv(placed.objects));
  for (const MethodTrack& method : placed.methods) writeTrajectoryTum(folder, method);
  writeFileAtomically(folder / "report.html", trialPage(context, placed, score));
  // Last: who finds a summary finds everything that it belongs to.
  writeFileAtomically(folder / "summary.json", summaryJson(context, score));
}

void writeMerged(const std::filesystem::path& folder, const RunContext& context, const RunScore& merged)
{
  writeFileAtomically(folder / "report.html", mergedPage(context, merged));
  writeFileAtomically(folder / "summary.json", summaryJson(context, merged));
}
}  // namespace mrpt_ext
