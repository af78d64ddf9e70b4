#include "mrpt_ext/importers/date_time.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_date_time
{
TEST(DateTime, CountsSecondsSince1970)
{
  EXPECT_EQ(parseDateTime("1970-01-01 00:00:00"), 0.0);
  EXPECT_EQ(parseDateTime("2000-02-29 12:30:01.5"), 951827401.5);
  EXPECT_EQ(parseDateTime("2022-08-15 9:42:24.25"), 1660556544.25);
}

TEST(DateTime, RejectsOtherText)
{
  for (const char* text :
       {"", "2022-08-15", "2022-08-15 9:42", "2022-02-30 9:42:24", "2022-08-15 25:42:24", "2022-08-15 9:61:24",
        "2022-08-15 9:42:75", "2022-08-15T9:42:24", "15.8.2022 9:42:24", "2022-08-15 9:42:24 Z"})
    EXPECT_FALSE(parseDateTime(text)) << text;
}
}  // namespace mrpt_ext::test_date_time
