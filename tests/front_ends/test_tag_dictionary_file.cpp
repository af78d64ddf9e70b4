#include "mrpt_ext/front_ends/tag_dictionary_file.h"

#include <gtest/gtest.h>

#include "error_message.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_tag_dictionary_file
{
namespace
{
using testing::messageOf;
using testing::ScratchFolder;

std::string complaintAbout(const std::string& text)
{
  const ScratchFolder folder;
  const auto file = folder.write("tags.yml", text);
  return messageOf<InputError>([&] { static_cast<void>(readTagDictionary(file)); });
}
}  // namespace

TEST(TagDictionaryFile, ReadsWhatOpenCVWrites)
{
  const ScratchFolder folder;
  const auto file = folder.write("tags.yml",
                                 "%YAML:1.0\n---\nnmarkers: 2\nmarkersize: 3\nmaxCorrectionBits: 1\n"
                                 "marker_0: \"101011111\"\nmarker_1: 011010000\n");
  const TagDictionary dictionary = readTagDictionary(file);
  EXPECT_EQ(dictionary.cells, 3);
  EXPECT_EQ(dictionary.codes, (std::vector<std::uint64_t>{0b101011111, 0b011010000}));
}

TEST(TagDictionaryFile, SaysWhatIsWrong)
{
  EXPECT_NE(complaintAbout("nmarkers: [").find("no dictionary of tags"), std::string::npos);
  EXPECT_NE(complaintAbout("nmarkers: 1\n").find("expected markersize from 3 to 8"), std::string::npos);
  EXPECT_NE(complaintAbout("just words\n").find("tags.yml: "), std::string::npos);
  EXPECT_NE(
      complaintAbout("nmarkers: 1\nmarkersize: 3\nmarker_0: \"10\"\n").find("marker_0: expected 9 cells, each 0 or 1"),
      std::string::npos);
  EXPECT_NE(complaintAbout("nmarkers: 2\nmarkersize: 3\nmarker_0: \"101011111\"\n").find("marker_1: expected"),
            std::string::npos);
}
}  // namespace mrpt_ext::test_tag_dictionary_file
