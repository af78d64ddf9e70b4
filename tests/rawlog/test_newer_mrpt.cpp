#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/rawlog/object_header.h"
#include "mrpt_ext/rawlog/rawlog_comment.h"
#include "mrpt_ext/rawlog/rawlog_reader.h"
#include "mrpt_ext/rawlog/unreadable_class.h"
#include "rawlog_samples.h"

namespace mrpt_ext::test_newer_mrpt
{
namespace
{
using mrpt::serialization::CSerializable;

std::string bytesOf(const CSerializable& object)
{
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << object;
  return {static_cast<const char*>(stream.getRawBufferData()), static_cast<std::size_t>(stream.getTotalBytesCount())};
}

/// An object as a newer MRPT may write it: any version, with any content.
std::string object(const std::string& class_name, char version, const std::string& content)
{
  return static_cast<char>(0x80 | class_name.size()) + class_name + version + content + '\x88';
}

std::string odometry(double time)
{
  auto observation = mrpt::obs::CObservationOdometry::Create();
  observation->timestamp = timestampOf(time);
  return bytesOf(*observation);
}

std::string newScan() { return object("mrpt::obs::CObservation2DRangeScan", 99, "beams \x88 and more"); }

std::string frameOf(const std::vector<std::string>& observations)
{
  std::string content(4, '\0');
  content[0] = static_cast<char>(observations.size());
  for (const std::string& observation : observations) content += observation;
  return object("mrpt::obs::CSensoryFrame", 2, content);
}

class LogOfNewerMrpt : public RawlogTest
{
 protected:
  [[nodiscard]] ReadResult read(const std::string& content) const
  {
    writeBytes(inFolder("new.rawlog"), content);
    return readLog(inFolder("new.rawlog"));
  }
};
}  // namespace

TEST_F(LogOfNewerMrpt, AnObservationThatNobodyNeedsIsSkippedAndCounted)
{
  const ReadResult result = read(newScan() + odometry(1) + newScan() + newScan() + odometry(2) + newScan());
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.records.size(), 2U);
  EXPECT_EQ(result.statistics.entries, 6U);
  EXPECT_EQ(result.statistics.observations.at("CObservation2DRangeScan").ignored, 4U);
  EXPECT_EQ(result.statistics.unusable.at("CObservation2DRangeScan: skipped (version 99, written by a newer MRPT)"),
            4U);
}

TEST_F(LogOfNewerMrpt, AlsoWithinASensoryFrame)
{
  const std::string beside = frameOf({odometry(1), newScan(), odometry(2)});
  const std::string alone = frameOf({newScan()}), last = frameOf({odometry(3), newScan()});
  const ReadResult result = read(beside + alone + last + odometry(4));
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.records.size(), 4U);
  EXPECT_EQ(result.statistics.entries, 4U);
  EXPECT_EQ(result.statistics.observations.at("CObservation2DRangeScan").ignored, 3U);
  EXPECT_NE(read(frameOf({odometry(1), odometry(2)}).substr(0, 90)).error.find("cut off"), std::string::npos);
}

TEST_F(LogOfNewerMrpt, AClassThatIsNeededEndsTheRunWithOneLine)
{
  const ReadResult result = read(odometry(1) + object("mrpt::obs::CObservationOdometry", 9, "x"));
  EXPECT_NE(result.error.find("record 1: written by a newer MRPT: CObservationOdometry version 9"), std::string::npos)
      << result.error;
  EXPECT_EQ(result.error.find('\n'), std::string::npos);
  writeBytes(inFolder("new.rawlog"), newScan());
  RawlogReader everything(inFolder("new.rawlog"));
  EXPECT_ANY_THROW(static_cast<void>(everything.next()));
}

TEST_F(LogOfNewerMrpt, ASkippedObservationThatIsCutOffIsTold)
{
  const std::string scan = newScan();
  EXPECT_NE(read(odometry(1) + scan.substr(0, scan.size() - 1)).error.find("record 1: cut off"), std::string::npos);
}

TEST_F(LogOfNewerMrpt, TheReleaseIsNamedWhereItIsKnown)
{
  const ObjectHeader header{"mrpt::obs::CObservationImage", 4};
  const std::string exception =
      "Message:  Exception while parsing typed object 'mrpt::obs::CObservationImage' from x\n"
      "Message:  Exception while parsing typed object 'mrpt::img::CImage' from x\n"
      "Message:  Cannot parse object: unknown serialization version number: '10'\n";
  EXPECT_EQ(unreadableClass(header, exception).value().reason(), "version 10, written by MRPT 3.0 or newer");
  EXPECT_EQ(unreadableClass(header, exception).value().class_name, "mrpt::img::CImage");
  EXPECT_FALSE(unreadableClass(header, "Message:  end-flag missing").has_value());
}

TEST_F(LogOfNewerMrpt, CommentsOfBothVersionsAreRead)
{
  const std::string text = std::string("\x09\0\0\0", 4) + "entries=1", time(8, '\1');
  const std::string label = std::string("\x03\0\0\0", 4) + "abc";
  EXPECT_EQ(read(object(kCommentClass, 0, text + time) + odometry(1)).error, "");
  EXPECT_EQ(read(object(kCommentClass, 1, text + time + label) + odometry(1)).error, "");
  const ReadResult short_by_one = read(object(kCommentClass, 1, text + time + label));
  EXPECT_NE(short_by_one.error.find("states 1 entries"), std::string::npos) << short_by_one.error;
}

// Stock tools of MRPT before 2.11.12 know no other version.
TEST_F(LogOfNewerMrpt, CommentsAreWrittenInVersionZero)
{
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  writeComment(archive, "entries=7", 1);
  stream.Seek(0);
  EXPECT_EQ(headerAt({static_cast<const unsigned char*>(stream.getRawBufferData()), 100})->version, 0);
  const auto comment = archive.ReadObject<mrpt::obs::CObservationComment>();
  EXPECT_EQ(comment->text, "entries=7");
  EXPECT_EQ(comment->timestamp, timestampOf(1));
}
}  // namespace mrpt_ext::test_newer_mrpt
