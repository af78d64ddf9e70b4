#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace mrpt_ext
{
/// images2rawlog CONFIG.ini -i DIR_OR_RAWLOG -o STEM.rawlog [--csv FILE] [--debug-images DIR]: what the images show, as
/// observations. Beside the rawlog it writes STEM_map.csv and STEM_ground_truth.tum when the images come with them.
class ImagesApp
{
 public:
  ImagesApp(std::ostream& out, std::ostream& err) : out_(out), err_(err) {}

  /// Takes the arguments without the program's name, returns an exit code.
  int run(const std::vector<std::string>& arguments);

 private:
  std::ostream& out_;
  std::ostream& err_;
};
}  // namespace mrpt_ext
