#pragma once

#include <filesystem>
#include <string_view>

namespace mrpt_ext
{
/// Writes a file so that readers see either the old content or all of the new: under a temporary name in the same
/// folder, then renamed. Missing parent folders are created. Throws InputError (data) when the place is not writable
/// or the disk is full; no temporary file is left behind then.
void writeFileAtomically(const std::filesystem::path& path, std::string_view content);

/// A name beside `path` for writers that stream into a file themselves; follow with renameIntoPlace().
[[nodiscard]] std::filesystem::path temporaryNameFor(const std::filesystem::path& path);

/// Renames `temporary` to `path`; on failure removes `temporary` and throws InputError (data).
void renameIntoPlace(const std::filesystem::path& temporary, const std::filesystem::path& path);
}  // namespace mrpt_ext
