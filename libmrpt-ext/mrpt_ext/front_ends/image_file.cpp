#include "mrpt_ext/front_ends/image_file.h"

#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <string_view>

namespace mrpt_ext
{
namespace
{
using namespace std::string_view_literals;

bool isCutOff(const std::string_view bytes)
{
  // JPEG: an end marker after the last start of a scan; a thumbnail before it has both too.
  if (bytes.starts_with("\xFF\xD8"sv))
  {
    const auto end = bytes.rfind("\xFF\xD9"sv), scan = bytes.rfind("\xFF\xDA"sv);
    return end == bytes.npos || scan == bytes.npos || end < scan;
  }
  if (bytes.starts_with("\x89PNG"sv)) return bytes.rfind("IEND"sv) == bytes.npos;
  return false;
}
}  // namespace

cv::Mat readImageFile(const std::filesystem::path& file)
{
  if (!std::filesystem::is_regular_file(file)) return {};
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty() || isCutOff(bytes)) return {};
  return cv::imdecode({bytes.data(), static_cast<int>(bytes.size())}, cv::IMREAD_ANYCOLOR);
}
}  // namespace mrpt_ext
