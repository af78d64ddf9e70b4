#include "mrpt_ext/files/text_table.h"

#include <gtest/gtest.h>

#include "error_message.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_text_table
{
using testing::messageOf;
using testing::ScratchFolder;

TEST(TextTable, ReadsCommaTableWithHeaderCommentsAndEmptyFields)
{
  const ScratchFolder folder;
  const TextTable table(folder.write("t.csv", "\xEF\xBB\xBF# note\r\n a , b,c\r\n\r\n1,,x y\r\n 2 ,3.5,\r\n"), {});
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table.columns(), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(table.integer(1, table.column("a")), 2);
  EXPECT_FALSE(table.optionalNumber(0, 1));
  EXPECT_EQ(table.optionalNumber(1, 1), 3.5);
  EXPECT_EQ(table.text(0, 2), "x y");
  EXPECT_EQ(table.text(1, 2), "");
}

TEST(TextTable, ReadsWhiteSpaceTableWithoutHeader)
{
  const ScratchFolder folder;
  const TextTable table(folder.write("t.dat", "# f\n10 \t  0.5\t-1 \n11 0.25 2"),
                        {Delimiter::white_space, "#", {"t", "v", "w"}});
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table.number(0, 2), -1);
  EXPECT_EQ(table.number(1, 1), 0.25);
}

TEST(TextTable, ErrorsNameFileLineAndColumn)
{
  const ScratchFolder folder;
  const TextTable table(folder.write("t.csv", "a,b\n# note\n1,abc\n1.5,nan\n"), {});
  const std::string path = (folder.path() / "t.csv").string();
  EXPECT_EQ(messageOf<InputError>([&] { (void)table.number(0, 1); }), path + ":3: 'abc' is not a number, expected b");
  EXPECT_EQ(messageOf<InputError>([&] { (void)table.number(1, 1); }), path + ":4: 'nan' is not a number, expected b");
  EXPECT_EQ(messageOf<InputError>([&] { (void)table.integer(1, 0); }),
            path + ":4: '1.5' is not an integer, expected a");
  EXPECT_EQ(messageOf<InputError>([&] { (void)table.column("c"); }),
            path + ":1: no column 'c', the header line has a,b");
  EXPECT_EQ(messageOf<InputError>([&] { table.expectOnlyColumns({"a"}); }),
            path + ":1: unknown column 'b', expected only a");
}

TEST(TextTable, ReadsRowsOfOneTypeAndSkipsKnownOnes)
{
  const ScratchFolder folder;
  const auto path = folder.write("t.txt", "r 1 2\nw 3\nr 4 5\n");
  const TextTable ranges(path, {Delimiter::white_space, "#", {"type", "a", "b"}, {"r", {"w"}}});
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_EQ(ranges.number(1, 2), 5);
  const auto only = [&] { TextTable(path, {Delimiter::white_space, "#", {"type", "a"}, {"w", {}}}); };
  EXPECT_NE(messageOf<InputError>(only).find("t.txt:1: unknown type of row 'r', expected w"), std::string::npos);
}

TEST(TextTable, RowOfAnotherLengthIsAnError)
{
  const ScratchFolder folder;
  const auto read = [&](const std::string& content)
  { return messageOf<InputError>([&] { TextTable(folder.write("t.csv", content), {}); }); };
  EXPECT_NE(read("a,b\n1,2\n3\n").find("t.csv:3: 1 fields, expected 2 (a,b)"), std::string::npos);
  EXPECT_NE(read("a,b\n1,2,3\n").find("t.csv:2: 3 fields"), std::string::npos);
  EXPECT_NE(read("a,a\n").find("t.csv:1: column 'a' occurs twice"), std::string::npos);
  EXPECT_NE(read("# only a comment\n").find("the file is empty"), std::string::npos);
}

TEST(TextTable, RowsCanBeReadOneByOne)
{
  const ScratchFolder folder;
  const auto path = folder.write("t.csv", "a,b\n1,2\n# note\n3,x\n5,6");
  std::vector<std::string> seen;
  const auto take = [&](const TextTable& row)
  {
    EXPECT_EQ(row.size(), 1u);
    seen.push_back(row.text(0, 1));
    if (seen.back() == "x") throw row.errorAt(0, "no x");
  };
  EXPECT_EQ(messageOf<InputError>([&] { forEachRow(path, {}, take); }), path.string() + ":4: no x");
  EXPECT_EQ(seen, (std::vector<std::string>{"2", "x"}));
  seen.clear();
  forEachRow(folder.write("u.csv", "a,b\n1,2\n3,4"), {}, take);
  EXPECT_EQ(seen, (std::vector<std::string>{"2", "4"}));
}
}  // namespace mrpt_ext::test_text_table
