#pragma once

#include <cstdint>
#include <vector>

namespace mrpt_ext
{
/// Square tags of n x n cells within a black border of one cell.
struct TagDictionary
{
  int cells = 0;  ///< n along an edge, 3 to 8
  std::vector<std::uint64_t>
      codes;  ///< by the tag's number: cells row by row, the first is the highest bit, 1 is white
};

/// The 1024 markers of the original ArUco: five rows of five cells, each of which is one of four words (Garrido-Jurado
/// et al., "Automatic generation and detection of highly reliable fiducial markers under occlusion", 2014, section 2).
[[nodiscard]] TagDictionary arucoOriginal();
}  // namespace mrpt_ext
