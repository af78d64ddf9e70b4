#include "mrpt_ext/app/printable_stream.h"

#include <gtest/gtest.h>

#include <sstream>

namespace mrpt_ext::test_printable_stream
{
TEST(Printable, KeepsTextInAnyLanguage)
{
  EXPECT_EQ(printable("a\tb\nMünchen 日本 🤖"), "a\tb\nMünchen 日本 🤖");
}

TEST(Printable, ControlCharactersAreWrittenOut)
{
  EXPECT_EQ(printable("\x1b[2J\x07\r\x7f"), "\\x1b[2J\\x07\\x0d\\x7f");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b") << "the control sequence introducer as one character";
}

TEST(Printable, BytesThatAreNoTextAreWrittenOut)
{
  EXPECT_EQ(printable("\x9b"), "\\x9b");
  EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82") << "cut off";
}

TEST(PrintableStream, PassesLinesOn)
{
  std::ostringstream target;
  PrintableStream stream(target);
  stream << "label \x1b[31m" << 7 << '\n' << "begun";
  EXPECT_EQ(target.str(), "label \\x1b[31m7\n");
  stream << std::flush;
  EXPECT_EQ(target.str(), "label \\x1b[31m7\nbegun");
  EXPECT_TRUE(stream.good());
}

TEST(PrintableStream, FailsWhereItsTargetFails)
{
  std::ostringstream target;
  target.setstate(std::ios::badbit);
  PrintableStream stream(target);
  stream << "text" << std::flush;
  EXPECT_FALSE(stream.good());
}
}  // namespace mrpt_ext::test_printable_stream
