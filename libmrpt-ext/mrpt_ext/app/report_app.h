#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace mrpt_ext
{
/// localization-report DIR... -o REPORT.html: finished runs side by side; parts of one study are merged.
class ReportApp
{
 public:
  ReportApp(std::ostream& out, std::ostream& err) : out_(out), err_(err) {}
  /// `arguments` without the program's name; returns the exit code.
  int run(const std::vector<std::string>& arguments);

 private:
  std::ostream& out_;
  std::ostream& err_;
};
}  // namespace mrpt_ext
