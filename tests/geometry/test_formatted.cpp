#include "mrpt_ext/geometry/formatted.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_formatted
{
TEST(Formatted, WritesNumbersAsPrintfDoes)
{
  EXPECT_EQ(formatted("%.2f m, %d of %zu", 1.005, 3, std::size_t{7}), "1.00 m, 3 of 7");
}

TEST(Formatted, CutsNothingHoweverLong)
{
  const std::string name(5000, 'x');
  EXPECT_EQ(formatted("<%s>", name.c_str()), "<" + name + ">");
}
}  // namespace mrpt_ext::test_formatted
