#include "mrpt_ext/files/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace mrpt_ext
{
AtomicFile::AtomicFile(std::filesystem::path path) : staged_(std::move(path))
{
  errno = 0;
  const int descriptor = fcntl(staged_.descriptor(), F_DUPFD_CLOEXEC, 0);  // the stream closes its own
  stream_ = descriptor < 0 ? nullptr : fdopen(descriptor, "wb");
  if (stream_) return;
  const int error = errno;
  if (descriptor >= 0) close(descriptor);
  staged_.fail(error);
}

AtomicFile::~AtomicFile()
{
  if (stream_) std::fclose(stream_);
}

void AtomicFile::write(std::string_view text)
{
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) staged_.fail(errno);
}

void AtomicFile::commit()
{
  errno = 0;
  // A full disk often shows only when the buffer is flushed.
  if (std::fclose(std::exchange(stream_, nullptr)) != 0) staged_.fail(errno);
  staged_.commit();
}

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
}  // namespace mrpt_ext
