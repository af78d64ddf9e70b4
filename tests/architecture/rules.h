#pragma once

#include <string>
#include <vector>

#include "source_tree.h"

namespace mrpt_ext::architecture
{
/// What is wrong, one line each, starting with the path; empty when the rule holds.
using Violations = std::vector<std::string>;

// Who may use whom (include_rules.cpp).

/// A room includes only the rooms that its position in the data flow allows, and always as "mrpt_ext/<room>/<file>.h";
/// the same between the sub-folders of a room.
[[nodiscard]] Violations checkIncludeDirections(const SourceTree& tree);
/// "mrpt_ext/<path>" is the path of a file below one of the include roots, in the tree as it is checked out.
[[nodiscard]] Violations checkIncludePaths(const SourceTree& tree);
/// No unit (a header and its source) includes another one that includes it, directly or through others.
[[nodiscard]] Violations checkUnitCycles(const SourceTree& tree);
/// A folder's CMakeLists.txt links only the folders that it may include.
[[nodiscard]] Violations checkLinkDirections(const SourceTree& tree);
/// The Eigen-only folders include neither MRPT nor OpenCV, and vision no MRPT.
[[nodiscard]] Violations checkEigenOnlyFolders(const SourceTree& tree);
/// Estimators never name the truth, nor a type that carries it.
[[nodiscard]] Violations checkEstimatorsDoNotSeeTruth(const SourceTree& tree);

// What the tree looks like (tree_rules.cpp).

[[nodiscard]] Violations checkTopLevel(const std::vector<std::string>& entries);
/// At most 400 lines per C++ file, at most 50 per apps/<name>/main.cpp.
[[nodiscard]] Violations checkFileLengths(const SourceTree& tree);
/// At most 5000 lines of C++ per folder of the library.
[[nodiscard]] Violations checkFolderSizes(const SourceTree& tree);
/// A type name at namespace scope stands in one header: two types of one name in one namespace break the
/// one-definition rule as soon as a program links both.
[[nodiscard]] Violations checkTypeNames(const SourceTree& tree);
/// Every .cpp stands in the CMakeLists.txt of its folder; no globbing.
[[nodiscard]] Violations checkSourceLists(const SourceTree& tree);
/// Every third-party package that the libraries look up is looked up again for users of the installed library.
[[nodiscard]] Violations checkPackageConfig(const SourceTree& tree);
/// Every ini/<app>/<name>.ini is named by a test: one file under tests/ that names both the app and the file.
[[nodiscard]] Violations checkConfigurationsAreTested(const SourceTree& tree);
/// The default of a key is read from the struct that holds the option, or from a named constant: no number, true or
/// false stands where configuration/*_keys.cpp gives a KeySection the default of a number or a flag.
[[nodiscard]] Violations checkKeyDefaults(const SourceTree& tree);
/// Every source file, script and configuration that README.md and CONTRIBUTING.md name exists.
[[nodiscard]] Violations checkDocumentsNameFiles(const SourceTree& tree);
/// No marks of unfinished work, no paths of one machine.
[[nodiscard]] Violations checkText(const SourceTree& tree);
}  // namespace mrpt_ext::architecture
