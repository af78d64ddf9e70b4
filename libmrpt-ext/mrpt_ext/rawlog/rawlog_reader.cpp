#include "mrpt_ext/rawlog/rawlog_reader.h"

#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/serialization/CArchive.h>

#include <new>
#include <regex>
#include <sstream>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/rawlog/allocation_limit.h"
#include "mrpt_ext/rawlog/object_header.h"
#include "mrpt_ext/rawlog/rawlog_comment.h"
#include "mrpt_ext/rawlog/rawlog_content.h"
#include "mrpt_ext/rawlog/unreadable_class.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kFrameClass = "mrpt::obs::CSensoryFrame";
constexpr int kFrameVersion = 2;  ///< the number of observations and the observations, nothing else
const std::string kOriginal = "Original exception:\n";

/// A record in memory may be larger than in the file, but not by any factor.
constexpr std::uint64_t kSmallRecord = 16 << 20, kMemoryPerByte = 16;  // [bytes]

/// The sentence in MRPT's exception text, which also holds source lines and a backtrace.
std::string firstSentence(const std::string& text)
{
  static const std::regex kMessage("Message:\\s*([^\\n]*)");
  // MRPT wraps an exception into another one; the first one says what is wrong.
  const std::size_t inner = text.rfind(kOriginal);
  const std::string cause = inner == std::string::npos ? text : text.substr(inner + kOriginal.size());
  std::smatch match;
  if (std::regex_search(cause, match, kMessage)) return match[1];
  return cause.substr(0, cause.find('\n'));
}

/// MRPT writes lines of its own about a class without objects; this comes before it. `bytes`: the next of the log.
void expectConcreteClass(std::span<const unsigned char> bytes)
{
  if (bytes.empty()) return;
  const std::size_t length = bytes[0] & 0x7f;  // of the class name, which ends at a NUL for MRPT
  std::string name;
  for (const unsigned char c : bytes.subspan(1, std::min(length, bytes.size() - 1)))
  {
    if (c == 0) break;
    name += static_cast<char>(c);
  }
  const auto* id = mrpt::rtti::findRegisteredClass(name);
  if (id && !id->ptrCreateObject) throw std::runtime_error("no object can be of the class '" + name + "'");
}

/// An observation that the caller does not need.
bool isSkippable(const ObjectHeader& header, const std::optional<std::set<std::string>>& needed)
{
  const std::string name = withoutNamespace(header.class_name);
  return name.starts_with("CObservation") && needed && needed->count(name) == 0;
}
}  // namespace

RawlogReader::RawlogReader(const std::filesystem::path& path, std::optional<std::set<std::string>> needed)
    : path_(path),
      needed_(std::move(needed)),
      file_(checkRawlogFile(path)),
      content_(std::make_unique<RawlogContent>(path, file_.content))
{
  if (!file_.damage.empty()) findDamagedRecord();
}

RawlogReader::~RawlogReader() = default;

std::string RawlogReader::where() const
{
  return path_.string() + ": record " + std::to_string(entries_ == 0 ? 0 : entries_ - 1) + ": ";
}

RawlogReader::ObjectPtr RawlogReader::next()
{
  while (!content_->atEnd())
    if (auto object = nextEntry()) return object;
  compareWithStatedEntries();
  return nullptr;
}

RawlogReader::ObjectPtr RawlogReader::nextEntry()
{
  const std::string where = path_.string() + ": record " + std::to_string(entries_) + ": ";
  const auto header = headerAt(content_->peek(kLongestHeader));
  const auto is = [&](const char* name) { return header && header->class_name == name; };
  const AllocationLimit limit(kSmallRecord + kMemoryPerByte * content_->bytesLeft());
  try
  {
    if (is(kCommentClass) && header->version <= kLatestCommentVersion)
    {
      auto archive = mrpt::serialization::archiveFrom(*content_);
      comment_ += readComment(archive, *header) + '\n';
      return nullptr;
    }
    auto object = is(kFrameClass) && header->version == kFrameVersion ? readFrame(*header) : readObject(header, false);
    entries_ += is(kCommentClass) ? 0 : 1;
    return object;
  }
  catch (const InputError& error)
  {
    throw dataError(where + error.what());
  }
  catch (const std::bad_alloc&)
  {
    throw dataError(where + "not readable, it states a length of more bytes than the log has left");
  }
  catch (const std::exception& error)
  {
    if (content_->atEnd()) throw dataError(where + "cut off, the log ends in the middle of it");
    throw dataError(where + (entries_ == 0 ? "not readable, expected a rawlog"
                                           : "not readable (" + firstSentence(error.what()) + ")"));
  }
}

/// Observation by observation, so that one that cannot be read is skipped alone.
RawlogReader::ObjectPtr RawlogReader::readFrame(const ObjectHeader& header)
{
  content_->skip(header.size());
  auto archive = mrpt::serialization::archiveFrom(*content_);
  auto frame = mrpt::obs::CSensoryFrame::Create();
  const auto count = archive.ReadAs<std::uint32_t>();
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const auto object = readObject(headerAt(content_->peek(kLongestHeader)), i + 1 == count);
    if (!object) continue;
    const auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(object);
    if (!observation) throw std::runtime_error("a sensory frame holds what is no observation");
    frame->insert(observation);
  }
  if (archive.ReadAs<std::uint8_t>() != kObjectEnd) throw std::runtime_error("the end of the sensory frame is missing");
  return frame;
}

/// Null: skipped.
RawlogReader::ObjectPtr RawlogReader::readObject(const std::optional<ObjectHeader>& header, bool ends_frame)
{
  if (header && unreadable_.count({header->class_name, header->version}) > 0)
  {
    content_->skip(header->size());
    return skip(*header, ends_frame);
  }
  std::optional<UnreadableClass> unreadable;
  expectConcreteClass(content_->peek(kLongestHeader));
  try
  {
    auto object = mrpt::serialization::archiveFrom(*content_).ReadObject();
    if (object) return object;
    throw dataError("empty, expected an observation, a sensory frame or an action collection");
  }
  catch (const InputError&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    if (header) unreadable = unreadableClass(*header, error.what());
    if (!unreadable) throw;
  }
  if (!unreadable->version || !isSkippable(*header, needed_)) throw dataError(unreadable->explanation());
  unreadable_[{header->class_name, header->version}] = unreadable->reason();
  return skip(*header, ends_frame);
}

RawlogReader::ObjectPtr RawlogReader::skip(const ObjectHeader& header, bool ends_frame)
{
  if (!skipObject(*content_, ends_frame)) throw std::runtime_error("its end is missing");
  ++skipped_[{withoutNamespace(header.class_name), unreadable_.at({header.class_name, header.version})}];
  return nullptr;
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
}  // namespace mrpt_ext
