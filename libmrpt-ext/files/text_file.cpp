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
}

std::string readTextFile(const std::filesystem::path& path)
{
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) throw dataError(path.string() + ": no such file");
  if (std::filesystem::is_directory(path, ignored)) throw dataError(path.string() + ": is a folder" + kExpected);

  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) throw dataError(path.string() + ": cannot be opened" + kExpected);
  std::string content;
  std::array<char, 1 << 16> block;
  int count = 0;
  while ((count = gzread(file.get(), block.data(), block.size())) > 0) content.append(block.data(), count);

  // gzread hands out what it could unpack and then ends like a whole file; only gzerror tells that data was cut off.
  int status = Z_OK;
  gzerror(file.get(), &status);
  if (count < 0 || (status != Z_OK && status != Z_STREAM_END))
    throw dataError(path.string() + ": damaged or cut off gzip data" + kExpected);
  return content;
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
