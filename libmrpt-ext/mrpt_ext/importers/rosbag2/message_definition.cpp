#include "mrpt_ext/importers/rosbag2/message_definition.h"

#include <algorithm>
#include <map>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/trimmed.h"
#include "mrpt_ext/importers/rosbag2/byte_reader.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kLargestDefinition = 1 << 20;  // [bytes]
constexpr std::size_t kMostTypes = 1000;

const std::map<std::string, FieldKind, std::less<>>& primitives()
{
  static const std::map<std::string, FieldKind, std::less<>> kPrimitives = {
      {"bool", FieldKind::boolean},    {"byte", FieldKind::uint8},    {"char", FieldKind::uint8},
      {"int8", FieldKind::int8},       {"uint8", FieldKind::uint8},   {"int16", FieldKind::int16},
      {"uint16", FieldKind::uint16},   {"int32", FieldKind::int32},   {"uint32", FieldKind::uint32},
      {"int64", FieldKind::int64},     {"uint64", FieldKind::uint64}, {"float32", FieldKind::float32},
      {"float64", FieldKind::float64}, {"string", FieldKind::text}};
  return kPrimitives;
}

/// A type's text with the names of structures, which are resolved when all are known.
struct ParsedType
{
  MessageType type;
  std::vector<std::string> structures;  ///< by field; empty for other kinds
};

std::string_view takeLine(std::string_view& text)
{
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return trimmed(line.substr(0, line.find('#')));
}

/// The brackets behind a type: "", "[]", "[<=5]", "[5]".
void readMultiplicity(MessageField& field, std::string_view brackets)
{
  if (brackets.empty()) return;
  if (brackets.size() < 2 || brackets.front() != '[' || brackets.back() != ']')
    throw DamagedBytes("'" + std::string(brackets) + "' in the definition, expected [], [N] or [<=N]");
  const std::string_view length = brackets.substr(1, brackets.size() - 2);
  field.multiplicity = length.empty() || length.starts_with('<') ? Multiplicity::sequence : Multiplicity::array;
  if (field.multiplicity == Multiplicity::sequence) return;
  const auto number = parseInteger(length);
  if (!number || *number < 1) throw DamagedBytes("array of length '" + std::string(length) + "' in the definition");
  field.length = static_cast<std::uint32_t>(*number);
}

/// "Name" in pkg/Other is pkg/Name; some names stand for themselves.
std::string fullName(std::string_view name, const std::string& within)
{
  if (name == "Header") return "std_msgs/Header";
  if (name == "time") return "builtin_interfaces/Time";
  if (name == "duration") return "builtin_interfaces/Duration";
  if (name.find('/') != std::string_view::npos) return shortTypeName(std::string(name));
  return within.substr(0, within.find('/') + 1) + std::string(name);
}

void addField(ParsedType& parsed, std::string_view line)
{
  const std::size_t blank = line.find_first_of(kBlanks);
  if (blank == std::string_view::npos)
    throw DamagedBytes("'" + std::string(line) + "' in the definition, expected type and name");
  const std::string_view type = line.substr(0, blank), rest = trimmed(line.substr(blank));
  const std::size_t name_end = std::min(rest.find_first_of(" \t="), rest.size());
  if (trimmed(rest.substr(name_end)).starts_with('=')) return;  // a constant
  MessageField field;
  field.name = std::string(rest.substr(0, name_end));
  const std::size_t base_end = std::min(type.find_first_of("[<"), type.size());
  const std::string_view base = type.substr(0, base_end);
  readMultiplicity(field, type.substr(std::min(type.find('[', base_end), type.size())));
  std::string structure;
  if (const auto primitive = primitives().find(base); primitive != primitives().end())
    field.kind = primitive->second;
  else if (base == "wstring")
    throw DamagedBytes("a wstring in the definition, expected other types");
  else
    structure = fullName(base, parsed.type.name);
  parsed.type.fields.push_back(std::move(field));
  parsed.structures.push_back(std::move(structure));
}

std::vector<ParsedType> parseTypes(const std::string& type, std::string_view text)
{
  std::vector<ParsedType> types(1);
  types[0].type.name = shortTypeName(type);
  while (!text.empty())
  {
    const std::string_view line = takeLine(text);
    if (line.empty() || line.starts_with("===")) continue;
    if (line.starts_with("MSG:"))
    {
      if (types.size() == kMostTypes) throw DamagedBytes("more than 1000 types in the definition");
      types.emplace_back().type.name = shortTypeName(std::string(trimmed(line.substr(4))));
    }
    else
      addField(types.back(), line);
  }
  // What some writers take for known; where the text defines it, that is found first.
  for (const char* name : {"builtin_interfaces/Time", "builtin_interfaces/Duration"})
  {
    types.emplace_back().type.name = name;
    addField(types.back(), "int32 sec");
    addField(types.back(), "uint32 nanosec");
  }
  return types;
}

/// Visits a type and the types in it once each, which none of them may lead back to.
class CycleCheck
{
 public:
  explicit CycleCheck(const MessageDefinition& definition)
      : definition_(definition), states_(definition.types.size(), State::unseen)
  {
  }
  void visit(std::size_t type)
  {
    if (states_[type] == State::entered) throw DamagedBytes(definition_.types[type].name + " contains itself");
    if (states_[type] == State::left) return;
    states_[type] = State::entered;
    for (const MessageField& field : definition_.types[type].fields)
      if (field.kind == FieldKind::structure) visit(field.structure);
    states_[type] = State::left;
  }

 private:
  enum class State
  {
    unseen,
    entered,
    left
  };
  const MessageDefinition& definition_;
  std::vector<State> states_;
};
}  // namespace

std::string shortTypeName(const std::string& type)
{
  const std::size_t middle = type.find("/msg/");
  return middle == std::string::npos ? type : type.substr(0, middle) + type.substr(middle + 4);
}

MessageDefinition parseMessageDefinition(const std::string& type, std::string_view text)
{
  if (text.size() > kLargestDefinition) throw DamagedBytes("a definition of more than a megabyte");
  const std::vector<ParsedType> parsed = parseTypes(type, text);
  std::map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < parsed.size(); ++i) index.try_emplace(parsed[i].type.name, i);
  MessageDefinition definition;
  for (const ParsedType& one : parsed)
  {
    MessageType& added = definition.types.emplace_back(one.type);
    for (std::size_t i = 0; i < added.fields.size(); ++i)
    {
      if (one.structures[i].empty()) continue;
      const auto found = index.find(one.structures[i]);
      if (found == index.end()) throw DamagedBytes("no definition of " + one.structures[i] + ", which is in " + type);
      added.fields[i].structure = found->second;
    }
  }
  CycleCheck(definition).visit(0);
  return definition;
}
}  // namespace mrpt_ext
