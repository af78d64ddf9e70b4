#include "mrpt_ext/app/shell_quote.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace mrpt_ext::test_shell_quote
{
namespace
{
/// The words that a shell makes of the line, each in angle brackets.
std::string splitByAShell(const std::string& line)
{
  std::FILE* const shell = popen(("printf '<%s>' " + line).c_str(), "r");
  std::string words;
  for (int c = 0; (c = std::fgetc(shell)) != EOF;) words += static_cast<char>(c);
  pclose(shell);
  return words;
}
}  // namespace

TEST(ShellLine, PlainWordsStayAsTheyAre)
{
  EXPECT_EQ(shellLine({"room.ini", "--set", "PF_options.BETA=0.3", "-o", "out/room"}),
            "room.ini --set PF_options.BETA=0.3 -o out/room");
}

TEST(ShellLine, AShellSplitsItIntoTheSameWords)
{
  EXPECT_EQ(splitByAShell(shellLine({"a b", "it's", "", "$(reboot)", "`x`", "*", "a\nb", "\"", "\\", "~", ";", "!"})),
            "<a b><it's><><$(reboot)><`x`><*><a\nb><\"><\\><~><;><!>");
}
}  // namespace mrpt_ext::test_shell_quote
