#include "mrpt_ext/diagnosis/choice_part.h"

#include <algorithm>

namespace mrpt_ext
{
std::vector<std::size_t> estimatedBeside(const std::vector<std::size_t>& chosen,
                                         const std::vector<CalibrationUnknown>& unknowns)
{
  const auto has = [&](std::size_t sensor, const auto& is_it)
  {
    return std::any_of(chosen.begin(), chosen.end(),
                       [&](std::size_t k) { return unknowns[k].sensor == sensor && is_it(unknowns[k]); });
  };
  std::vector<std::size_t> beside;
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    for (const auto& is_it : {isLandmarkOffset, isMapError, isPlaceError})
      if (const std::size_t sensor = unknowns[k].sensor;
          is_it(unknowns[k]) && has(sensor, isRangeError) && !has(sensor, is_it))
        beside.push_back(k);
  return beside;
}
}  // namespace mrpt_ext
