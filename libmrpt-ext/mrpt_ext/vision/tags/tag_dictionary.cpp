#include "mrpt_ext/vision/tags/tag_dictionary.h"

#include <array>

namespace mrpt_ext
{
TagDictionary arucoOriginal()
{
  constexpr std::array<std::uint64_t, 4> kWords{0b10000, 0b10111, 0b01001, 0b01110};
  constexpr std::uint64_t kMarkers = 1024;
  constexpr int kCells = 5;
  TagDictionary dictionary{kCells, {}};
  for (std::uint64_t id = 0; id < kMarkers; ++id)
  {
    std::uint64_t code = 0;
    for (int row = 0; row < kCells; ++row) code = code << kCells | kWords[id >> 2 * (kCells - 1 - row) & 3];
    dictionary.codes.push_back(code);
  }
  return dictionary;
}
}  // namespace mrpt_ext
