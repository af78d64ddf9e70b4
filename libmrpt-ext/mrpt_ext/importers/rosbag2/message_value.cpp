#include "mrpt_ext/importers/rosbag2/message_value.h"

#include <utility>

#include "mrpt_ext/importers/rosbag2/cdr_reader.h"

namespace mrpt_ext
{
class MessageDecoder
{
 public:
  MessageDecoder(const MessageDefinition& definition, std::string_view message)
      : definition_(definition), reader_(message)
  {
  }

  MessageValue decode()
  {
    MessageValue value = structure(definition_.types[0]);
    constexpr std::size_t kLargestPadding = 7;  // [bytes]
    if (reader_.left() > kLargestPadding)
      throw DamagedBytes(std::to_string(reader_.left()) + " bytes more than the definition of " +
                         definition_.types[0].name + " has");
    return value;
  }

 private:
  MessageValue structure(const MessageType& type)
  {
    MessageValue value;
    value.type_ = &type;
    std::vector<MessageValue> fields;
    for (const MessageField& field : type.fields) fields.push_back(valueOf(field));
    if (type.fields.empty()) static_cast<void>(reader_.number<std::uint8_t>());  // what stands for no field
    value.value_ = std::move(fields);
    return value;
  }

  MessageValue valueOf(const MessageField& field)
  {
    if (field.multiplicity == Multiplicity::single) return single(field);
    const bool is_sequence = field.multiplicity == Multiplicity::sequence;
    // Every value takes a byte at least.
    const std::uint32_t length = is_sequence ? reader_.sequenceLength(1) : field.length;
    if (field.kind == FieldKind::text || field.kind == FieldKind::structure) return listOf(field, length);
    std::vector<double> numbers;
    for (std::uint32_t i = 0; i < length; ++i) numbers.push_back(number(field.kind));
    MessageValue value;
    value.value_ = std::move(numbers);
    return value;
  }

  MessageValue listOf(const MessageField& field, std::uint32_t length)
  {
    std::vector<MessageValue> values;
    for (std::uint32_t i = 0; i < length; ++i) values.push_back(single(field));
    MessageValue value;
    value.value_ = std::move(values);
    return value;
  }

  MessageValue single(const MessageField& field)
  {
    if (field.kind == FieldKind::structure)
    {
      count();
      return structure(definition_.types[field.structure]);
    }
    MessageValue value;
    if (field.kind == FieldKind::text)
    {
      count();
      value.value_ = std::string(reader_.text());
    }
    else
      value.value_ = number(field.kind);
    return value;
  }

  double number(FieldKind kind)
  {
    count();
    switch (kind)
    {
      case FieldKind::int8:
        return static_cast<double>(reader_.number<std::int8_t>());
      case FieldKind::int16:
        return static_cast<double>(reader_.number<std::int16_t>());
      case FieldKind::uint16:
        return static_cast<double>(reader_.number<std::uint16_t>());
      case FieldKind::int32:
        return static_cast<double>(reader_.number<std::int32_t>());
      case FieldKind::uint32:
        return static_cast<double>(reader_.number<std::uint32_t>());
      case FieldKind::int64:
        return static_cast<double>(reader_.number<std::int64_t>());
      case FieldKind::uint64:
        return static_cast<double>(reader_.number<std::uint64_t>());
      case FieldKind::float32:
        return static_cast<double>(reader_.number<float>());
      case FieldKind::float64:
        return reader_.number<double>();
      default:
        return static_cast<double>(reader_.number<std::uint8_t>());
    }
  }

  void count()
  {
    if (++values_ > kMostValues)
      throw DamagedBytes("more than " + std::to_string(kMostValues) + " values in a message");
  }

  const MessageDefinition& definition_;
  CdrReader reader_;
  std::size_t values_ = 0;
};

const MessageValue* MessageValue::find(std::string_view path) const
{
  const MessageValue* value = this;
  while (!path.empty())
  {
    const std::string_view name = path.substr(0, path.find('.'));
    path.remove_prefix(std::min(path.size(), name.size() + 1));
    if (!value->type_) return nullptr;
    const auto& fields = value->type_->fields;
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.name == name; });
    if (field == fields.end()) return nullptr;
    value = &std::get<std::vector<MessageValue>>(value->value_)[static_cast<std::size_t>(field - fields.begin())];
  }
  return value;
}

const MessageValue& MessageValue::at(std::string_view path) const
{
  const MessageValue* value = find(path);
  if (!value) throw DamagedBytes("the definition of the message has no field " + std::string(path));
  return *value;
}

const std::vector<MessageValue>& MessageValue::list(std::string_view path) const
{
  if (at(path).type_) failAt(path, "a list");
  return kindAt<std::vector<MessageValue>>(path, "a list");
}

void MessageValue::failAt(std::string_view path, const char* expected)
{
  throw DamagedBytes("the field " + std::string(path) + " of the message's definition is not " + expected);
}

MessageValue decodeMessage(const MessageDefinition& definition, std::string_view message)
{
  return MessageDecoder(definition, message).decode();
}
}  // namespace mrpt_ext
