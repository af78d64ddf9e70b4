#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
enum class MapLayout
{
  given,   ///< MapPlan::landmarks as they are
  random,  ///< uniform in the box, no two nearer than min_distance
  grid     ///< rows and columns over the box, its corners included
};

/// How to generate the map of a scenario.
struct MapPlan
{
  MapLayout layout = MapLayout::given;
  std::vector<Landmark> landmarks;      ///< given
  int count = 10;                       ///< random
  int columns = 4, rows = 3;            ///< grid
  Vector3d low{0, 0, 0};                ///< [m] box of random and grid
  Vector3d high{10, 10, 0};             ///< [m]
  double min_distance = 0;              ///< [m] random
  bool with_ids = true;                 ///< 1, 2, 3, ...; otherwise all are anonymous
  std::vector<std::string> categories;  ///< assigned in turn; empty: none
};

/// Positions rounded to 1e-6 m. Throws InputError (configuration) when min_distance leaves no room for `count`.
[[nodiscard]] LandmarkTable generateMap(const MapPlan& plan, RandomStream& random);
}  // namespace mrpt_ext
