#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace mrpt_ext
{
/// landmark-localization CONFIG.ini [RAWLOG]: runs the filter and the closed-form methods over a rawlog, compares them
/// and writes the results. What the app does is in localization_run.h; here is only its command line.
class LocalizationApp
{
 public:
  LocalizationApp(std::ostream& out, std::ostream& err) : out_(out), err_(err) {}

  /// `arguments` without the program's name; returns the exit code.
  int run(const std::vector<std::string>& arguments);

 private:
  std::ostream& out_;
  std::ostream& err_;
};
}  // namespace mrpt_ext
