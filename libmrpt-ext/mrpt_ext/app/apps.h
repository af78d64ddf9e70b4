#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace mrpt_ext
{
// The programs, for their main() and for tests. They take the arguments without the program's name, write results to
// `out` and all else to `err`, and return an exit code (exit_codes.h).

/// landmark-localization CONFIG.ini [RAWLOG]: runs the filter and the closed-form methods over a rawlog, compares them
/// and writes the results.
int runLandmarkLocalization(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

/// landmark-simulator CONFIG.ini -o STEM.rawlog: runs the scenario of an .ini file and writes STEM.rawlog,
/// STEM_ground_truth.tum and STEM_map.csv.
int runLandmarkSimulator(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

/// images2rawlog CONFIG.ini -i DIR_OR_RAWLOG -o STEM.rawlog [--csv FILE] [--debug-images DIR]: measures landmarks in
/// images. Beside the rawlog it writes STEM_map.csv and STEM_ground_truth.tum when the images come with them.
int runImages2Rawlog(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

/// dataset2rawlog FORMAT INPUT... -o STEM.rawlog: converts recordings of other formats to STEM.rawlog, STEM_map.csv
/// and, if there is a truth, STEM_ground_truth.tum. What was read, dropped and corrected goes to `out`, warnings to
/// `err`.
int runDataset2Rawlog(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

/// localization-report DIR... -o REPORT.html: finished runs side by side; parts of one study are merged.
int runLocalizationReport(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

/// The arguments of main() without the program's name.
[[nodiscard]] inline std::vector<std::string> argumentsOf(int argc, const char* const* argv)
{
  return argc > 1 ? std::vector<std::string>(argv + 1, argv + argc) : std::vector<std::string>{};
}
}  // namespace mrpt_ext
