#include "mrpt_ext/rawlog/sha256.h"

#include <gtest/gtest.h>

#include "scratch_folder.h"

namespace mrpt_ext::test_sha256
{
// FIPS 180-2, appendix B.
TEST(Sha256, OfTheTestVectors)
{
  Sha256 digest;
  const std::string text = "abc";
  for (const char c : text)
  {
    const auto byte = static_cast<unsigned char>(c);
    digest.add({&byte, 1});
  }
  EXPECT_EQ(digest.hex(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, OfAFileThatDoesNotExistIsEmpty)
{
  EXPECT_EQ(sha256OfText("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256OfFile("no/such/file"), "");
  const testing::ScratchFolder folder;
  const std::string path = folder.write("abc", "abc").string();
  EXPECT_EQ(sha256OfFile(path), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}
}  // namespace mrpt_ext::test_sha256
