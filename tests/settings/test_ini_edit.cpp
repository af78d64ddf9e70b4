#include "mrpt_ext/settings/ini_edit.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_ini_edit
{
TEST(ConfigurationLines, ReplaceAValueAndKeepItsComment)
{
  EXPECT_EQ(withValues("; a = b\n[S]\na   = 1   ; why\nb = 2\n", {{"S", "a", "3"}}),
            "; a = b\n[S]\na   = 3 ; why\nb = 2\n");
}

TEST(ConfigurationLines, AreAddedWhereTheyBelong)
{
  const std::string ini = "[S]\na = 1\n\n; about T\n[T]\na = 2\n";
  EXPECT_EQ(withValues(ini, {{"S", "b", "7"}}), "[S]\na = 1\nb = 7\n\n; about T\n[T]\na = 2\n");
  EXPECT_EQ(withValues(ini, {{"T", "a", "7"}}), "[S]\na = 1\n\n; about T\n[T]\na = 7\n");
  EXPECT_EQ(withValues("[S]\na = 1\n", {{"U", "c", "1:2 3:4"}, {"U", "d", "5"}}),
            "[S]\na = 1\n\n[U]\nc = 1:2 3:4\nd = 5\n");
}

TEST(ConfigurationLines, TwiceIsOnce)
{
  const std::vector<IniAssignment> lines{{"S", "a", "1"}, {"T", "b", "2"}};
  const std::string once = withValues("[S]\n", lines);
  EXPECT_EQ(withValues(once, lines), once);
}
}  // namespace mrpt_ext::test_ini_edit
