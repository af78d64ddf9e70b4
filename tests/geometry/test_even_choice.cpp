#include "mrpt_ext/geometry/even_choice.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext::test_even_choice
{
namespace
{
std::vector<Detection> bearingsAt(const std::vector<double>& directions)
{
  std::vector<Detection> detections;
  for (const double direction : directions) detections.push_back({.bearing = direction, .std_bearing = 0.01});
  return detections;
}
}  // namespace

TEST(EvenChoice, EveryDirectionStaysRepresented)
{
  const std::vector<Detection> detections = bearingsAt({3, 0, 1, 2, 2.1, 0.1, 1.1, 3.1});
  const auto chosen = evenChoice(std::span<const Detection>(detections), 4);
  EXPECT_EQ(chosen, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(EvenChoice, FewStayAsTheyAre)
{
  const std::vector<Detection> detections = bearingsAt({2, 1, 0});
  EXPECT_EQ(evenChoice(std::span<const Detection>(detections), 3), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(evenChoice(std::span<const Detection>(), 3).empty());
}
}  // namespace mrpt_ext::test_even_choice
