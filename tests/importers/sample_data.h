#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "error_message.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/geometry/recording.h"
#include "scratch_folder.h"

namespace mrpt_ext::testing
{
/// Hand-written samples of the foreign formats.
inline std::filesystem::path sampleFolder(const std::string& format)
{
  return std::filesystem::path(MRPT_EXT_TEST_DATA) / "importers" / format;
}

/// Folder of real recordings; they are not part of the sources, so it may be absent.
inline std::filesystem::path recordingsFolder(const std::string& name)
{
  const char* root = std::getenv("LANDMARK_DATA_DIR");
  const std::filesystem::path fallback = std::filesystem::path(MRPT_EXT_SOURCE_DIR) / ".." / "shared" / "data";
  return (root ? std::filesystem::path(root) : fallback) / name;
}

/// A copy of a sample folder in which single files are replaced or removed.
class DamagedCopy
{
 public:
  explicit DamagedCopy(const std::string& format)
  {
    std::filesystem::copy(sampleFolder(format), folder_.path(), std::filesystem::copy_options::recursive);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }
  void replace(const std::string& file, const std::string& content) const { folder_.write(file, content); }
  void remove(const std::string& file) const { std::filesystem::remove(folder_.path() / file); }

 private:
  ScratchFolder folder_;
};

/// All records of one type, in order.
template <typename RecordType>
std::vector<RecordType> recordsOf(const Recording& recording)
{
  std::vector<RecordType> found;
  for (const Record& record : recording.records)
    if (const auto* match = std::get_if<RecordType>(&record)) found.push_back(*match);
  return found;
}

inline bool hasNote(const Recording& recording, const std::string& part)
{
  for (const std::string& note : recording.notes)
    if (note.find(part) != std::string::npos) return true;
  return false;
}
}  // namespace mrpt_ext::testing

/// The message of what `action` throws contains `part`.
#define EXPECT_INPUT_ERROR(action, part)                                                             \
  do {                                                                                               \
    const std::string message = mrpt_ext::testing::messageOf<mrpt_ext::InputError>([&] { action; }); \
    EXPECT_NE(message.find(part), std::string::npos) << message;                                     \
  } while (false)
