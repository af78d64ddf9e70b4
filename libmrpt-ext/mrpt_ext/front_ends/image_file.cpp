#include "mrpt_ext/front_ends/image_file.h"

#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>

#include "mrpt_ext/front_ends/image_integrity.h"

namespace mrpt_ext
{
ImageContent readImageFile(const std::filesystem::path& file)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return {};
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (std::string why = whyNoImage(bytes); !why.empty()) return {{}, std::move(why)};
  try
  {
    return {cv::imdecode({bytes.data(), static_cast<int>(bytes.size())}, cv::IMREAD_ANYCOLOR), {}};
  }
  catch (const cv::Exception&)
  {
    return {{}, "image cannot be decoded"};
  }
}
}  // namespace mrpt_ext
