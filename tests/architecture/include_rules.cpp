#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "rules.h"

namespace mrpt_ext::architecture
{
namespace
{
using Names = std::set<std::string>;

/// Room -> rooms it may include. `app` wires everything and is not listed; tests may use anything; apps use `maps` only
/// to register our classes with MRPT.
const std::map<std::string, Names> kAllowed{
    {"geometry", {}},
    {"files", {"geometry"}},
    {"solvers", {"geometry"}},
    {"calibration", {"geometry", "solvers"}},
    {"likelihood", {"geometry"}},
    {"correspondence", {"geometry", "solvers", "likelihood"}},
    {"hypotheses", {"geometry", "solvers", "correspondence", "likelihood"}},
    {"filter", {"geometry", "likelihood", "hypotheses"}},
    {"relocalization", {"geometry", "solvers", "correspondence", "likelihood", "hypotheses", "filter"}},
    {"localizers", {"geometry", "solvers", "correspondence", "likelihood", "hypotheses", "filter", "relocalization"}},
    {"evaluation", {"geometry", "files"}},
    {"simulation", {"geometry", "files"}},
    {"importers", {"geometry", "files"}},
    {"vision", {"geometry"}},
    {"display", {"observations"}},
    {"report", {"geometry", "files", "evaluation"}},
    {"observations", {"geometry"}},
    {"maps", {"geometry", "files", "likelihood", "observations"}},
    {"settings", {"geometry", "files"}},
    {"frames", {"geometry"}},
    {"configuration", {"geometry", "files", "settings", "frames", "evaluation", "filter", "localizers", "simulation"}},
    {"online", {"geometry", "files", "correspondence", "filter", "localizers", "settings", "frames", "configuration"}},
    {"rawlog", {"geometry", "files", "frames", "importers", "observations"}},
    {"front_ends", {"geometry", "files", "settings", "rawlog", "observations", "solvers", "vision"}},
    {"scene", {"geometry", "files", "evaluation", "localizers", "observations", "maps", "display"}},
    {"experiment",
     {"geometry", "files", "solvers", "correspondence", "likelihood", "hypotheses", "filter", "relocalization",
      "localizers", "evaluation", "observations", "maps", "settings", "frames", "configuration", "rawlog", "scene"}},
    {"diagnosis",
     {"geometry", "files", "solvers", "hypotheses", "settings", "configuration", "experiment", "calibration",
      "evaluation"}},
    {"apps", {"app", "app_datasets", "app_images", "app_simulator", "maps"}}};

/// The same between the sub-folders of a room, whose top folder is "": folder -> folders it may include.
const std::map<std::string, std::map<std::string, Names>> kAllowedWithin{
    {"correspondence",
     {{"", {"tree", "bearings", "points"}}, {"tree", {""}}, {"bearings", {""}}, {"points", {""}}, {"local_map", {""}}}},
    {"filter",
     {{"", {"particles", "motion", "modes", "integrity", "kalman", "consider"}},
      {"particles", {}},
      {"motion", {"particles"}},
      {"modes", {"particles"}},
      {"integrity", {"particles", "motion", "modes"}},
      {"kalman", {"particles", "motion", "modes", "integrity"}},
      {"consider", {"particles", "motion", "kalman"}}}},
    {"vision", {{"", {}}, {"stereo", {""}}, {"tags", {""}}}}};

const Names kEigenOnly{"geometry",       "files",      "solvers",   "calibration", "correspondence",
                       "likelihood",     "hypotheses", "filter",    "evaluation",  "localizers",
                       "relocalization", "simulation", "importers", "report",      "frames"};

const Names kEstimators{"solvers",    "calibration", "correspondence", "likelihood",
                        "hypotheses", "filter",      "relocalization", "localizers"};

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

/// "mrpt_ext/<path>" of an include with its opening quote or bracket, empty for anything else.
std::string ourHeader(const std::string& include)
{
  return include.substr(1).starts_with("mrpt_ext/") ? include.substr(1) : "";
}

bool mayUseWithin(const std::string& room, const std::string& folder, const std::string& used)
{
  const auto rules = kAllowedWithin.find(room);
  if (rules == kAllowedWithin.end() || folder == used) return true;
  const auto rule = rules->second.find(folder);
  return rule != rules->second.end() && rule->second.contains(used);
}
}  // namespace

Violations checkIncludeDirections(const SourceTree& tree)
{
  Violations found;
  for (const auto& [path, text] : tree)
  {
    const std::string room = folderOf(path);
    if (!isCpp(path) || room == "tests" || isPython(path)) continue;
    for (const std::string& include : includesOf(text))
    {
      const std::string header = ourHeader(include), used = folderOf(header);
      if (header.empty() && include.starts_with('"'))
        found.push_back(path + ": includes " + include +
                        "\", our headers are included as \"mrpt_ext/<folder>/<file>.h\"");
      else if (!header.empty() && !mayUse(room, used))
        found.push_back(path + ": " + room + " must not include " + used);
      else if (used == "app" && room != "app" && room != "apps")
        found.push_back(path + ": only apps and tests include app");
      else if (used == room && !mayUseWithin(room, subfolderOf(path), subfolderOf(header)))
        found.push_back(path + ": must not include " + header);
    }
  }
  return found;
}

Violations checkIncludePaths(const SourceTree& tree)
{
  Violations found;
  for (const auto& [path, text] : tree)
  {
    if (!isCpp(path)) continue;
    for (const std::string& include : includesOf(text))
    {
      const std::string header = ourHeader(include);
      const auto is_at = [&](const std::string& root) { return tree.contains(root + "/" + header); };
      if (!header.empty() && !is_at("libmrpt-ext") && !is_at("observations") && !is_at("maps"))
        found.push_back(path + ": includes " + header + ", which is no file below an include root");
    }
  }
  return found;
}

Violations checkUnitCycles(const SourceTree& tree)
{
  const auto unit_of = [](const std::string& path) { return path.substr(0, path.rfind('.')); };
  std::map<std::string, Names> uses;
  for (const auto& [path, text] : tree)
  {
    if (!isCpp(path) || ourPath(path).empty()) continue;
    const std::string unit = unit_of(ourPath(path));
    for (const std::string& include : includesOf(text))
      if (const std::string header = ourHeader(include); !header.empty() && unit_of(header) != unit)
        uses[unit].insert(unit_of(header));
  }
  // Units that use nothing of what is left, taken away again and again: what remains lies on a cycle or above one.
  for (bool removed = true; removed;)
  {
    removed = std::erase_if(uses,
                            [&](const auto& unit)
                            {
                              return std::none_of(unit.second.begin(), unit.second.end(),
                                                  [&](const std::string& used) { return uses.contains(used); });
                            }) > 0;
  }
  Violations found;
  for (const auto& [unit, used] : uses)
    for (const std::string& other : used)
      if (const auto back = uses.find(other); back != uses.end() && unit < other && back->second.contains(unit))
        found.push_back(unit + " and " + other + " include each other");
  if (found.empty() && !uses.empty())
    found.push_back(uses.begin()->first + ": lies on a cycle of includes, or above one");
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
  }
  return found;
}
}  // namespace mrpt_ext::architecture
