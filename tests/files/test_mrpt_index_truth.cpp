#include "mrpt_ext/files/mrpt_index_truth.h"

#include <gtest/gtest.h>

#include "error_message.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_mrpt_index_truth
{
using testing::messageOf;
using testing::ScratchFolder;

TEST(MrptIndexTruth, OriginIsARigidTransform)
{
  const ScratchFolder folder;
  const auto poses = readMrptIndexTruth(folder.write("gt.txt", "0 0 0 0\r\n2 1 0 0.5\r\n"), {2, 4, kPi / 2});
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses.at(0).position(), Vector2d(2, 4));
  EXPECT_NEAR(poses.at(2).x, 2, 1e-12);
  EXPECT_NEAR(poses.at(2).y, 5, 1e-12);
  EXPECT_NEAR(poses.at(2).phi, kPi / 2 + 0.5, 1e-12);
}

TEST(MrptIndexTruth, MistakesAreNamedWithTheirLine)
{
  const ScratchFolder folder;
  const auto read = [&](const std::string& content)
  { return messageOf<InputError>([&] { (void)readMrptIndexTruth(folder.write("gt.txt", content), {}); }); };
  EXPECT_NE(read("1 0 0 0\n1 0 0 0\n").find("gt.txt:2: step 1 is not after"), std::string::npos);
  EXPECT_NE(read("1.5 0 0 0\n").find("gt.txt:1: '1.5' is not a step number"), std::string::npos);
  EXPECT_NE(read("1 0 0\n").find("gt.txt:1: 3 fields, expected 4"), std::string::npos);
}
}  // namespace mrpt_ext::test_mrpt_index_truth
