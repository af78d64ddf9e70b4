#include "source_tree.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace mrpt_ext::architecture
{
namespace
{
namespace fs = std::filesystem;

bool isIgnoredAtTop(const std::string& name) { return name.starts_with("build") || name == "out"; }

bool isText(const fs::path& path)
{
  static const std::vector<std::string> kTextEndings{".cpp", ".h",   ".in",   ".txt", ".md",   ".sh",
                                                     ".ini", ".csv", ".json", ".tum", ".cmake"};
  const std::string ending = path.extension().string();
  return std::find(kTextEndings.begin(), kTextEndings.end(), ending) != kTextEndings.end();
}

std::string readFile(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
}  // namespace

SourceTree readTree(const fs::path& root)
{
  SourceTree tree;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry)
  {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory() && (name.starts_with('.') || (entry.depth() == 0 && isIgnoredAtTop(name))))
      entry.disable_recursion_pending();
    else if (entry->is_regular_file() && isText(entry->path()))
      tree[entry->path().lexically_relative(root).generic_string()] = readFile(entry->path());
  }
  return tree;
}

std::vector<std::string> topLevelEntries(const fs::path& root)
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(root))
    if (const std::string name = entry.path().filename().string(); !isIgnoredAtTop(name)) names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

std::string ourPath(const std::string& path)
{
  for (const std::string root : {"", "libmrpt-ext/", "observations/", "maps/"})
    if (path.starts_with(root + "mrpt_ext/")) return path.substr(root.size());
  return "";
}

std::string folderOf(const std::string& path)
{
  const std::string ours = ourPath(path), inner = ours.empty() ? path : ours.substr(std::string("mrpt_ext/").size());
  const auto slash = inner.find('/');
  return slash == std::string::npos ? "" : inner.substr(0, slash);
}

std::string subfolderOf(const std::string& path)
{
  const std::string ours = ourPath(path);
  const auto room = ours.find('/', std::string("mrpt_ext/").size()), last = ours.rfind('/');
  return ours.empty() || room == last ? "" : ours.substr(room + 1, last - room - 1);
}

bool isPython(const std::string& path) { return path.starts_with("libmrpt-ext/python/"); }
bool isHeader(const std::string& path) { return path.ends_with(".h"); }
bool isCpp(const std::string& path) { return path.ends_with(".cpp") || isHeader(path); }

std::vector<std::string> linesOf(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string codeOnly(const std::string& text)
{
  static const std::regex kNotCode(R"(//[^\n]*|/\*[^*]*\*+([^/*][^*]*\*+)*/|"(\\.|[^"\\\n])*")");
  return std::regex_replace(text, kNotCode, " ");
}
}  // namespace mrpt_ext::architecture
