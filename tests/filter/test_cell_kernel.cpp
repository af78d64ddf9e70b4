#include "mrpt_ext/filter/modes/cell_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_cell_kernel
{
namespace
{
constexpr float kSize = 0.25F;

TEST(CellKernel, ValuesLieInTheirCellsAtTheirOffsets)
{
  RandomStream random(1);
  std::vector<float> values;
  for (std::size_t i = 0; i < 500; ++i) values.push_back(static_cast<float>(random.uniform(-20, 20)));
  CellAxis axis;
  divideIntoCells(values.data(), values.size(), 0.3F, kSize, axis);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const float middle = (static_cast<float>(axis.cell[i]) + 0.5F - 0.3F) * kSize;
    EXPECT_LE(std::abs(axis.offset[i]), kSize / 2 + 1e-5F);
    EXPECT_NEAR(middle + axis.offset[i], values[i], 1e-5F);
  }
}

TEST(CellKernel, AllValuesBeyondTheGridShareOneCell)
{
  const float values[] = {1e30F, 2e30F, -1e30F, -2e30F};
  CellAxis axis;
  divideIntoCells(values, 4, 0, kSize, axis);
  EXPECT_EQ(axis.cell[0], axis.cell[1]);
  EXPECT_EQ(axis.cell[2], axis.cell[3]);
}

TEST(CellKernel, SumsHoldAllMomentsOfEachCell)
{
  constexpr std::size_t kCells = 3, kCount = kCellChunk - 5;
  RandomStream random(2);
  CellChunk chunk;
  CellSums expected[kCells];
  for (std::size_t i = 0; i < kCount; ++i)
  {
    for (CellAxis* axis : {&chunk.x, &chunk.y, &chunk.phi}) axis->offset[i] = static_cast<float>(random.uniform(-1, 1));
    chunk.weight[i] = static_cast<float>(random.uniform());
    chunk.number[i] = static_cast<std::uint32_t>(i % 7 % kCells);
    const double d[] = {1, chunk.x.offset[i], chunk.y.offset[i], chunk.phi.offset[i]}, w = chunk.weight[i];
    CellSums& cell = expected[chunk.number[i]];
    for (std::size_t k = 0; k < 4; ++k)
    {
      cell.first[k] += w * d[k];
      cell.squares[k] += w * d[k] * d[k];
      cell.products[k] += k == 0 ? w : w * d[k] * d[1 + k % 3];
    }
  }
  CellSums sums[kCells * kCellTurns];
  addToCells(chunk, kCount, sums);
  for (std::size_t cell = 0; cell < kCells; ++cell)
  {
    CellSums total;
    for (std::size_t turn = 0; turn < kCellTurns; ++turn) total += sums[cell * kCellTurns + turn];
    for (std::size_t k = 0; k < 4; ++k)
    {
      EXPECT_NEAR(total.first[k], expected[cell].first[k], 1e-9);
      EXPECT_NEAR(total.squares[k], expected[cell].squares[k], 1e-9);
      EXPECT_NEAR(total.products[k], expected[cell].products[k], 1e-9);
    }
  }
}
}  // namespace
}  // namespace mrpt_ext::test_cell_kernel
