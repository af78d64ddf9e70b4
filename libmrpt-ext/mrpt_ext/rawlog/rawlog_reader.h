#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "mrpt_ext/rawlog/rawlog_file_check.h"

namespace mrpt::serialization
{
class CSerializable;
}  // namespace mrpt::serialization

namespace mrpt_ext
{
/// Reads the records of a rawlog one after the other, strictly. MRPT's own readers take damage for the end of the log;
/// here the log ends only where a record ends with the last byte, the compression is intact, and the number of records
/// is the one that the log itself states (a comment line "entries=N", written by our sink). Everything else is an
/// InputError (data) with file, record number (counted from 0, comments not counted) and what happened.
class RawlogReader
{
 public:
  /// Opens the log; damage of the compression is found and reported at once.
  explicit RawlogReader(const std::filesystem::path& path);
  ~RawlogReader();
  RawlogReader(const RawlogReader&) = delete;
  RawlogReader& operator=(const RawlogReader&) = delete;

  /// The next record; null at the end. Comments are kept aside.
  [[nodiscard]] std::shared_ptr<mrpt::serialization::CSerializable> next();

  [[nodiscard]] std::size_t entries() const { return entries_; }  ///< read so far
  [[nodiscard]] const std::string& comment() const { return comment_; }
  [[nodiscard]] const RawlogFileCheck& file() const { return file_; }

  /// An error about the record read last.
  [[nodiscard]] std::string where() const;

 private:
  class Content;
  std::shared_ptr<mrpt::serialization::CSerializable> nextObject();
  void findDamagedRecord();
  void compareWithStatedEntries() const;

  std::filesystem::path path_;
  RawlogFileCheck file_;
  std::unique_ptr<Content> content_;
  std::size_t entries_ = 0;
  std::string comment_;
};

/// N of a comment line "entries=N".
[[nodiscard]] std::optional<std::size_t> statedEntries(const std::string& comment);
}  // namespace mrpt_ext
