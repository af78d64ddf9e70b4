#pragma once

#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace mrpt_ext
{
class ByteArchive;

/// Rows as bytes, for files that only the same process reads. A row names its fields once, for both directions:
///   template <class Self, class Archive> static void archive(Self& row, Archive& fields) { fields(row.time, row.name);
///   }
/// A field is a plain value, a string, an optional, a matrix of fixed size, or a row itself.
template <typename Row>
concept ArchivedRow = requires(Row& row, ByteArchive& fields)
{
  Row::archive(row, fields);
};

template <typename Field>
concept FixedMatrix = requires
{
  Field::SizeAtCompileTime;
};

class ByteArchive
{
 public:
  ByteArchive() = default;  ///< takes fields up, which stay as they are
  /// Fills fields in the order in which they were taken up.
  explicit ByteArchive(std::string bytes) : bytes_(std::move(bytes)), reads_(true) {}

  template <typename... Fields>
  void operator()(Fields&... fields)
  {
    (transfer(fields), ...);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <typename Field>
  void transfer(Field& field)
  {
    if constexpr (ArchivedRow<Field>)
      Field::archive(field, *this);
    else if constexpr (FixedMatrix<Field>)
      transferBytes(field.data(), sizeof(*field.data()) * static_cast<std::size_t>(field.size()));
    else
    {
      static_assert(std::is_trivially_copyable_v<Field>);
      transferBytes(&field, sizeof(Field));
    }
  }
  void transfer(std::string& text)
  {
    std::size_t size = text.size();
    transfer(size);
    text.resize(size);
    transferBytes(text.data(), size);
  }
  template <typename Value>
  void transfer(std::optional<Value>& value)
  {
    bool exists = value.has_value();
    transfer(exists);
    if (exists)
      transfer(value ? *value : value.emplace());
    else
      value.reset();
  }
  void transferBytes(void* data, std::size_t size)
  {
    if (!reads_)
    {
      bytes_.append(static_cast<const char*>(data), size);
      return;
    }
    std::memcpy(data, bytes_.data() + read_, size);
    read_ += size;
  }

  std::string bytes_;
  bool reads_ = false;
  std::size_t read_ = 0;  ///< bytes
};
}  // namespace mrpt_ext
