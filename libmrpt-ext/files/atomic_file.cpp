#include "mrpt_ext/files/atomic_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
InputError cannotWrite(const std::filesystem::path& path, const std::string& reason)
{
  return dataError(path.string() + ": cannot be written (" + reason + ")");
}

// Returns an errno value, 0 when every byte reached the file.
int writeAll(const std::filesystem::path& path, std::string_view content)
{
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return errno;
  const bool written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  const int write_error = errno;
  // A full disk often shows only when the buffer is flushed on closing.
  const bool closed = std::fclose(file) == 0;
  if (written && closed) return 0;
  const int error = written ? errno : write_error;
  return error != 0 ? error : EIO;
}
}  // namespace

void writeFileAtomically(const std::filesystem::path& path, std::string_view content)
{
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (error) throw cannotWrite(path, error.message());
  const std::filesystem::path temporary = temporaryNameFor(path);
  if (const int failure = writeAll(temporary, content))
  {
    std::filesystem::remove(temporary, error);
    throw cannotWrite(path, std::strerror(failure));
  }
  renameIntoPlace(temporary, path);
}

std::filesystem::path temporaryNameFor(const std::filesystem::path& path)
{
  static std::atomic<unsigned> counter{0};  // two threads may write at the same time
  std::filesystem::path temporary = path;
  temporary += ".tmp-" + std::to_string(getpid()) + "-" + std::to_string(counter++);
  return temporary;
}

void renameIntoPlace(const std::filesystem::path& temporary, const std::filesystem::path& path)
{
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  throw cannotWrite(path, error.message());
}
}  // namespace mrpt_ext
