#include "mrpt_ext/app/rawlog_output.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_rawlog_output
{
TEST(RawlogOutput, NamesMapAndTruthAfterTheRawlog)
{
  const RawlogOutput files = rawlogOutput("my-app", "out/a.b.rawlog");
  EXPECT_EQ(files.rawlog, "out/a.b.rawlog");
  EXPECT_EQ(files.map, "out/a.b_map.csv");
  EXPECT_EQ(files.truth, "out/a.b_ground_truth.tum");
}

TEST(RawlogOutput, IsStemRawlog)
{
  for (const char* output : {"", "a.txt", "a", ".rawlog", "out/"})
    EXPECT_THROW((void)rawlogOutput("my-app", output), InputError) << output;
}

TEST(RawlogOutput, IsNoInput)
{
  const testing::ScratchFolder folder;
  const std::filesystem::path input = folder.write("a.rawlog", "a recording"), link = folder.path() / "b.rawlog";
  std::filesystem::create_symlink(input, link);
  EXPECT_THROW((void)rawlogOutput("my-app", input, {input}), InputError);
  EXPECT_THROW((void)rawlogOutput("my-app", link, {"elsewhere", input}), InputError);
  EXPECT_EQ(rawlogOutput("my-app", folder.path() / "c.rawlog", {input}).map, folder.path() / "c_map.csv");
}
}  // namespace mrpt_ext::test_rawlog_output
