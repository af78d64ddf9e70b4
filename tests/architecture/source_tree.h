#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mrpt_ext::architecture
{
/// The text files of a source tree by path relative to its root. A sample tree in a test is written down directly.
using SourceTree = std::map<std::string, std::string>;

/// Reads the tree at `root`, without dot-folders, `build*` and `out` at the top, and files that are not text.
[[nodiscard]] SourceTree readTree(const std::filesystem::path& root);

/// Names of the entries at the top of the tree at `root`, without those that .gitignore keeps out.
[[nodiscard]] std::vector<std::string> topLevelEntries(const std::filesystem::path& root);

/// Path below an include root: "libmrpt-ext/mrpt_ext/solvers/x.h" -> "mrpt_ext/solvers/x.h"; "" for anything else.
[[nodiscard]] std::string ourPath(const std::string& path);

/// The room, which is the path part after "mrpt_ext/", else the top folder: "libmrpt-ext/mrpt_ext/filter/kalman/x.h" ->
/// "filter", "mrpt_ext/maps/x.h" -> "maps", "apps/a/main.cpp" -> "apps", "README.md" -> "".
[[nodiscard]] std::string folderOf(const std::string& path);

/// Within the room: "libmrpt-ext/mrpt_ext/filter/kalman/x.h" -> "kalman", "libmrpt-ext/mrpt_ext/filter/x.h" -> "".
[[nodiscard]] std::string subfolderOf(const std::string& path);

[[nodiscard]] bool isCpp(const std::string& path);
/// Part of the Python module, which uses the library as an app does and is not installed with it.
[[nodiscard]] bool isPython(const std::string& path);
[[nodiscard]] bool isHeader(const std::string& path);

[[nodiscard]] std::vector<std::string> linesOf(const std::string& text);

/// C++ text without comments and string literals (raw strings are not understood).
[[nodiscard]] std::string codeOnly(const std::string& text);
}  // namespace mrpt_ext::architecture
