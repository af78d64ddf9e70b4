#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext::papers
{
/// The keys of the scenarios in tests/papers.
[[nodiscard]] KeyTable paperKeys();

/// tests/papers/<name>.ini; `changes`: "Section.key=value" each, as for --set.
[[nodiscard]] Settings paperSettings(const std::string& name, const std::vector<std::string>& changes = {});

[[nodiscard]] inline std::uint64_t seedOf(const Settings& settings)
{
  return static_cast<std::uint64_t>(settings.integer("Experiment", "random_seed"));
}
[[nodiscard]] inline int trialsOf(const Settings& settings)
{
  return static_cast<int>(settings.integer("Experiment", "trials"));
}
}  // namespace mrpt_ext::papers
