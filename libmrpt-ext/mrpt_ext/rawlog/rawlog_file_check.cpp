#include "mrpt_ext/rawlog/rawlog_file_check.h"

#include <vector>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/rawlog/decompressed_file.h"
#include "mrpt_ext/rawlog/sha256.h"

namespace mrpt_ext
{
RawlogFileCheck checkRawlogFile(const std::filesystem::path& path)
{
  RawlogFileCheck check;
  Sha256 digest;
  DecompressedFile file(path, &digest);
  std::vector<unsigned char> buffer(1 << 16);
  while (const std::size_t got = file.read(buffer)) check.content += got;
  check.compressed = file.compression() != Compression::none;
  check.damage = file.damage();
  file.readRest();
  check.sha256 = digest.hex();
  if (check.content == 0 && check.damage.empty())
    throw dataError(path.string() + ": the compressed file is empty, expected a rawlog");
  return check;
}
}  // namespace mrpt_ext
