#pragma once

#include <string_view>

#include "mrpt_ext/importers/rosbag2/byte_reader.h"

namespace mrpt_ext
{
/// Takes values off a message in CDR (OMG Common Data Representation, version 1; ROS 2's form, with its header of four
/// bytes), little or big endian. Numbers are aligned to their size. Throws DamagedBytes.
class CdrReader
{
 public:
  explicit CdrReader(std::string_view message);

  template <typename Number>
  [[nodiscard]] Number number()
  {
    const std::size_t padding = (sizeof(Number) - at_ % sizeof(Number)) % sizeof(Number);
    return numberAt<Number>(take(padding + sizeof(Number)).data() + padding, order_);
  }
  [[nodiscard]] std::string_view text();
  /// Number of elements of a sequence, each of which takes at least `least_size` bytes.
  [[nodiscard]] std::uint32_t sequenceLength(std::size_t least_size);
  /// Bytes behind what was taken.
  [[nodiscard]] std::size_t left() const { return body_.size() - at_; }

 private:
  std::string_view take(std::size_t count);

  std::string_view body_;  // behind the header, where alignment counts from
  std::size_t at_ = 0;
  std::endian order_ = std::endian::little;
};
}  // namespace mrpt_ext
