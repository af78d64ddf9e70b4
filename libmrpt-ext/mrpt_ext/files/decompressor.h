#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace mrpt_ext
{
/// How a file is compressed, known by its first bytes (its "magic").
enum class Compression
{
  none,
  gzip,
  zstd  ///< also where a skippable frame comes first
};

[[nodiscard]] Compression compressionOf(std::span<const unsigned char> start);

/// Compressed bytes in, decompressed bytes out, piece by piece. Concatenated gzip members or zstd frames are one
/// content. Strict: lengths and checksums are compared, and the end must be there.
class Decompressor
{
 public:
  virtual ~Decompressor() = default;

  /// Takes bytes off the front of `in`, and returns the number of bytes that it has written to the front of `out`. When
  /// it fills `out`, more may come without further input. After damage it returns 0.
  [[nodiscard]] virtual std::size_t decompress(std::span<const unsigned char>& in, std::span<unsigned char> out) = 0;
  /// What is wrong so far; empty: nothing.
  [[nodiscard]] virtual const std::string& damage() const = 0;
  /// The bytes may end here.
  [[nodiscard]] virtual bool complete() const = 0;
};

[[nodiscard]] std::unique_ptr<Decompressor> makeDecompressor(Compression compression);
}  // namespace mrpt_ext
