#include "mrpt_ext/vision/tags/tag_dictionary.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_tag_dictionary
{
TEST(TagDictionary, OriginalArucoMarkers)
{
  const TagDictionary dictionary = arucoOriginal();
  EXPECT_EQ(dictionary.cells, 5);
  ASSERT_EQ(dictionary.codes.size(), 1024U);
  // The cells of DICT_ARUCO_ORIGINAL in OpenCV.
  EXPECT_EQ(dictionary.codes[0], 0x1084210U);
  EXPECT_EQ(dictionary.codes[1], 0x1084217U);
  EXPECT_EQ(dictionary.codes[77], 0x10bc1d7U);
  EXPECT_EQ(dictionary.codes[1023], 0x0e739ceU);
}
}  // namespace mrpt_ext::test_tag_dictionary
