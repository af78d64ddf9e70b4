#include "mrpt_ext/importers/rosbag2/bag_files.h"

#include <gtest/gtest.h>

#include "bag_samples.h"
#include "sample_data.h"

namespace mrpt_ext::test_bag_files
{
namespace
{
namespace fs = std::filesystem;

std::vector<std::string> topicsIn(const std::vector<fs::path>& inputs)
{
  return testing::topicsOf([&](const BagMessageSink& sink) { static_cast<void>(readBag(inputs, sink)); });
}
}  // namespace

TEST(BagFiles, AFolderNamesItsFilesInOrder)
{
  const auto folder = topicsIn({testing::bag("two_files")});
  EXPECT_EQ(folder, topicsIn({testing::bag("drive_zstd.mcap")}));
  EXPECT_EQ(folder, topicsIn({testing::bag("two_files/drive_0.db3.zstd"), testing::bag("two_files/drive_1.db3.zstd")}));
}

TEST(BagFiles, WithoutMetadataTheyAreTakenByName)
{
  const testing::ScratchFolder folder;
  for (const char* name : {"drive_0.db3.zstd", "drive_1.db3.zstd"})
    fs::copy(testing::bag("two_files") / name, folder.path() / name);
  EXPECT_EQ(topicsIn({folder.path()}), topicsIn({testing::bag("two_files")}));
}

TEST(BagFiles, MessagesMayBeCompressedOneByOne)
{
  EXPECT_EQ(topicsIn({testing::bag("packed_messages")}), topicsIn({testing::bag("plain.mcap")}));
}

TEST(BagFiles, DamageNamesTheFileThatTheUserKnows)
{
  const testing::ScratchFolder folder;
  const std::string packed = readTextFile(testing::bag("two_files/drive_0.db3.zstd"));
  EXPECT_INPUT_ERROR(topicsIn({folder.write("cut.db3.zstd", packed.substr(0, 1000))}), "cut.db3.zstd: ");
  EXPECT_INPUT_ERROR(topicsIn({folder.write("a.mcap", "abc")}), "a.mcap: neither an MCAP nor an sqlite3 file");
  EXPECT_INPUT_ERROR(topicsIn({folder.write("a.bag", "#ROSBAG V2.0\n and more")}), "ROS 1");
  EXPECT_INPUT_ERROR(topicsIn({folder.path() / "none"}), "none: cannot be opened");
  const testing::ScratchFolder empty;
  EXPECT_INPUT_ERROR(topicsIn({empty.path()}), "neither metadata.yaml nor a file");
  static_cast<void>(empty.write("metadata.yaml", "rosbag2_bagfile_information: 3"));
  EXPECT_INPUT_ERROR(topicsIn({empty.path()}), "metadata.yaml: ");
}
}  // namespace mrpt_ext::test_bag_files
