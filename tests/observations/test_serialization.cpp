#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include "mrpt_ext/observations/observation_archive.h"
#include "mrpt_ext/observations/register_all_classes.h"
#include "mrpt_ext/observations/timestamps.h"
#include "sample_observations.h"

namespace mrpt_ext::test_serialization
{
namespace
{
using mrpt::serialization::archiveFrom;

std::string bytesOf(const mrpt::obs::CObservation& observation)
{
  mrpt::io::CMemoryStream stream;
  archiveFrom(stream) << observation;
  return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}

mrpt::serialization::CSerializable::Ptr readBack(std::string bytes)
{
  mrpt::io::CMemoryStream stream(bytes.data(), bytes.size());
  return archiveFrom(stream).ReadObject();
}

template <typename Observation>
typename Observation::Ptr roundTrip(const Observation& observation)
{
  return std::dynamic_pointer_cast<Observation>(readBack(bytesOf(observation)));
}

void expectSameHeader(const mrpt::obs::CObservation& a, const mrpt::obs::CObservation& b)
{
  EXPECT_EQ(a.timestamp, b.timestamp);
  EXPECT_EQ(a.sensorLabel, b.sensorLabel);
  // The archive stores the rotation as a quaternion.
  EXPECT_NEAR((a.sensorPose() - b.sensorPose()).norm(), 0, 1e-12);
  EXPECT_NEAR(a.sensorPose().yaw, b.sensorPose().yaw, 1e-12);
}

class ObservationSerialization : public ::testing::Test
{
 protected:
  void SetUp() override { registerAllObservationClasses(); }
};
}  // namespace

TEST_F(ObservationSerialization, EveryClassIsRegisteredAndSurvivesTheRoundTrip)
{
  for (const auto& observation : samplesOfAllClasses())
  {
    SCOPED_TRACE(observation->GetRuntimeClass()->className);
    EXPECT_NE(mrpt::rtti::findRegisteredClass(observation->GetRuntimeClass()->className), nullptr);
    const auto copy = std::dynamic_pointer_cast<mrpt::obs::CObservation>(readBack(bytesOf(*observation)));
    ASSERT_TRUE(copy);
    EXPECT_EQ(copy->GetRuntimeClass(), observation->GetRuntimeClass());
    expectSameHeader(*copy, *observation);
    EXPECT_EQ(copy->exportTxtDataRow(), observation->exportTxtDataRow());
  }
}

TEST_F(ObservationSerialization, BearingsKeepEveryField)
{
  const auto original = sampleBearings();
  const auto copy = roundTrip(*original);
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->field_of_view, 1.5);
  EXPECT_EQ(copy->max_range, 8);
  ASSERT_EQ(copy->detections.size(), 2U);
  EXPECT_EQ(copy->detections[0].id, 4);
  EXPECT_EQ(copy->detections[0].category, "pole");
  EXPECT_EQ(copy->detections[0].bearing, 0.25);
  EXPECT_EQ(copy->detections[0].std_bearing, 0.01);
  EXPECT_EQ(copy->detections[1].id, mrpt::obs::INVALID_LANDMARK_ID);
  EXPECT_EQ(copy->detections[1].category, "");
}

TEST_F(ObservationSerialization, RangesKeepEveryField)
{
  const auto original = sampleRanges();
  const auto copy = roundTrip(*original);
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->field_of_view, 1.2);
  EXPECT_EQ(copy->max_range, 5);
  EXPECT_EQ(copy->baseline_focal, 60);
  EXPECT_TRUE(copy->horizontal);
  ASSERT_EQ(copy->detections.size(), original->detections.size());
  for (std::size_t i = 0; i < original->detections.size(); ++i)
  {
    const auto &a = copy->detections[i], &b = original->detections[i];
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.category, b.category);
    EXPECT_EQ(a.range, b.range);
    EXPECT_EQ(a.std_range, b.std_range);
    EXPECT_EQ(a.std_disparity, b.std_disparity);
    EXPECT_EQ(a.bearing, b.bearing);
    EXPECT_EQ(a.std_bearing, b.std_bearing);
  }
}

TEST_F(ObservationSerialization, FacingsAreKept)
{
  const auto copy = roundTrip(*sampleFacings());
  ASSERT_TRUE(copy);
  ASSERT_TRUE(copy->detections[0].facing && copy->detections[1].facing);
  EXPECT_EQ(copy->detections[0].facing->attitudes[0].yaw, 2.5);
  EXPECT_EQ(copy->detections[0].facing->attitudes[1].weight, 0);
  const auto& [first, second] = copy->detections[1].facing->attitudes;
  EXPECT_EQ(first.yaw, -3);
  EXPECT_EQ(first.std, 0.1);
  EXPECT_EQ(first.weight, 0.75);
  EXPECT_EQ(second.yaw, 3);
  EXPECT_EQ(second.std, 0.2);
  EXPECT_EQ(second.weight, 0.25);
  EXPECT_FALSE(copy->detections[2].facing);
}

TEST_F(ObservationSerialization, WithoutFacingsTheBytesAreThoseOfVersionZero)
{
  const auto versionOf = [](const CObservationStereoRanges& observation)
  {
    const std::string bytes = bytesOf(observation), name = observation.GetRuntimeClass()->className;
    return static_cast<int>(bytes.at(1 + name.size()));
  };
  EXPECT_EQ(versionOf(*sampleRanges()), 0);
  EXPECT_EQ(versionOf(*sampleFacings()), 1);
  EXPECT_EQ(bytesOf(*sampleFacings()).size(), bytesOf(*sampleRanges()).size() + 3 + 2 * 5 * sizeof(double));
}

TEST_F(ObservationSerialization, RunningFixKeepsEveryField)
{
  auto original = sampleFix();
  for (const bool with_bearing : {true, false})
  {
    if (!with_bearing) original->second_bearing.reset();
    const auto copy = roundTrip(*original);
    ASSERT_TRUE(copy);
    EXPECT_TRUE(copy->horizontal);
    EXPECT_EQ(copy->id, 9);
    EXPECT_EQ(copy->first_timestamp, original->first_timestamp);
    EXPECT_EQ(copy->first_range, 1.25);
    EXPECT_EQ(copy->first_std, 0.03);
    EXPECT_EQ(copy->second_range, 2.5);
    EXPECT_EQ(copy->second_std, 0.04);
    EXPECT_EQ(copy->displacement, original->displacement);
    EXPECT_EQ(copy->displacement_covariance, original->displacement_covariance);
    EXPECT_EQ(copy->second_bearing, original->second_bearing);
    EXPECT_EQ(copy->second_bearing_std, 0.015);
  }
}

// Layout of a stored object: flag byte (length of the name | 0x80), class name, version, data, end flag.
TEST_F(ObservationSerialization, AnUnknownVersionIsRefused)
{
  for (const auto& observation : samplesOfAllClasses())
  {
    std::string bytes = bytesOf(*observation);
    const std::string name = observation->GetRuntimeClass()->className;
    const std::size_t version_at = bytes.find(name) + name.size();
    ASSERT_TRUE(bytes[version_at] == 0 || bytes[version_at] == 1);
    bytes[version_at] = 99;
    EXPECT_ANY_THROW((void)readBack(bytes)) << name;
  }
}

TEST_F(ObservationSerialization, AnImplausibleNumberOfDetectionsIsRefusedBeforeMemoryIsClaimed)
{
  mrpt::io::CMemoryStream stream;
  auto archive = archiveFrom(stream);
  archive << std::uint32_t{0xFFFFFFF0};
  stream.Seek(0);
  EXPECT_THROW((void)readDetectionCount(archive), std::runtime_error);
}

TEST_F(ObservationSerialization, EveryTruncationIsRefused)
{
  for (const auto& observation : samplesOfAllClasses())
  {
    const std::string bytes = bytesOf(*observation);
    for (std::size_t length = 0; length < bytes.size(); ++length)
      EXPECT_ANY_THROW((void)readBack(bytes.substr(0, length))) << length;
  }
}

TEST(Timestamps, KeepSevenDecimalsInBothDirections)
{
  for (const double time : {0.0, 0.1, 0.3, 1e-7, 12345.6789012, 1178275990.97491, -5.25})
    EXPECT_EQ(secondsOf(timestampOf(time)), time);
  EXPECT_NEAR(mrpt::Clock::toDouble(timestampOf(1178275990.5)), 1178275990.5, 1e-6);
  EXPECT_FALSE(isValid(INVALID_TIMESTAMP));
  EXPECT_TRUE(isValid(timestampOf(0)));
}
}  // namespace mrpt_ext::test_serialization
