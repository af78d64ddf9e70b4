#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace mrpt_ext
{
/// Properties of a (usually compressed) rawlog from one pass over its bytes, before any record is read.
struct RawlogFileCheck
{
  std::string sha256;         ///< of the file as it is on disk, lower-case hexadecimal
  bool compressed = false;    ///< with gzip or zstd
  std::uint64_t content = 0;  ///< bytes after decompression, as far as they could be decompressed
  std::string damage;         ///< what is wrong with the compression; empty: lengths and checksums are right
};

/// Reads the whole file once. Throws InputError (data) when it is missing, not readable or empty.
/// MRPT's streams take the end of a truncated gzip file for its end; here its end and its checksum must be present. The
/// zstd logs of MRPT itself have no checksum (those of the tool zstd have).
[[nodiscard]] RawlogFileCheck checkRawlogFile(const std::filesystem::path& path);
}  // namespace mrpt_ext
