#include "mrpt_ext/files/staged_file.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>
#include <random>
#include <set>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

constexpr std::string_view kTemporaryMark = ".tmp-";
constexpr std::size_t kRandomDigits = 16;

/// The staged files of this process, for a signal handler: it may neither lock nor allocate. A slot is emptied by
/// whoever takes its name.
using Slot = std::atomic<char*>;
std::array<Slot, 256> staged{};
constexpr std::size_t kNoSlot = staged.size();  ///< so many at once: the rest is left to the next program

std::size_t registerName(const fs::path& file)
{
  char* const name = strdup(file.c_str());
  for (std::size_t i = 0; i < staged.size(); ++i)
    if (char* empty = nullptr; staged[i].compare_exchange_strong(empty, name)) return i;
  std::free(name);
  return kNoSlot;
}

void unregisterName(std::size_t slot)
{
  if (slot != kNoSlot) std::free(staged[slot].exchange(nullptr));
}

std::atomic<int> creating{0};
std::atomic<bool> ending{false};

/// For the other threads of a process that a signal handler is about to end.
[[noreturn]] void waitForTheEnd()
{
  while (true) pause();
}

/// The time in which a file exists that is not registered yet: no signal interrupts it, removeStagedFiles() of another
/// thread waits for its end, and afterwards it does not begin.
class Creation
{
 public:
  Creation()
  {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
    ++creating;
    if (!ending) return;
    --creating;
    waitForTheEnd();
  }
  ~Creation()
  {
    --creating;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  Creation(const Creation&) = delete;
  Creation& operator=(const Creation&) = delete;

 private:
  sigset_t before_{};
};

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

fs::path temporaryName(const fs::path& target)
{
  constexpr const char* kHexDigits = "0123456789abcdef";
  std::random_device random;
  std::string name = target.string() + std::string(kTemporaryMark);
  for (std::size_t i = 0; i < kRandomDigits; ++i) name += kHexDigits[random() % 16];
  return name;
}

bool isTemporaryName(const std::string& name)
{
  if (name.size() <= kTemporaryMark.size() + kRandomDigits) return false;
  const std::size_t digits = name.size() - kRandomDigits;
  return name.compare(digits - kTemporaryMark.size(), kTemporaryMark.size(), kTemporaryMark) == 0 &&
         name.find_first_not_of("0123456789abcdef", digits) == std::string::npos;
}

/// Removes `file` unless its writer is alive, that is, holds its lock.
void removeIfStray(const fs::path& file)
{
  const int descriptor = open(file.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) unlink(file.c_str());
  close(descriptor);
}

/// Once per folder and process: a folder may hold many files.
void removeStrays(const fs::path& folder)
{
  static std::mutex mutex;
  static std::set<fs::path> done;
  std::error_code ignored;
  {
    const std::lock_guard lock(mutex);
    if (!done.insert(fs::absolute(folder, ignored)).second) return;
  }
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored))
    if (isTemporaryName(entry->path().filename().string()) && entry->is_regular_file(ignored))
      removeIfStray(entry->path());
}

/// True when the data is on the disk, or the file system knows no such thing.
bool synchronized(int descriptor)
{
  return fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

void synchronizeFolder(const fs::path& folder)
{
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // a folder that may be written but not read
  fsync(descriptor);
  close(descriptor);
}
}  // namespace

StagedFile::StagedFile(fs::path target) : target_(std::move(target)), registered_(kNoSlot)
{
  std::error_code error;
  fs::create_directories(folderOf(target_), error);
  if (error) fail(error.value());
  removeStrays(folderOf(target_));
  create();
}

void StagedFile::create()
{
  const Creation creation;
  for (struct stat found = {}; found.st_nlink == 0;)
  {
    temporary_ = temporaryName(target_);
    file_ = open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file_ < 0) fail(errno);
    flock(file_, LOCK_EX);  // where files cannot be locked, strays are kept
    // Before the lock, another program may have taken the file for a stray one.
    if (fstat(file_, &found) != 0) found.st_nlink = 1;
    if (found.st_nlink == 0) close(file_);
  }
  registered_ = registerName(temporary_);
}

StagedFile::~StagedFile()
{
  if (file_ >= 0) discard();
}

void StagedFile::discard()
{
  unlink(temporary_.c_str());
  unregisterName(registered_);
  close(file_);
  file_ = -1;
}

void StagedFile::commit()
{
  const int error = synchronized(file_) && rename(temporary_.c_str(), target_.c_str()) == 0 ? 0 : errno;
  if (error != 0)
  {
    discard();
    fail(error);
  }
  unregisterName(registered_);
  synchronizeFolder(folderOf(target_));
  close(file_);
  file_ = -1;
}

void StagedFile::fail(int error) const
{
  if (ending) waitForTheEnd();  // its file was removed
  throw dataError(target_.string() + ": cannot be written (" + std::strerror(error != 0 ? error : EIO) + ")");
}

void removeStagedFiles() noexcept
{
  ending = true;
  while (creating > 0) sched_yield();
  for (Slot& slot : staged)
    if (const char* const name = slot.exchange(nullptr)) unlink(name);  // not freed: the program ends
}
}  // namespace mrpt_ext
