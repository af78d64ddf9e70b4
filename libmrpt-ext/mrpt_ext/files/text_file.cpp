#include "mrpt_ext/files/text_file.h"

#include <zlib.h>

#include <array>
#include <memory>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kExpected = ", expected a readable text file (plain or gzip)";

/// Unpacks a file block by block.
void forEachBlock(const std::filesystem::path& path, const std::function<void(std::string_view)>& take)
{
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) throw dataError(path.string() + ": no such file");
  if (std::filesystem::is_directory(path, ignored)) throw dataError(path.string() + ": is a folder" + kExpected);

  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) throw dataError(path.string() + ": cannot be opened" + kExpected);
  std::array<char, 1 << 16> block;
  int count = 0;
  while ((count = gzread(file.get(), block.data(), block.size())) > 0)
    take({block.data(), static_cast<std::size_t>(count)});

  // At the end of damaged data gzread reports a normal end of file; only gzerror reveals the truncation.
  int status = Z_OK;
  gzerror(file.get(), &status);
  if (count < 0 || (status != Z_OK && status != Z_STREAM_END))
    throw dataError(path.string() + ": damaged or cut off gzip data" + kExpected);
}
}  // namespace

std::string readTextFile(const std::filesystem::path& path)
{
  std::string content;
  const auto take = [&](std::string_view block)
  {
    content += block;
    if (content.size() > kLargestText)
      throw dataError(path.string() + ": more than " + std::to_string(kLargestText >> 20) + " MB" + kExpected);
  };
  forEachBlock(path, take);
  return content;
}

void forEachLine(const std::filesystem::path& path, const std::function<void(std::string_view)>& take)
{
  std::string begun;  // a line that ends in a later block
  const auto split = [&](std::string_view block)
  {
    for (std::size_t end = 0; (end = block.find('\n')) != std::string_view::npos; block.remove_prefix(end + 1))
    {
      begun += block.substr(0, end);
      take(begun);
      begun.clear();
    }
    begun += block;
    if (begun.size() > kLongestLine)
      throw dataError(path.string() + ": a line of more than " + std::to_string(kLongestLine >> 20) + " MB" +
                      kExpected);
  };
  forEachBlock(path, split);
  if (!begun.empty()) take(begun);
}

std::optional<std::filesystem::path> findPlainOrGzipped(const std::filesystem::path& path)
{
  if (std::filesystem::exists(path)) return path;
  std::filesystem::path gzipped = path;
  gzipped += ".gz";
  if (std::filesystem::exists(gzipped)) return gzipped;
  return std::nullopt;
}
}  // namespace mrpt_ext
