#include "mrpt_ext/files/atomic_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
InputError cannotWrite(const std::filesystem::path& path, const std::string& reason)
{
  return dataError(path.string() + ": cannot be written (" + reason + ")");
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path))
{
  std::error_code error;
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
  if (error) throw cannotWrite(path_, error.message());
  temporary_ = temporaryNameFor(path_);
  errno = 0;
  file_ = std::fopen(temporary_.c_str(), "wb");
  if (!file_) fail(errno);
}

AtomicFile::~AtomicFile()
{
  if (!file_) return;
  std::fclose(file_);
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::write(std::string_view text)
{
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail(errno);
}

void AtomicFile::commit()
{
  // A full disk often shows only when the buffer is flushed.
  errno = 0;
  if (std::fflush(file_) != 0) fail(errno);
  if (std::fclose(std::exchange(file_, nullptr)) != 0)
  {
    const int reason = errno;
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
    fail(reason);
  }
  renameIntoPlace(temporary_, path_);
}

void AtomicFile::fail(int error) const { throw cannotWrite(path_, std::strerror(error != 0 ? error : EIO)); }

void writeFileAtomically(const std::filesystem::path& path, const std::function<void(const TextSink&)>& content)
{
  AtomicFile file(path);
  content([&file](std::string_view text) { file.write(text); });
  file.commit();
}

void writeFileAtomically(const std::filesystem::path& path, std::string_view content)
{
  AtomicFile file(path);
  file.write(content);
  file.commit();
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
