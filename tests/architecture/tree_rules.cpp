#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "rules.h"

namespace mrpt_ext::architecture
{
namespace
{
constexpr std::size_t kMaxLines = 400, kMaxMainLines = 50, kMaxFolderLines = 5000;

const std::set<std::string> kTopLevel{"CMakeLists.txt",  "CMakePresets.json",
                                      "LICENSE",         "README.md",
                                      "CONTRIBUTING.md", "CHANGELOG.md",
                                      "SECURITY.md",     "apps",
                                      "datasets",        "ini",
                                      "libmrpt-ext",     "maps",
                                      "observations",    "tests"};

std::string parentOf(const std::string& path) { return path.substr(0, path.rfind('/')); }
std::string nameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

/// The nearest CMakeLists.txt at or above the folder of `path`; empty when there is none below the root.
std::string nearestCMakeLists(const SourceTree& tree, const std::string& path)
{
  for (std::string folder = parentOf(path);; folder = parentOf(folder))
  {
    if (tree.contains(folder + "/CMakeLists.txt")) return folder + "/CMakeLists.txt";
    if (folder.find('/') == std::string::npos) return "";
  }
}

bool namesWord(const std::string& text, const std::string& word)
{
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; };
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
  {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_part(text[at - 1])) && (end == text.size() || !is_part(text[end]))) return true;
  }
  return false;
}
}  // namespace

Violations checkTopLevel(const std::vector<std::string>& entries)
{
  Violations found;
  for (const std::string& entry : entries)
    if (!entry.starts_with('.') && !kTopLevel.contains(entry))
      found.push_back(entry + ": not a top-level entry of this project");
  return found;
}

Violations checkFileLengths(const SourceTree& tree)
{
  Violations found;
  for (const auto& [path, text] : tree)
  {
    if (!isCpp(path)) continue;
    const std::size_t limit = path.starts_with("apps/") && nameOf(path) == "main.cpp" ? kMaxMainLines : kMaxLines;
    if (const std::size_t lines = linesOf(text).size(); lines > limit)
      found.push_back(path + ": " + std::to_string(lines) + " lines, at most " + std::to_string(limit));
  }
  return found;
}

Violations checkFolderSizes(const SourceTree& tree)
{
  std::map<std::string, std::size_t> lines;
  for (const auto& [path, text] : tree)
    if (isCpp(path) && !ourPath(path).empty()) lines[parentOf(path)] += linesOf(text).size();
  Violations found;
  for (const auto& [folder, count] : lines)
    if (count > kMaxFolderLines)
      found.push_back(folder + ": " + std::to_string(count) + " lines, at most " + std::to_string(kMaxFolderLines));
  return found;
}

Violations checkTypeNames(const SourceTree& tree)
{
  // What stands in the first column stands at namespace scope; a line that ends in a semicolon only declares.
  static const std::regex kType(
      R"(^(?:struct|class|enum class|enum) (?:alignas\([^)]*\) )?(\w+)(?! *;)|^using (\w+) =)");
  std::map<std::string, std::string> header_of;
  Violations found;
  for (const auto& [path, text] : tree)
  {
    if (!isHeader(path) || ourPath(path).empty()) continue;
    for (const std::string& line : linesOf(codeOnly(text)))
    {
      std::smatch match;
      if (!std::regex_search(line, match, kType) ||
          (line.find('{') == std::string::npos && line.ends_with(';') && !match[2].matched))
        continue;
      const auto [first, is_new] = header_of.emplace(match[1].matched ? match[1] : match[2], path);
      if (!is_new && first->second != path)
        found.push_back(path + ": type " + first->first + " stands in " + first->second + " too");
    }
  }
  return found;
}

Violations checkSourceLists(const SourceTree& tree)
{
  Violations found;
  for (const auto& [path, text] : tree)
  {
    if (path.ends_with("CMakeLists.txt") && text.find("GLOB") != std::string::npos)
      found.push_back(path + ": globbing, sources are listed by name");
    if (!path.ends_with(".cpp")) continue;
    const std::string list = nearestCMakeLists(tree, path);
    if (list.empty() || !namesWord(tree.at(list), nameOf(path)))
      found.push_back(path + ": in no CMakeLists.txt, so it is never built");
  }
  return found;
}

Violations checkPackageConfig(const SourceTree& tree)
{
  static const std::regex kFindPackage(R"(find_package\s*\(\s*([\w-]+))");
  const auto config = tree.find("libmrpt-ext/mrpt_ext-config.cmake.in");
  if (config == tree.end()) return {"libmrpt-ext/mrpt_ext-config.cmake.in: missing"};
  Violations found;
  for (const auto& [path, text] : tree)
  {
    if (!path.ends_with("CMakeLists.txt") || path.starts_with("tests/") || path.starts_with("apps/") || isPython(path))
      continue;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), kFindPackage); it != std::sregex_iterator(); ++it)
      if (const std::string package = (*it)[1]; package != "mrpt_ext" && !namesWord(config->second, package))
        found.push_back(path + ": " + package + " is not looked up in " + config->first);
  }
  return found;
}

Violations checkConfigurationsAreTested(const SourceTree& tree)
{
  Violations found;
  for (const auto& [path, text] : tree)
  {
    if (!path.starts_with("ini/") || !path.ends_with(".ini")) continue;
    const std::string app = nameOf(parentOf(path)), name = nameOf(path).substr(0, nameOf(path).size() - 4);
    const bool tested = std::any_of(
        tree.begin(), tree.end(),
        [&](const auto& file)
        { return file.first.starts_with("tests/") && namesWord(file.second, app) && namesWord(file.second, name); });
    if (!tested) found.push_back(path + ": named by no test");
  }
  return found;
}

Violations checkKeyDefaults(const SourceTree& tree)
{
  static const std::regex kLiteral(
      R"rx(\.(?:(?:number|degrees|integer)\(\s*"(\w+)",\s*"[^"]*",\s*[-+.\d]|flag\(\s*"(\w+)",\s*(?:true|false)))rx");
  Violations found;
  for (const auto& [path, text] : tree)
  {
    if (folderOf(path) != "configuration" || !path.ends_with("_keys.cpp")) continue;
    for (std::sregex_iterator match(text.begin(), text.end(), kLiteral), end; match != end; ++match)
      found.push_back(path + ": the default of " + (*match)[1].str() + (*match)[2].str() +
                      " is written down, read it from the struct that holds it");
  }
  return found;
}

Violations checkDocumentsNameFiles(const SourceTree& tree)
{
  // Configurations without a folder are placeholders or outputs.
  static const std::regex kFile(R"([\w./-]*[\w-]\.(h|cpp)\b|[\w.-]+/[\w./-]*[\w-]\.(sh|ini)\b)");
  Violations found;
  for (const std::string document : {"README.md", "CONTRIBUTING.md"})
  {
    const auto entry = tree.find(document);
    if (entry == tree.end()) continue;
    const std::string& text = entry->second;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), kFile); it != std::sregex_iterator(); ++it)
    {
      const std::string file = it->str();
      const bool exists =
          std::any_of(tree.begin(), tree.end(),
                      [&](const auto& known) { return known.first == file || known.first.ends_with("/" + file); });
      if (!exists) found.push_back(document + ": names " + file + ", which does not exist");
    }
  }
  return found;
}

Violations checkText(const SourceTree& tree)
{
  static const std::regex kUnfinished(R"(\b(TO()DO|FIX()ME)\b)");
  static const std::regex kMachinePath(R"((^|[^\w.}/])/(home|root|work|tmp|Users)/)");
  Violations found;
  for (const auto& [path, text] : tree)
  {
    std::size_t number = 0;
    for (const std::string& line : linesOf(text))
    {
      const std::string place = path + ":" + std::to_string(++number);
      if (std::regex_search(line, kUnfinished)) found.push_back(place + ": unfinished work");
      if (std::regex_search(line, kMachinePath)) found.push_back(place + ": path of one machine");
    }
  }
  return found;
}
}  // namespace mrpt_ext::architecture
