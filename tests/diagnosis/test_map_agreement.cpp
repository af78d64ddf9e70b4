#include "mrpt_ext/diagnosis/map_agreement.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_map_agreement
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {0, 0, 0}}, {.id = 2, .position = {4, 0, 0}}});
const std::map<std::string, LandmarkRecord> kBothSeen{{"1", {.seen = 50}}, {"2", {.seen = 60}}};

std::string hintAfter(const MapAgreement& agreement, const std::map<std::string, LandmarkRecord>& seen = kBothSeen)
{
  return agreement.hint(LandmarkCheck(kMap), seen);
}
}  // namespace

TEST(MapAgreement, AMapThatIsNeverAgreedWithIsNamed)
{
  MapAgreement agreement;
  for (int k = 0; k < 30; ++k) agreement.add(k % 3 == 0 ? Verdict::lost : Verdict::ambiguous, 0.4);
  EXPECT_TRUE(agreement.neverAgreed());
  const std::string hint = hintAfter(agreement);
  EXPECT_TRUE(hint.starts_with("never `ok`: on average only 40 %")) << hint;
  EXPECT_NE(hint.find("check that the map is of this place"), std::string::npos) << hint;
}

TEST(MapAgreement, OneStretchOfOkIsAgreement)
{
  MapAgreement agreement;
  for (int k = 0; k < 100; ++k) agreement.add(k < 10 ? Verdict::ok : Verdict::lost, k < 10 ? 1 : 0.1);
  EXPECT_FALSE(agreement.neverAgreed());
  EXPECT_EQ(hintAfter(agreement), "");
}

TEST(MapAgreement, AmbiguityOfAnotherCauseIsNotTheMap)
{
  MapAgreement agreement;
  for (int k = 0; k < 100; ++k) agreement.add(Verdict::ambiguous, 0.98);
  EXPECT_EQ(hintAfter(agreement), "");
}

TEST(MapAgreement, ALogOfAFewFramesTellsNothing)
{
  MapAgreement agreement;
  for (int k = 0; k < 5; ++k) agreement.add(Verdict::lost, 0.1);
  EXPECT_EQ(hintAfter(agreement), "");
}

TEST(MapAgreement, OneLandmarkIsNotEnough)
{
  MapAgreement agreement;
  for (int k = 0; k < 30; ++k) agreement.add(Verdict::ambiguous, 0.98);
  const std::string hint = hintAfter(agreement, {{"1", {.seen = 50}}, {"2", {}}});
  EXPECT_TRUE(hint.starts_with("all detections are of one landmark")) << hint;
}
}  // namespace mrpt_ext::test_map_agreement
