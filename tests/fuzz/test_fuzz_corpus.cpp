#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz_targets.h"
#include "mrpt_ext/geometry/random.h"

// The seeds of the fuzzer and the inputs that once did harm, each through every reader, whole and changed.
namespace mrpt_ext::test_fuzz_corpus
{
namespace
{
namespace fs = std::filesystem;

std::string bytesIn(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> inputs()
{
  std::vector<fs::path> files;
  for (const fs::path& folder :
       {fs::path(MRPT_EXT_SOURCE_DIR) / "tests/fuzz/corpus", fs::path(MRPT_EXT_TEST_DATA) / "faults"})
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}
}  // namespace

TEST(FuzzCorpus, EveryTargetHasSeeds)
{
  for (const auto& [name, target] : fuzzTargets())
    EXPECT_FALSE(fs::is_empty(fs::path(MRPT_EXT_SOURCE_DIR) / "tests/fuzz/corpus" / name)) << name;
}

TEST(FuzzCorpus, EveryReaderReadsOrRefusesEveryInput)
{
  for (const fs::path& file : inputs())
    for (const auto& [name, target] : fuzzTargets()) EXPECT_NO_THROW(target(bytesIn(file))) << name << file;
}

TEST(FuzzCorpus, ChangedInputsAreReadOrRefused)
{
  RandomStream random(1);
  for (const auto& [name, target] : fuzzTargets())
    for (const auto& entry : fs::directory_iterator(fs::path(MRPT_EXT_SOURCE_DIR) / "tests/fuzz/corpus" / name))
    {
      const std::string seed = bytesIn(entry.path());
      for (int i = 0; i < 200; ++i)
      {
        std::string bytes = seed;
        for (std::size_t change = 0; change < 1 + random.below(4); ++change)
          bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
        if (i % 4 == 0) bytes.resize(random.below(bytes.size()));
        EXPECT_NO_THROW(target(bytes)) << name << ' ' << entry.path() << ' ' << i;
      }
    }
}
}  // namespace mrpt_ext::test_fuzz_corpus
