#include "mrpt_ext/settings/name_suggestion.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace mrpt_ext
{
std::size_t editDistance(std::string_view a, std::string_view b)
{
  const auto same = [](char p, char q)
  { return std::tolower(static_cast<unsigned char>(p)) == std::tolower(static_cast<unsigned char>(q)); };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (same(a[i], b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

std::vector<std::string> similarNames(std::string_view wanted, const std::vector<std::string>& names)
{
  constexpr std::size_t kMost = 3, kShortestPart = 3;
  const std::size_t allowed = std::max<std::size_t>(1, wanted.size() / 3);
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const std::string& name : names)
  {
    const bool contains = wanted.size() >= kShortestPart && name.find(wanted) != std::string::npos;
    const std::size_t distance = editDistance(wanted, name);
    if (contains || distance <= allowed) found.emplace_back(distance, name);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> similar;
  for (const auto& [distance, name] : found)
    if (similar.size() < kMost) similar.push_back(name);
  return similar;
}

std::optional<std::string> closestName(std::string_view wanted, const std::vector<std::string>& names)
{
  const std::vector<std::string> similar = similarNames(wanted, names);
  return similar.empty() ? std::nullopt : std::optional(similar.front());
}
}  // namespace mrpt_ext
