#include <gtest/gtest.h>

#include <sstream>

#include "mrpt_ext/observations/observation_text.h"
#include "sample_observations.h"

namespace mrpt_ext::test_text
{
namespace
{
std::vector<std::string> words(const std::string& line)
{
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

/// Value of the named column.
std::string cell(const mrpt::obs::CObservation& observation, const std::string& column)
{
  const auto names = words(observation.exportTxtHeader());
  const auto values = words(observation.exportTxtDataRow());
  const auto at = std::find(names.begin(), names.end(), column);
  return at == names.end() ? "no such column" : values.at(static_cast<std::size_t>(at - names.begin()));
}
}  // namespace

TEST(ObservationText, EveryRowHasAsManyCellsAsItsHeader)
{
  for (const auto& observation : samplesOfAllClasses())
  {
    EXPECT_TRUE(observation->exportTxtSupported());
    EXPECT_EQ(words(observation->exportTxtHeader()).size(), words(observation->exportTxtDataRow()).size());
    EXPECT_EQ(observation->exportTxtDataRow().find('\n'), std::string::npos);
  }
}

TEST(ObservationText, CellsAreInTheirColumns)
{
  EXPECT_EQ(cell(*sampleBearings(), "N"), "2");
  EXPECT_EQ(cell(*sampleBearings(), "category_1"), "pole");
  EXPECT_EQ(cell(*sampleBearings(), "bearing_deg_1"), "14.323945");
  EXPECT_EQ(cell(*sampleBearings(), "id_2"), "-1");
  EXPECT_EQ(cell(*sampleBearings(), "bearing_deg_3"), "nan");
  EXPECT_EQ(cell(*sampleRanges(), "range_m_2"), "2.000000");
  EXPECT_EQ(cell(*sampleRanges(), "range_m_3"), "nan");
  EXPECT_EQ(cell(*sampleRanges(), "bearing_deg_2"), "nan");
  EXPECT_EQ(cell(*sampleRanges(), "yaw_deg_1"), "nan");
  EXPECT_EQ(cell(*sampleFacings(), "yaw_deg_1"), "143.239449");
  EXPECT_EQ(cell(*sampleFacings(), "std_yaw_deg_2"), "5.729578");
  EXPECT_EQ(cell(*sampleFix(), "first_range_m"), "1.250000");
  EXPECT_EQ(cell(*sampleFix(), "dphi_deg"), "7.161972");
  EXPECT_EQ(cell(*sampleFix(), "cpp"), "0.005000000");
  EXPECT_EQ(cell(*sampleFix(), "second_bearing_deg"), "42.971835");
}

TEST(ObservationText, MoreDetectionsThanColumnsShowInTheCount)
{
  auto observation = sampleBearings();
  observation->detections.resize(kExportedDetections + 3);
  EXPECT_EQ(cell(*observation, "N"), "11");
  EXPECT_EQ(words(observation->exportTxtHeader()).size(), words(observation->exportTxtDataRow()).size());
}

TEST(ObservationText, DescriptionListsTheDetections)
{
  EXPECT_NE(sampleBearings()->asString().find("4 pole 14.3239"), std::string::npos) << sampleBearings()->asString();
  EXPECT_NE(sampleBearings()->asString().find("Field of view: 85.94 deg"), std::string::npos);
  EXPECT_NE(sampleRanges()->asString().find("3 ranges in the floor plane"), std::string::npos);
  EXPECT_NE(sampleFix()->asString().find("First range: 1.2500 +- 0.0300 m"), std::string::npos);
}

TEST(ObservationText, RangeStdFollowsFromTheDisparity)
{
  const auto observation = sampleRanges();
  EXPECT_EQ(observation->rangeStd(observation->detections[0]), 0.05);  // declared
  EXPECT_DOUBLE_EQ(observation->rangeStd(observation->detections[1]), 2.0 * 2.0 * 0.5 / 60);
  EXPECT_EQ(observation->rangeStd(observation->detections[2]), 0);  // no range
}

TEST(ObservationText, FacingsAreDescribedWhereThereAreSome)
{
  const auto described = [](const mrpt::obs::CObservation& observation)
  {
    std::ostringstream text;
    observation.getDescriptionAsText(text);
    return text.str();
  };
  EXPECT_EQ(described(*sampleRanges()).find("yaw"), std::string::npos);
  const std::string text = described(*sampleFacings());
  EXPECT_NE(text.find("bearing [deg] std [deg] yaw [deg] std [deg]"), std::string::npos) << text;
  EXPECT_NE(text.find("-171.8873 5.7296 (or 171.8873 11.4592, 0.2500)"), std::string::npos) << text;
}
}  // namespace mrpt_ext::test_text
