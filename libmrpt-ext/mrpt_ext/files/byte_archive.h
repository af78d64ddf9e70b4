#pragma once

#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace mrpt_ext
{
/// Rows as bytes, for files that only the same process reads. A row names its fields once, for both directions:
///   template <class Self, class Archive> static void archive(Self& row, Archive& fields) { fields(row.time, row.name);
///   }
/// A field is a plain value, a string, an optional, a matrix of fixed size, or a row itself.
template <typename Row, typename Archive>
concept ArchivedRow = requires(Row& row, Archive& fields)
{
  std::remove_const_t<Row>::archive(row, fields);
};

template <typename Field>
concept FixedMatrix = requires
{
  std::remove_const_t<Field>::SizeAtCompileTime;
};

class ByteWriter
{
 public:
  template <typename... Fields>
  void operator()(const Fields&... fields)
  {
    (put(fields), ...);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <typename Field>
  void put(const Field& field)
  {
    if constexpr (ArchivedRow<const Field, ByteWriter>)
      Field::archive(field, *this);
    else if constexpr (FixedMatrix<Field>)
      putRaw(field.data(), sizeof(*field.data()) * static_cast<std::size_t>(field.size()));
    else
    {
      static_assert(std::is_trivially_copyable_v<Field>);
      putRaw(&field, sizeof(Field));
    }
  }
  void put(const std::string& text)
  {
    put(text.size());
    putRaw(text.data(), text.size());
  }
  template <typename Value>
  void put(const std::optional<Value>& value)
  {
    put(value.has_value());
    if (value) put(*value);
  }
  void putRaw(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }

  std::string bytes_;
};

class ByteReader
{
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <typename... Fields>
  void operator()(Fields&... fields)
  {
    (get(fields), ...);
  }

 private:
  template <typename Field>
  void get(Field& field)
  {
    if constexpr (ArchivedRow<Field, ByteReader>)
      Field::archive(field, *this);
    else if constexpr (FixedMatrix<Field>)
      getRaw(field.data(), sizeof(*field.data()) * static_cast<std::size_t>(field.size()));
    else
    {
      static_assert(std::is_trivially_copyable_v<Field>);
      getRaw(&field, sizeof(Field));
    }
  }
  void get(std::string& text)
  {
    std::size_t size = 0;
    get(size);
    text.assign(rest_.substr(0, size));
    rest_.remove_prefix(size);
  }
  template <typename Value>
  void get(std::optional<Value>& value)
  {
    bool exists = false;
    get(exists);
    value.reset();
    if (exists) get(value.emplace());
  }
  void getRaw(void* data, std::size_t size)
  {
    std::memcpy(data, rest_.data(), size);
    rest_.remove_prefix(size);
  }

  std::string_view rest_;
};
}  // namespace mrpt_ext
