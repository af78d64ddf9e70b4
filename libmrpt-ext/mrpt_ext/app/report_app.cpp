#include "mrpt_ext/app/report_app.h"

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/report/comparison_page.h"
#include "mrpt_ext/report/study_table.h"

namespace mrpt_ext
{
int ReportApp::run(const std::vector<std::string>& arguments)
{
  AppShell shell("localization-report", "Compares or merges finished runs of landmark-localization", out_, err_);
  std::vector<std::filesystem::path> folders;
  std::filesystem::path table;
  shell.cli().add_option("DIR", folders, "Output folders of finished runs")->required();
  shell.cli().add_option("--table", table,
                         "Also the figures as a table: FILE.csv (with the settings that differ) or FILE.md");
  return shell.run(arguments,
                   [&]
                   {
                     const std::filesystem::path& output = shell.options().output;
                     if (output.extension() != ".html")
                       throw configurationError("output '" + output.string() + "', expected -o REPORT.html");
                     if (!shell.options().overrides.empty())
                       throw configurationError("--set " + shell.options().overrides.front() +
                                                ": localization-report has no configuration");
                     const std::string kind = table.extension().string();
                     if (!table.empty() && kind != ".csv" && kind != ".md")
                       throw configurationError("--table '" + table.string() + "', expected FILE.csv or FILE.md");
                     const std::vector<FinishedRun> runs = readFinishedRuns(folders);
                     writeFileAtomically(output, collectionPage(runs));
                     if (!table.empty())
                       writeFileAtomically(table, kind == ".csv" ? studyCsv(runs) : studyMarkdown(runs));
                     if (shell.options().quiet) return kExitDone;
                     for (const FinishedRun& run : runs)
                       out_ << run.name << ": " << run.trials.size() << " trials from " << run.folders.size()
                            << " folders\n";
                     out_ << "wrote " << output.string() << '\n';
                     return kExitDone;
                   });
}
}  // namespace mrpt_ext
