#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace mrpt_ext
{
/// Bytes that end too early or state what cannot be. Whoever knows file and record makes an InputError of it.
class DamagedBytes : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/// The number at the front of `bytes`, which hold enough of them.
template <typename Number>
[[nodiscard]] Number numberAt(const char* bytes, std::endian order = std::endian::little)
{
  std::array<char, sizeof(Number)> copy;
  std::memcpy(copy.data(), bytes, sizeof(Number));
  if (order != std::endian::native) std::reverse(copy.begin(), copy.end());
  return std::bit_cast<Number>(copy);
}

/// Takes little-endian fields off the front of a record. Throws DamagedBytes beyond its end.
class ByteReader
{
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename Number>
  [[nodiscard]] Number number()
  {
    return numberAt<Number>(take(sizeof(Number)).data());
  }
  [[nodiscard]] std::string_view take(std::uint64_t count)
  {
    if (count > bytes_.size()) throw DamagedBytes("a field goes beyond the end of its record");
    const std::string_view front = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return front;
  }
  /// A text or block behind its 32-bit length.
  [[nodiscard]] std::string_view block() { return take(number<std::uint32_t>()); }
  [[nodiscard]] std::string_view rest() const { return bytes_; }

 private:
  std::string_view bytes_;
};
}  // namespace mrpt_ext
