#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mrpt_ext
{
/// Number of single-letter changes (insert, delete, replace) between two words; upper and lower case are the same.
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b);

/// The names near enough to `wanted` to be what a user meant (a third of its letters wrong at most, or `wanted` is a
/// part of them), nearest first, three at most.
[[nodiscard]] std::vector<std::string> similarNames(std::string_view wanted, const std::vector<std::string>& names);

/// The first of them.
[[nodiscard]] std::optional<std::string> closestName(std::string_view wanted, const std::vector<std::string>& names);
}  // namespace mrpt_ext
