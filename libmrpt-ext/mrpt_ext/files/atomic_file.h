#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <string_view>

#include "mrpt_ext/files/staged_file.h"

namespace mrpt_ext
{
/// Takes a text piece by piece.
using TextSink = std::function<void(std::string_view)>;

/// A file that readers see either with its old content or with all of the new. Missing parent folders are created.
/// Throws InputError (data) when the folder is not writable or the disk is full, and leaves no temporary file behind.
class AtomicFile
{
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();  ///< discards what was not committed
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view text);
  /// The new content is complete.
  void commit();

 private:
  StagedFile staged_;
  std::FILE* stream_ = nullptr;
};

/// Writes what `content` gives as an AtomicFile.
void writeFileAtomically(const std::filesystem::path& path, const std::function<void(const TextSink&)>& content);
void writeFileAtomically(const std::filesystem::path& path, std::string_view content);
}  // namespace mrpt_ext
