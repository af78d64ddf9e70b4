#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/app/dataset_formats.h"

namespace mrpt_ext
{
/// dataset2rawlog FORMAT INPUT... -o STEM.rawlog: foreign recordings -> STEM.rawlog, STEM_ground_truth.tum (unless
/// there is no truth), STEM_map.csv. What was read, dropped and corrected is told on `out`, warnings on `err`.
class DatasetApp
{
 public:
  DatasetApp(std::ostream& out, std::ostream& err);
  /// `arguments` without the program's name; returns the exit code.
  int run(std::vector<std::string> arguments);

 private:
  int convert();
  void tell(const Recording& recording);
  void write(const Recording& recording, const std::filesystem::path& rawlog);
  /// `calibrated`: text of the configuration to write into.
  void examine(const Recording& recording, const std::string& calibrated);

  AppShell shell_;
  DatasetRequest request_;
  std::vector<double> truth_origin_;  // x y phi_deg
  bool examine_ = false;
  std::filesystem::path calibrated_;
};
}  // namespace mrpt_ext
