#include "mrpt_ext/files/temporary_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
[[noreturn]] void fail(const std::string& folder, int error)
{
  throw dataError(folder + ": temporary data cannot be kept there (" + std::strerror(error) +
                  "), expected room for it: TMPDIR names another folder");
}
}  // namespace

TemporaryFile::TemporaryFile()
{
  std::error_code error;
  folder_ = std::filesystem::temp_directory_path(error).string();
  if (error) folder_ = P_tmpdir;
  std::string name = folder_ + "/mrpt-ext-XXXXXX";
  file_ = mkstemp(name.data());
  if (file_ < 0) fail(folder_, errno);
  unlink(name.c_str());
}

TemporaryFile::~TemporaryFile() { close(file_); }

TemporaryFile::Block TemporaryFile::append(std::string_view bytes)
{
  const Block block{end_.fetch_add(bytes.size()), bytes.size()};
  std::uint64_t offset = block.offset;
  while (!bytes.empty())
  {
    const ssize_t written = pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(folder_, written < 0 ? errno : ENOSPC);
    offset += static_cast<std::uint64_t>(written);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return block;
}

std::string TemporaryFile::read(const Block& block) const
{
  std::string bytes(block.size, '\0');
  for (std::size_t done = 0; done < bytes.size();)
  {
    const ssize_t got = pread(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(block.offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail(folder_, got < 0 ? errno : EIO);
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}
}  // namespace mrpt_ext
