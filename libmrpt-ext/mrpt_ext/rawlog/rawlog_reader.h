#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "mrpt_ext/rawlog/rawlog_file_check.h"

namespace mrpt::serialization
{
class CSerializable;
}  // namespace mrpt::serialization

namespace mrpt_ext
{
class RawlogContent;
struct ObjectHeader;

/// Reads the records of a rawlog one after the other, strictly. MRPT's own readers take damage for the end of the log;
/// here the log ends only where a record ends with the last byte, the compression is intact, and the number of records
/// is the one that the log itself states (a comment line "entries=N", written by our sink). Everything else is an
/// InputError (data) with file, record number (counted from 0, comments not counted) and what happened.
///
/// A log of a newer MRPT may hold versions of classes that the installed one cannot read. Observations that the caller
/// does not need are then skipped and counted. MRPT's format states no length of an object: the end of a
/// skipped one is where the next record begins.
class RawlogReader
{
 public:
  /// Opens the log; damage of the compression is found and reported at once. `needed`: the classes, without namespace,
  /// whose unreadable versions end the run; absent: all.
  explicit RawlogReader(const std::filesystem::path& path, std::optional<std::set<std::string>> needed = {});
  ~RawlogReader();
  RawlogReader(const RawlogReader&) = delete;
  RawlogReader& operator=(const RawlogReader&) = delete;

  /// The next record; null at the end. Comments are kept aside.
  [[nodiscard]] std::shared_ptr<mrpt::serialization::CSerializable> next();

  [[nodiscard]] std::size_t entries() const { return entries_; }  ///< read so far, skipped ones included
  [[nodiscard]] const std::string& comment() const { return comment_; }
  [[nodiscard]] const RawlogFileCheck& file() const { return file_; }

  /// Observations that were skipped so far, by class (without namespace) and reason.
  [[nodiscard]] const std::map<std::pair<std::string, std::string>, std::size_t>& skipped() const { return skipped_; }

  /// An error about the record read last.
  [[nodiscard]] std::string where() const;

 private:
  using ObjectPtr = std::shared_ptr<mrpt::serialization::CSerializable>;
  /// Null: a comment, or skipped.
  ObjectPtr nextEntry();
  ObjectPtr readFrame(const ObjectHeader& header);
  ObjectPtr readObject(const std::optional<ObjectHeader>& header, bool ends_frame);
  ObjectPtr skip(const ObjectHeader& header, bool ends_frame);
  void findDamagedRecord();
  void compareWithStatedEntries() const;

  std::filesystem::path path_;
  std::optional<std::set<std::string>> needed_;
  RawlogFileCheck file_;
  std::unique_ptr<RawlogContent> content_;
  std::size_t entries_ = 0;
  std::string comment_;
  std::map<std::pair<std::string, int>, std::string> unreadable_;  // reason, by class (with namespace) and version
  std::map<std::pair<std::string, std::string>, std::size_t> skipped_;
};
}  // namespace mrpt_ext
