#include "mrpt_ext/rawlog/rawlog_reader.h"

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/serialization/CArchive.h>

#include <regex>
#include <sstream>
#include <stdexcept>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
/// The sentence in MRPT's exception text, which also holds source lines and a backtrace.
std::string firstSentence(const std::string& text)
{
  static const std::regex kMessage("Message:\\s*([^\\n]*)");
  std::smatch match;
  if (std::regex_search(text, match, kMessage)) return match[1];
  return text.substr(0, text.find('\n'));
}

std::optional<std::string> unknownClass(const std::string& text)
{
  static const std::regex kUnknown("class '([^']*)' which is not registered");
  std::smatch match;
  return std::regex_search(text, match, kUnknown) ? std::optional<std::string>(match[1]) : std::nullopt;
}

std::string causeOf(const std::string& text)
{
  if (const auto name = unknownClass(text))
    return "unknown class '" + *name +
           "', expected a class of MRPT or of a loaded plugin: run with LD_PRELOAD=<library that defines it>.so";
  return "not readable (" + firstSentence(text) + ")";
}
}  // namespace

/// The decompressed bytes, counted: the log ends where none is left, and nowhere else.
class RawlogReader::Content : public mrpt::io::CStream
{
 public:
  Content(const std::filesystem::path& path, std::uint64_t size) : file_(path.string()), size_(size) {}

  size_t Read(void* buffer, size_t count) override
  {
    const size_t got = file_.Read(buffer, count);
    position_ += got;
    return got;
  }
  size_t Write(const void*, size_t) override { throw std::logic_error("the content of a rawlog is only read"); }
  std::uint64_t Seek(std::int64_t, CStream::TSeekOrigin) override { throw std::logic_error("not seekable"); }
  std::uint64_t getTotalBytesCount() const override { return size_; }
  std::uint64_t getPosition() const override { return position_; }
  std::string getStreamDescription() const override { return file_.getStreamDescription(); }
  [[nodiscard]] bool atEnd() const { return position_ >= size_; }

 private:
  mrpt::io::CFileGZInputStream file_;
  std::uint64_t size_;
  std::uint64_t position_ = 0;
};

RawlogReader::RawlogReader(const std::filesystem::path& path)
    : path_(path), file_(checkRawlogFile(path)), content_(std::make_unique<Content>(path, file_.content))
{
  if (!file_.damage.empty()) findDamagedRecord();
}

RawlogReader::~RawlogReader() = default;

std::string RawlogReader::where() const
{
  return path_.string() + ": record " + std::to_string(entries_ == 0 ? 0 : entries_ - 1) + ": ";
}

std::shared_ptr<mrpt::serialization::CSerializable> RawlogReader::next()
{
  while (!content_->atEnd())
  {
    auto object = nextObject();
    const auto* comment = dynamic_cast<const mrpt::obs::CObservationComment*>(object.get());
    if (!comment)
    {
      ++entries_;
      return object;
    }
    comment_ += comment->text + '\n';
  }
  compareWithStatedEntries();
  return nullptr;
}

std::shared_ptr<mrpt::serialization::CSerializable> RawlogReader::nextObject()
{
  const std::string where = path_.string() + ": record " + std::to_string(entries_) + ": ";
  try
  {
    auto object = mrpt::serialization::archiveFrom(*content_).ReadObject();
    if (object) return object;
  }
  catch (const std::exception& error)
  {
    if (content_->atEnd() && !unknownClass(error.what()))
      throw dataError(where + "cut off, the log ends in the middle of it");
    const bool nothing_read = entries_ == 0 && !unknownClass(error.what());
    throw dataError(where + (nothing_read ? "not readable, expected a rawlog" : causeOf(error.what())));
  }
  throw dataError(where + "empty, expected an observation, a sensory frame or an action collection");
}

void RawlogReader::findDamagedRecord()
{
  const std::string damage = file_.damage;
  try
  {
    while (next()) continue;
  }
  catch (const InputError&)
  {
    // The first record that cannot be read is where the damage shows; its cause is the compression.
  }
  throw dataError(path_.string() + ": record " + std::to_string(entries_) + ": " + damage);
}

void RawlogReader::compareWithStatedEntries() const
{
  const auto stated = statedEntries(comment_);
  if (!stated || *stated == entries_) return;
  throw dataError(path_.string() + ": record " + std::to_string(entries_) + ": the log ends here, but states " +
                  std::to_string(*stated) +
                  " entries in its comment; if a tool shortened it on purpose, remove the comment with: "
                  "rawlog-edit --remove-label entries -i IN -o OUT");
}

std::optional<std::size_t> statedEntries(const std::string& comment)
{
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);)
  {
    std::size_t number = 0;
    if (line.rfind("entries=", 0) == 0 && std::istringstream(line.substr(8)) >> number) return number;
  }
  return std::nullopt;
}
}  // namespace mrpt_ext
