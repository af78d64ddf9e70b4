#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrpt_ext
{
/// Three bearings in the form of the inner loop. Landmark i matches the middle one, j the first, k the second.
struct TripleShape
{
  float cot_first = 0;    ///< cot(first - middle)
  float cot_second = 0;   ///< cot(second - middle)
  float sign_first = 1;   ///< of sin(first - middle)
  float sign_second = 1;  ///< of sin(second - middle)
  float range2 = 0;       ///< square of how far the landmarks can be [m^2]; infinity: no limit
};

/// Landmarks around landmark i, relative to it [m]; padded with zeros to a multiple of 16. The arrays may be longer.
struct Neighbours
{
  std::vector<float> x, y;
  std::size_t count = 0;   ///< without padding
  std::size_t padded = 0;  ///< with

  void reserve(std::size_t capacity);
  void pad();
};

/// Sensor positions from which landmarks i, j and k have the bearings of a triple; all relative to landmark i [m].
struct TripleHits
{
  std::vector<float> x, y;          ///< sensor
  std::vector<std::uint32_t> j, k;  ///< indices of the landmarks among the neighbours
  std::size_t count = 0;

  void reserve(std::size_t capacity);
};

/// Appends a hit for every j in `first` [j_begin, j_end) and k in `second` for which a position exists that sees i,
/// j and k under the three bearings, in the right directions, within the range. `hits` must have room for (j_end -
/// j_begin) * second.padded.
///
/// The positions that see i and j under a given angle form a circle through both, with centre u = (j + cot *
/// perp(j)) / 2 in coordinates relative to i; i and k give another with centre v. Both pass through i, so the
/// position is the mirror image of i in the line u v: a dozen operations per (j, k), no trigonometry.
void scanTriples(const TripleShape& shape, const Neighbours& first, std::size_t j_begin, std::size_t j_end,
                 const Neighbours& second, TripleHits& hits);
}  // namespace mrpt_ext
