#pragma once

#include "mrpt_ext/settings/key_choice.h"
#include "mrpt_ext/simulation/scenario.h"

namespace mrpt_ext
{
// The choices of landmark-simulator's keys, for the table of keys and for the reader.

/// Where a map comes from: a MapLayout, or a file.
enum class MapSource
{
  written,
  file,
  random,
  grid
};

[[nodiscard]] NamedValues<MapSource> mapSources();
[[nodiscard]] NamedValues<PathKind> pathKinds();
[[nodiscard]] NamedValues<SensorKind> sensorKinds();
}  // namespace mrpt_ext
