#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mrpt_ext
{
enum class FieldKind
{
  boolean,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  text,
  structure
};

enum class Multiplicity
{
  single,
  array,    ///< of a fixed length
  sequence  ///< its length is in the message
};

struct MessageField
{
  std::string name;
  FieldKind kind = FieldKind::structure;
  std::size_t structure = 0;  ///< index of its type in the definition
  Multiplicity multiplicity = Multiplicity::single;
  std::uint32_t length = 0;  ///< of an array
};

/// A structure: the fields in their order.
struct MessageType
{
  std::string name;  ///< "geometry_msgs/Pose"
  std::vector<MessageField> fields;
};

/// What a message consists of. The first type is that of the message; no type contains itself.
struct MessageDefinition
{
  std::vector<MessageType> types;
};

/// Parses a definition in the form of .msg files: that of `type` ("pkg/msg/Name"), followed by those of the structures
/// in it, each behind a line "===" and a line "MSG: pkg/Name". Throws DamagedBytes.
[[nodiscard]] MessageDefinition parseMessageDefinition(const std::string& type, std::string_view text);

/// "pkg/Name" of "pkg/msg/Name".
[[nodiscard]] std::string shortTypeName(const std::string& type);
}  // namespace mrpt_ext
