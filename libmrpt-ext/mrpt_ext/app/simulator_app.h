#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace mrpt_ext
{
/// landmark-simulator CONFIG.ini -o STEM.rawlog: plays the scenario of an .ini file and writes STEM.rawlog,
/// STEM_ground_truth.tum and STEM_map.csv.
class SimulatorApp
{
 public:
  SimulatorApp(std::ostream& out, std::ostream& err) : out_(out), err_(err) {}

  /// Takes the arguments without the program's name, returns an exit code.
  int run(const std::vector<std::string>& arguments);

 private:
  std::ostream& out_;
  std::ostream& err_;
};
}  // namespace mrpt_ext
