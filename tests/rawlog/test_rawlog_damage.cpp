#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/poses/CPose3D.h>

#include <algorithm>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"
#include "rawlog_samples.h"

namespace mrpt_ext::test_rawlog_damage
{
namespace
{
/// Damage must be reported: no crash, and never fewer records without an error.
class RawlogDamage : public RawlogTest
{
 protected:
  void SetUp() override
  {
    RawlogTest::SetUp();
    writeRawlog(inFolder("good.rawlog"), recording_);
    good_ = readBytes(inFolder("good.rawlog"));
    content_ = decompress(good_);
  }

  /// Either reported, or every record of the good log was still found and accounted for.
  void expectNothingLostSilently(const ReadResult& result) const
  {
    if (!result.error.empty()) return;
    std::size_t ignored = 0;
    for (const auto& [name, count] : result.statistics.observations) ignored += count.ignored;
    // A comment in a damaged version counts as ignored.
    EXPECT_GE(result.records.size() + ignored, recording_.records.size());
  }

  [[nodiscard]] ReadResult readDamaged(const std::string& bytes) const
  {
    writeBytes(inFolder("damaged.rawlog"), bytes);
    return readLog(inFolder("damaged.rawlog"));
  }

  const Recording recording_ = sampleRecording(4);
  std::string good_, content_;
};

bool names(const ReadResult& result, const std::string& text) { return result.error.find(text) != std::string::npos; }
}  // namespace

TEST_F(RawlogDamage, TheGoodLogIsGood)
{
  EXPECT_EQ(readDamaged(good_).error, "");
  EXPECT_EQ(readDamaged(content_).error, "");  // not compressed
  EXPECT_EQ(readDamaged(compress(content_)).error, "");
}

TEST_F(RawlogDamage, EveryTruncationOfTheFileIsTold)
{
  for (std::size_t length = 0; length < good_.size(); ++length)
  {
    const ReadResult result = readDamaged(good_.substr(0, length));
    ASSERT_NE(result.error, "") << length << " of " << good_.size() << " bytes";
    EXPECT_TRUE(length < 2 || names(result, ": record ")) << result.error;
  }
  EXPECT_TRUE(names(readDamaged(good_.substr(0, good_.size() / 2)), "truncated"));
  EXPECT_TRUE(names(readDamaged(good_.substr(0, good_.size() - 1)), "truncated"));
}

TEST_F(RawlogDamage, EveryTruncationOfTheContentIsTold)
{
  for (std::size_t length = 0; length < content_.size();
       length += length < 300 || length > content_.size() - 300 ? 1 : 37)
  {
    EXPECT_NE(readDamaged(content_.substr(0, length)).error, "") << length;
    EXPECT_NE(readDamaged(compress(content_.substr(0, length))).error, "") << length;
  }
}

TEST_F(RawlogDamage, AFlippedByteIsTold)
{
  RandomStream random(1);
  int reported = 0;
  for (int i = 0; i < 300; ++i)
  {
    std::string bytes = good_;
    const std::size_t at = 10 + random.below(bytes.size() - 10);  // the gzip header before holds free fields
    bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1 + random.below(255)));
    // A back reference changed to a position with the same text leaves the content as it was.
    const bool is_reported = !readDamaged(bytes).error.empty();
    EXPECT_TRUE(is_reported || decompress(bytes) == content_) << at;
    reported += is_reported ? 1 : 0;
  }
  EXPECT_GT(reported, 290);
}

// Behind an intact checksum a changed number is a different number, but records must not vanish.
TEST_F(RawlogDamage, DamagedContentNeverLosesRecordsSilently)
{
  RandomStream random(2);
  int reported = 0;
  for (int i = 0; i < 400; ++i)
  {
    std::string content = content_;
    const std::size_t changes = 1 + random.below(4);
    for (std::size_t change = 0; change < changes; ++change)
      content[random.below(content.size())] = static_cast<char>(random.below(256));
    const ReadResult result = readDamaged(content);
    reported += result.error.empty() ? 0 : 1;
    expectNothingLostSilently(result);
  }
  EXPECT_GT(reported, 100);
}

TEST_F(RawlogDamage, RemovedAndInsertedBytesAreTold)
{
  RandomStream random(3);
  int reported = 0;
  for (int i = 0; i < 300; ++i)
  {
    std::string content = content_;
    const std::size_t at = random.below(content.size() - 40), length = 1 + random.below(40);
    if (i % 2 == 0)
      content.erase(at, length);
    else
      content.insert(at, length, static_cast<char>(random.below(256)));
    const ReadResult result = readDamaged(compress(content));
    reported += result.error.empty() ? 0 : 1;
    expectNothingLostSilently(result);  // bytes inserted after a flag may be read as the optional fields it announces
  }
  EXPECT_GT(reported, 290);
}

TEST_F(RawlogDamage, GarbageIsTold)
{
  RandomStream random(4);
  for (const std::size_t size : {1U, 2U, 10U, 1000U, 100000U})
  {
    std::string bytes(size, '\0');
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(random.below(256)); });
    EXPECT_TRUE(names(readDamaged(bytes), "record 0")) << size;
  }
  EXPECT_TRUE(names(readDamaged("t,x,y,phi\n0,1,2,3\n"), "record 0"));
  EXPECT_NE(readDamaged(good_ + "trailing garbage").error, "");
}

TEST_F(RawlogDamage, EmptyMissingAndWrongFilesAreTold)
{
  EXPECT_TRUE(names(readDamaged(""), "is empty"));
  EXPECT_TRUE(names(readLog(inFolder("missing.rawlog")), "missing.rawlog: cannot be opened"));
  EXPECT_TRUE(names(readLog(inFolder("")), "is a folder"));
}

TEST_F(RawlogDamage, AnUnknownClassIsNamedWithItsRecordAndTheRemedy)
{
  std::string content = content_;
  const std::string known = "CObservationLandmarkBearings", unknown = "CObservationLandmarkHearings";
  content.replace(content.find(known), known.size(), unknown);
  const ReadResult result = readDamaged(content);
  EXPECT_TRUE(names(result, "record 10: unknown class 'mrpt_ext::CObservationLandmarkHearings'")) << result.error;
  EXPECT_TRUE(names(result, "LD_PRELOAD"));
  EXPECT_EQ(result.error.find('\n'), std::string::npos);
}

TEST_F(RawlogDamage, ObjectsThatAreNoPartOfALogAreNamed)
{
  writeObjects(inFolder("pose.rawlog"), {mrpt::obs::CObservationOdometry::Create(), mrpt::poses::CPose3D::Create()});
  EXPECT_TRUE(names(readLog(inFolder("pose.rawlog")), "record 1: a CPose3D"));
}

TEST_F(RawlogDamage, AStatedNumberOfEntriesMustBeThere)
{
  std::string content = content_;
  const std::string stated = "entries=" + std::to_string(recording_.records.size());
  content.replace(content.find(stated), stated.size(), "entries=99");
  const ReadResult result = readDamaged(content);
  EXPECT_TRUE(names(result, "states 99 entries")) << result.error;
}
}  // namespace mrpt_ext::test_rawlog_damage
