#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace mrpt_ext
{
/// Content of a compressed block; `method` is "", "lz4" or "zstd" (frames), as MCAP names them. Memory grows with what
/// comes out, never by a stated size. Throws DamagedBytes for an unknown method, damaged data, and more than `limit`.
[[nodiscard]] std::string decompressedBlock(std::string_view block, std::string_view method, std::uint64_t limit);

/// Unpacks a zstd file into another one. Throws InputError (data) when it is damaged or cut off, or the disk is full.
void decompressZstdFile(const std::filesystem::path& from, const std::filesystem::path& to);
}  // namespace mrpt_ext
