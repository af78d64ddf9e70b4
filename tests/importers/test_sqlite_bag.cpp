#include "mrpt_ext/importers/rosbag2/sqlite_bag.h"

#include <gtest/gtest.h>

#include "bag_samples.h"
#include "sample_data.h"

namespace mrpt_ext::test_sqlite_bag
{
namespace
{
std::vector<std::string> topicsIn(const std::filesystem::path& path)
{
  return testing::topicsOf([&](const BagMessageSink& sink) { readSqliteBag(path, sink); });
}
}  // namespace

TEST(SqliteBag, HandsOverTheMessagesOfTheTable)
{
  const auto topics = topicsIn(testing::bag("plain.db3"));
  EXPECT_EQ(topics.size(), 22U);
  EXPECT_EQ(topics.front(), "/tf_static");
}

TEST(SqliteBag, NamesMayHoldAnything)
{
  const testing::ScratchFolder folder;
  const auto copy = folder.path() / "a ?b#c%20.db3";
  std::filesystem::copy(testing::bag("plain.db3"), copy);
  EXPECT_EQ(topicsIn(copy).size(), 22U);
}

TEST(SqliteBag, DamageIsALine)
{
  const testing::ScratchFolder folder;
  const std::string bytes = readTextFile(testing::bag("plain.db3"));
  EXPECT_INPUT_ERROR(topicsIn(folder.write("half.db3", bytes.substr(0, bytes.size() / 2))), "half.db3: ");
  std::string damaged = bytes;
  for (std::size_t i = 2000; i < 6000; ++i) damaged[i] = static_cast<char>(i);
  EXPECT_INPUT_ERROR(topicsIn(folder.write("damaged.db3", damaged)), "damaged.db3: ");
  EXPECT_INPUT_ERROR(topicsIn(folder.write("empty.db3", "")), "no table topics");
}
}  // namespace mrpt_ext::test_sqlite_bag
