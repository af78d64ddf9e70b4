#include "mrpt_ext/files/number_format.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>

namespace mrpt_ext::test_number_format
{
TEST(FixedText, RoundsToDecimalsAndKeepsTrailingZeros)
{
  EXPECT_EQ(fixedText(1.5, 3), "1.500");
  EXPECT_EQ(fixedText(-2.0004, 3), "-2.000");
  EXPECT_EQ(fixedText(1248444187.886, 6), "1248444187.886000");
  EXPECT_EQ(fixedText(12.6, 0), "13");
}

TEST(FixedText, HasNoMinusZero)
{
  EXPECT_EQ(fixedText(-0.0, 2), "0.00");
  EXPECT_EQ(fixedText(-1e-9, 6), "0.000000");
  EXPECT_EQ(fixedText(-0.01, 2), "-0.01");
}

TEST(FixedText, NonFiniteNumbersHaveNames)
{
  EXPECT_EQ(fixedText(std::nan(""), 2), "nan");
  EXPECT_EQ(fixedText(-std::numeric_limits<double>::infinity(), 2), "-inf");
  EXPECT_EQ(fixedText(std::numeric_limits<double>::max(), 6).size(), 309u + 7u);
}

TEST(ParseNumber, TakesOnlyWholeFiniteNumbers)
{
  EXPECT_EQ(parseNumber("+1.25e2"), 125.0);
  EXPECT_EQ(parseNumber("-.5"), -0.5);
  for (const char* wrong : {"", "abc", "1.5x", "1,5", "nan", "inf", "1e999", "+-1", "++1", "0x10", " 1"})
    EXPECT_FALSE(parseNumber(wrong)) << wrong;
}

TEST(ParseInteger, RejectsFractionsAndOverflow)
{
  EXPECT_EQ(parseInteger("+7"), 7);
  EXPECT_EQ(parseInteger("-3"), -3);
  for (const char* wrong : {"", "1.0", "7a", "99999999999"}) EXPECT_FALSE(parseInteger(wrong)) << wrong;
}

TEST(NumberText, DoesNotDependOnTheLocale)
{
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "the locale de_DE.UTF-8 is not installed";
  EXPECT_EQ(fixedText(1.5, 2), "1.50");
  EXPECT_EQ(parseNumber("1.5"), 1.5);
  std::setlocale(LC_ALL, before.c_str());
}

RC_GTEST_PROP(NumberText, ShortestTextReadsBackExactly, (double value))
{
  RC_PRE(std::isfinite(value));
  RC_ASSERT(parseNumber(shortestText(value)) == value);
}
}  // namespace mrpt_ext::test_number_format
