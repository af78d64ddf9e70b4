#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace mrpt_ext
{
/// The whole content of a file, decompressed when it is gzip data (by its first bytes, not by its name).
/// Throws InputError (data) when the file is missing, unreadable or its gzip data is damaged or cut off, and where it
/// holds more than kLargestText: a small file may unpack to any size.
inline constexpr std::size_t kLargestText = 256 << 20;  // [bytes]
[[nodiscard]] std::string readTextFile(const std::filesystem::path& path);

/// The same line by line, without the ends "\n", so that a long file takes no memory. Damage is reported when it
/// is reached; the last line of a damaged file is not passed on. A line of more than kLongestLine is damage.
inline constexpr std::size_t kLongestLine = 1 << 20;  // [bytes]
void forEachLine(const std::filesystem::path& path, const std::function<void(std::string_view)>& take);

/// `path` itself when it exists, else `path`.gz when that exists, else nothing.
[[nodiscard]] std::optional<std::filesystem::path> findPlainOrGzipped(const std::filesystem::path& path);
}  // namespace mrpt_ext
