#include <map>
#include <regex>
#include <set>

#include "rules.h"

namespace mrpt_ext::architecture
{
namespace
{
using Names = std::set<std::string>;

/// Folder -> folders it may include. `pipeline` wires everything and is not listed; tests may use anything; apps use
/// `maps` only to register our classes with MRPT.
const std::map<std::string, Names> kAllowed{
    {"geometry", {}},
    {"files", {"geometry"}},
    {"solvers", {"geometry"}},
    {"correspondence", {"geometry", "solvers"}},
    {"likelihood", {"geometry"}},
    {"hypotheses", {"geometry", "solvers", "correspondence", "likelihood"}},
    {"filter", {"geometry", "likelihood", "hypotheses"}},
    {"evaluation", {"geometry", "files"}},
    {"localizers", {"geometry", "solvers", "correspondence", "likelihood", "hypotheses", "filter", "evaluation"}},
    {"simulation", {"geometry", "files"}},
    {"importers", {"geometry", "files"}},
    {"calibration", {"geometry", "localizers"}},
    {"vision", {"geometry"}},
    {"display", {}},
    {"report", {"geometry", "files", "evaluation"}},
    {"observations", {"geometry"}},
    {"maps", {"geometry", "files", "likelihood", "observations"}},
    {"apps", {"pipeline", "maps"}}};

const Names kEigenOnly{"geometry", "files",      "solvers",    "correspondence", "likelihood", "hypotheses",
                       "filter",   "localizers", "evaluation", "simulation",     "importers",  "report"};

const Names kEstimators{"solvers", "correspondence", "likelihood", "hypotheses", "filter", "localizers"};

bool mayUse(const std::string& folder, const std::string& used)
{
  const auto rule = kAllowed.find(folder);
  return rule == kAllowed.end() || folder == used || rule->second.contains(used);
}

/// The text between the quotes or brackets of every #include.
std::vector<std::string> includesOf(const std::string& text)
{
  static const std::regex kInclude(R"rx(^\s*#\s*include\s*([<"][^>"]+)[>"])rx");
  std::vector<std::string> includes;
  for (const std::string& line : linesOf(text))
    if (std::smatch match; std::regex_search(line, match, kInclude)) includes.push_back(match[1]);
  return includes;
}

/// Folder of "mrpt_ext/<folder>/...", empty for anything else.
std::string includedFolder(const std::string& include)
{
  static const std::regex kOurs(R"rx([<"]mrpt_ext/([^/]+)/.*)rx");
  std::smatch match;
  return std::regex_match(include, match, kOurs) ? match[1].str() : "";
}
}  // namespace

Violations checkIncludeDirections(const SourceTree& tree)
{
  Violations found;
  for (const auto& [path, text] : tree)
  {
    const std::string folder = folderOf(path);
    if (!isCpp(path) || folder == "tests") continue;
    for (const std::string& include : includesOf(text))
    {
      const std::string used = includedFolder(include);
      if (used.empty() && include.starts_with('"'))
        found.push_back(path + ": includes " + include +
                        "\", our headers are included as \"mrpt_ext/<folder>/<file>.h\"");
      else if (!used.empty() && !mayUse(folder, used))
        found.push_back(path + ": " + folder + " must not include " + used);
      else if (used == "pipeline" && folder != "pipeline" && folder != "apps")
        found.push_back(path + ": only apps and tests include pipeline");
    }
  }
  return found;
}

Violations checkLinkDirections(const SourceTree& tree)
{
  static const std::regex kTarget(R"(mrpt_ext::(\w+))");
  Violations found;
  for (const auto& [path, text] : tree)
  {
    const std::string folder = folderOf(path);
    if (!path.ends_with("/CMakeLists.txt") || !kAllowed.contains(folder)) continue;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), kTarget); it != std::sregex_iterator(); ++it)
      if (!mayUse(folder, (*it)[1])) found.push_back(path + ": " + folder + " must not link " + (*it)[1].str());
  }
  return found;
}

Violations checkEigenOnlyFolders(const SourceTree& tree)
{
  static const std::regex kFramework(R"rx([<"](mrpt/|opencv).*)rx"), kMrpt(R"rx([<"]mrpt/.*)rx");
  Violations found;
  for (const auto& [path, text] : tree)
  {
    const std::string folder = folderOf(path);
    if (!isCpp(path) || (!kEigenOnly.contains(folder) && folder != "vision")) continue;
    for (const std::string& include : includesOf(text))
      if (std::regex_match(include, folder == "vision" ? kMrpt : kFramework))
        found.push_back(path + ": includes " + include.substr(1));
  }
  return found;
}

Violations checkEstimatorsDoNotSeeTruth(const SourceTree& tree)
{
  static const std::regex kTruth(R"(\w*truth\w*|\bRunContext\b|\bRecording\b)", std::regex::icase);
  Violations found;
  for (const auto& [path, text] : tree)
  {
    if (!isCpp(path) || !kEstimators.contains(folderOf(path))) continue;
    const std::string code = codeOnly(text);
    if (std::smatch match; std::regex_search(code, match, kTruth))
      found.push_back(path + ": names " + match[0].str() + ", estimators never see the truth");
    for (const std::string& include : includesOf(text))
      if (includedFolder(include) == "evaluation" && !include.ends_with("/run_record.h"))
        found.push_back(path + ": includes " + include.substr(1) + ", allowed is evaluation/run_record.h");
  }
  return found;
}
}  // namespace mrpt_ext::architecture
