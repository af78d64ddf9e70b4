#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace mrpt_ext
{
/// The whole content of a file, unpacked when it is gzip data (told by its first bytes, not by its name).
/// Throws InputError (data) when the file is missing, unreadable or its gzip data is damaged or cut off.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& path);

/// `path` itself when it exists, else `path`.gz when that exists, else nothing.
[[nodiscard]] std::optional<std::filesystem::path> findPlainOrGzipped(const std::filesystem::path& path);
}  // namespace mrpt_ext
