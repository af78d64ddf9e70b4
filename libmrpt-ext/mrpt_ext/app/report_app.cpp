#include <ostream>

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/app/apps.h"
#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/report/comparison_page.h"
#include "mrpt_ext/report/study_table.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

int compareRuns(const std::vector<fs::path>& folders, const fs::path& table, const CommonOptions& options,
                std::ostream& out)
{
  if (options.output.extension() != ".html")
    throw configurationError("output '" + options.output.string() + "', expected -o REPORT.html");
  if (!options.overrides.empty())
    throw configurationError("--set " + options.overrides.front() + ": localization-report has no configuration");
  const std::string kind = table.extension().string();
  if (!table.empty() && kind != ".csv" && kind != ".md")
    throw configurationError("--table '" + table.string() + "', expected FILE.csv or FILE.md");
  const std::vector<FinishedRun> runs = readFinishedRuns(folders);
  writeFileAtomically(options.output, comparisonPage(runs));
  if (!table.empty()) writeFileAtomically(table, kind == ".csv" ? studyCsv(runs) : studyMarkdown(runs));
  if (options.quiet) return kExitDone;
  for (const FinishedRun& run : runs)
    out << run.name << ": " << run.trials.size() << " trials from " << run.folders.size() << " folders\n";
  out << "wrote " << options.output.string() << '\n';
  return kExitDone;
}
}  // namespace

int runLocalizationReport(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err)
{
  AppShell shell({.name = "localization-report",
                  .purpose = "Compares or merges finished runs of landmark-localization",
                  .examples = {"out/room out/half-field -o out/compared.html",
                               "out/part_* -o out/study.html --table out/study.csv"}},
                 out, err);
  std::vector<fs::path> folders;
  fs::path table;
  shell.commandLine()
      .add({.names = "DIR", .target = &folders, .help = "Output folders of finished runs", .required = true})
      .add({.names = "--table",
            .target = &table,
            .help = "Write the figures as a table too: FILE.csv (with the settings that differ) or FILE.md"});
  return shell.run(arguments, [&] { return compareRuns(folders, table, shell.options(), shell.out()); });
}
}  // namespace mrpt_ext
