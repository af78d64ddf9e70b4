#include "mrpt_ext/importers/rosbag2/mcap_reader.h"

#include <zlib.h>

#include <fstream>
#include <map>
#include <optional>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/rosbag2/block_decompression.h"
#include "mrpt_ext/importers/rosbag2/byte_reader.h"

namespace mrpt_ext
{
namespace
{
constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr std::uint64_t kLargestRecord = 1 << 28;  // [bytes] also unpacked

enum Opcode : std::uint8_t
{
  kNone = 0x00,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kDataEnd = 0x0F
};

/// Opcode and length before every record.
struct RecordHead
{
  static constexpr std::uint64_t kSize = 9;  // [bytes]
  std::uint8_t opcode = kNone;
  std::uint64_t length = 0;
};

RecordHead headOf(ByteReader& bytes)
{
  const auto opcode = bytes.number<std::uint8_t>();
  return {opcode, bytes.number<std::uint64_t>()};
}

/// Schemas and channels so far, and what is done with a record.
class McapRecords
{
 public:
  explicit McapRecords(const BagMessageSink& sink) : sink_(sink) {}

  void take(std::uint8_t opcode, std::string_view content)
  {
    if (opcode == kSchema) addSchema(ByteReader(content));
    if (opcode == kChannel) addChannel(ByteReader(content));
    if (opcode == kMessage) passOn(ByteReader(content));
    if (opcode == kChunk) unpack(ByteReader(content));
  }
  static bool isNeeded(std::uint8_t opcode)
  {
    return opcode == kSchema || opcode == kChannel || opcode == kMessage || opcode == kChunk;
  }

 private:
  struct Schema
  {
    std::string type, definition;
  };

  void addSchema(ByteReader record)
  {
    const auto id = record.number<std::uint16_t>();
    const std::string type(record.block()), format(record.block());
    schemas_[id] = {type, format == "ros2msg" ? std::string(record.block()) : std::string()};
  }

  void addChannel(ByteReader record)
  {
    const auto id = record.number<std::uint16_t>();
    const auto schema = schemas_[record.number<std::uint16_t>()];
    const std::string name(record.block()), encoding(record.block());
    // A repeated channel is the same one; messages may still refer to it.
    topics_.try_emplace(id, BagTopic{name, schema.type, encoding, schema.definition});
  }

  void passOn(ByteReader record)
  {
    const auto channel = record.number<std::uint16_t>();
    const auto topic = topics_.find(channel);
    if (topic == topics_.end())
      throw DamagedBytes("a message of channel " + std::to_string(channel) + ", which was not declared before");
    static_cast<void>(record.number<std::uint32_t>());  // its number in the channel
    const auto nanoseconds = record.number<std::uint64_t>();
    static_cast<void>(record.number<std::uint64_t>());  // time of publication
    sink_({topic->second, static_cast<double>(nanoseconds) * 1e-9, messages_++, record.rest()});
  }

  void unpack(ByteReader record)
  {
    static_cast<void>(record.take(16));  // first and last time
    const auto size = record.number<std::uint64_t>();
    const auto checksum = record.number<std::uint32_t>();
    const std::string_view method = record.block();
    const auto packed_size = record.number<std::uint64_t>();
    if (size > kLargestRecord)
      throw DamagedBytes("a chunk of " + std::to_string(size) + " bytes, expected at most 2^28");
    const std::string content = decompressedBlock(record.take(packed_size), method, size);
    if (content.size() != size)
      throw DamagedBytes("a chunk of " + std::to_string(content.size()) + " bytes, but it states " +
                         std::to_string(size));
    const auto* bytes = reinterpret_cast<const Bytef*>(content.data());
    if (checksum != 0 && checksum != crc32(0, bytes, static_cast<uInt>(content.size())))
      throw DamagedBytes("the checksum of the chunk is wrong");
    for (ByteReader records(content); !records.rest().empty();)
    {
      const RecordHead head = headOf(records);
      if (head.opcode == kChunk) throw DamagedBytes("a chunk within a chunk");
      take(head.opcode, records.take(head.length));
    }
  }

  const BagMessageSink& sink_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, BagTopic> topics_;
  std::uint64_t messages_ = 0;
};

/// A file of known size, read from front to back.
class McapFile
{
 public:
  explicit McapFile(const std::filesystem::path& path) : path_(path), stream_(path, std::ios::binary)
  {
    if (!stream_) throw dataError(path.string() + ": cannot be opened");
    stream_.seekg(0, std::ios::end);
    size_ = static_cast<std::uint64_t>(stream_.tellg());
    const std::uint64_t end = size_ < kMagic.size() ? 0 : size_ - kMagic.size();
    seek(end);
    has_end_ = isMcap(read(kMagic.size())) && end > 0;
    seek(0);
    if (!isMcap(read(kMagic.size()))) throw dataError(path.string() + ": no MCAP file");
  }

  [[nodiscard]] std::uint64_t position() const { return position_; }
  [[nodiscard]] std::uint64_t left() const { return size_ - position_; }
  [[nodiscard]] bool hasEnd() const { return has_end_; }  ///< the closing bytes of a finished recording
  [[nodiscard]] std::string where() const
  {
    return path_.string() + ": record at byte " + std::to_string(position_) + ": ";
  }

  /// The next bytes, fewer at the end of the file.
  std::string read(std::uint64_t count)
  {
    std::string bytes(std::min(count, left()), '\0');
    stream_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream_) throw dataError(where() + "cannot be read");
    position_ += bytes.size();
    return bytes;
  }
  void seek(std::uint64_t position)
  {
    stream_.seekg(static_cast<std::streamoff>(position));
    position_ = position;
  }

 private:
  std::filesystem::path path_;
  std::ifstream stream_;
  std::uint64_t size_ = 0, position_ = 0;
  bool has_end_ = false;
};

/// Head of the record at the position of the file; nothing where a recording was cut off.
std::optional<RecordHead> nextHead(McapFile& file)
{
  const std::string where = file.where();
  const std::uint64_t begin = file.position();
  const std::string bytes = file.read(RecordHead::kSize);
  RecordHead head;
  if (bytes.size() == RecordHead::kSize)
  {
    ByteReader reader(bytes);
    head = headOf(reader);
  }
  if (head.opcode != kNone && head.length <= file.left()) return head;
  if (file.hasEnd()) throw dataError(where + "goes beyond the end of the file");
  file.seek(begin);
  return std::nullopt;
}
}  // namespace

bool isMcap(std::string_view start) { return start.starts_with(kMagic); }

std::vector<std::string> readMcap(const std::filesystem::path& path, const BagMessageSink& sink)
{
  McapFile file(path);
  McapRecords records(sink);
  while (true)
  {
    const std::string where = file.where();
    const auto head = nextHead(file);
    if (!head)
      return {path.string() + ": the recording was cut off, read up to its last whole record (" +
              std::to_string(file.left()) + " bytes left out)"};
    if (head->opcode == kDataEnd || head->opcode == kFooter) return {};
    if (!McapRecords::isNeeded(head->opcode))
    {
      file.seek(file.position() + head->length);
      continue;
    }
    if (head->length > kLargestRecord) throw dataError(where + "longer than 2^28 bytes");
    try
    {
      records.take(head->opcode, file.read(head->length));
    }
    catch (const DamagedBytes& damage)
    {
      throw dataError(where + damage.what());
    }
  }
}
}  // namespace mrpt_ext
