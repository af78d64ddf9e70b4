#include "mrpt_ext/settings/ini_file.h"

#include <gtest/gtest.h>

#include "error_message.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::test_ini_file
{
namespace
{
std::string errorOf(const std::string& text)
{
  return testing::configurationErrorOf([&] { (void)IniFile::parse(text, "my.ini"); });
}
}  // namespace

TEST(IniFile, KeepsValuesVerbatimWithTheirLines)
{
  const IniFile ini = IniFile::parse("; head\n\n[A]\nx = 1\nname = two  words\n[B]\nx=\n", "my.ini");
  ASSERT_EQ(ini.sections().size(), 2U);
  EXPECT_EQ(ini.find("A")->line, 3);
  EXPECT_EQ(ini.find("A", "x")->value, "1");
  EXPECT_EQ(ini.find("A", "name")->value, "two  words");
  EXPECT_EQ(ini.find("A", "name")->line, 5);
  EXPECT_EQ(ini.find("B", "x")->value, "");
  EXPECT_EQ(ini.find("B", "name"), nullptr);
  EXPECT_EQ(ini.find("C"), nullptr);
}

TEST(IniFile, CommentsNeedABlankBeforeThem)
{
  const IniFile ini = IniFile::parse("[A]\na = 1 // m\nb = 2\t# m\nc = 3 ; m\nd = a#b;c//d\n//e = 1\n#f\n", "my.ini");
  EXPECT_EQ(ini.find("A", "a")->value, "1");
  EXPECT_EQ(ini.find("A", "b")->value, "2");
  EXPECT_EQ(ini.find("A", "c")->value, "3");
  EXPECT_EQ(ini.find("A", "d")->value, "a#b;c//d");
  EXPECT_EQ(ini.find("A")->entries.size(), 4U);
}

TEST(IniFile, BackslashContinuesAValue)
{
  const IniFile ini = IniFile::parse("[A]\nlist = 1 2 \\  ; first row\n  3 4\nnext = 5\n", "my.ini");
  EXPECT_EQ(ini.find("A", "list")->value, "1 2 3 4");
  EXPECT_EQ(ini.find("A", "next")->line, 4);
}

TEST(IniFile, ReadsWindowsLineEndsAndByteOrderMark)
{
  const IniFile ini = IniFile::parse("\xEF\xBB\xBF[A]\r\nx = 1\r\n", "my.ini");
  EXPECT_EQ(ini.find("A", "x")->value, "1");
}

TEST(IniFile, NamesTheLineOfEveryMistake)
{
  EXPECT_EQ(errorOf("[A]\nx = 1\nx = 2\n"), "my.ini:3: 'x' in [A] is already in line 2");
  EXPECT_EQ(errorOf("[A]\n[A]\n"), "my.ini:2: section [A] is already in line 1");
  EXPECT_EQ(errorOf("x = 1\n"), "my.ini:1: 'x' comes before the first [Section]");
  EXPECT_EQ(errorOf("[A]\nhello\n"), "my.ini:2: 'hello': expected key = value");
  EXPECT_EQ(errorOf("[A\n"), "my.ini:1: '[A': expected [Section]");
}

TEST(IniFile, RefusesMoreThanAnybodyWrites)
{
  std::string sections;
  for (std::size_t i = 0; i <= IniFile::kMostSections; ++i) sections += "[S" + std::to_string(i) + "]\n";
  EXPECT_EQ(errorOf(sections), "my.ini:1001: [S1000] is one section too many, expected at most 1000");
  EXPECT_EQ(errorOf("[A]\n" + std::string(IniFile::kMostLines, '\n')),
            "my.ini:20001: an .ini file of more than 20000 lines, expected a configuration");
  EXPECT_EQ(errorOf(std::string("[A]\0", 4)), "my.ini: holds bytes that are no text, expected an .ini file");
  EXPECT_EQ(errorOf(std::string(1000, 'x')), "my.ini:1: '" + std::string(100, 'x') + "...': expected key = value");
}

TEST(IniFile, MissingFileAndFolderAreErrors)
{
  EXPECT_THROW((void)IniFile::read("no/such/file.ini"), InputError);
  EXPECT_THROW((void)IniFile::read(MRPT_EXT_SOURCE_DIR), InputError);
}

TEST(IniFile, SetReplacesOrAdds)
{
  IniFile ini = IniFile::parse("[A]\nx = 1\n", "my.ini");
  ini.set("A", "x", "2", "--x 2");
  ini.set("B", "y", "3", "--y 3");
  EXPECT_EQ(ini.find("A", "x")->value, "2");
  EXPECT_EQ(ini.find("A")->entries.size(), 1U);
  EXPECT_EQ(ini.find("A", "x")->line, 0);
  EXPECT_EQ(ini.find("A", "x")->origin, "--x 2");
  EXPECT_EQ(ini.find("B", "y")->value, "3");
}
}  // namespace mrpt_ext::test_ini_file
