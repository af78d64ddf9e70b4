#include "mrpt_ext/hypotheses/bias_inflation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mrpt_ext::test_bias_inflation
{
namespace
{
std::vector<Reading> oneReading()
{
  Reading reading{.time = 1, .sensor = "radio"};
  reading.detections = {{1, "", std::nullopt, 52.5, 0, 0.5}, {2, "", 0.3, std::nullopt, 0.03, 0}};
  return {reading};
}
}  // namespace

TEST(BiasInflation, WithoutAModelNothingChanges)
{
  const auto readings = withBiasUncertainty(oneReading(), {});
  EXPECT_EQ(readings[0].detections[0].range, 52.5);
  EXPECT_EQ(readings[0].detections[0].std_range, 0.5);
}

TEST(BiasInflation, MeansAreSubtractedAndStandardDeviationsInflated)
{
  const BiasModel biases = {{.kind = BiasKind::range_scale, .mean = 0.05, .std = 0.02},
                            {.kind = BiasKind::range_offset, .sensor = "radio", .mean = 0, .std = 0.3},
                            {.kind = BiasKind::range_offset, .sensor = "other", .mean = 7, .std = 9},
                            {.kind = BiasKind::bearing_offset, .mean = 0.1, .std = 0.04}};
  const auto readings = withBiasUncertainty(oneReading(), biases);
  const Detection &range = readings[0].detections[0], &bearing = readings[0].detections[1];
  EXPECT_NEAR(*range.range, 50, 1e-12);
  EXPECT_NEAR(range.std_range, std::sqrt(0.25 + 0.09 + 1) / 1.05, 1e-12);
  EXPECT_NEAR(*bearing.bearing, 0.2, 1e-12);
  EXPECT_NEAR(bearing.std_bearing, 0.05, 1e-12);
}

TEST(BiasInflation, ARangeThatTheMeanWouldMakeNegativeIsLeftAsItIs)
{
  const auto readings = withBiasUncertainty(oneReading(), {{.kind = BiasKind::range_offset, .mean = 60, .std = 1}});
  EXPECT_EQ(readings[0].detections[0].range, 52.5);
}

TEST(BiasInflation, ABearingOffsetTurnsFacingsAsWell)
{
  auto readings = oneReading();
  readings[0].detections[1].facing = Facing::single(1, 0.03);
  readings = withBiasUncertainty(readings, {{.kind = BiasKind::bearing_offset, .mean = 0.1, .std = 0.04}});
  EXPECT_NEAR(readings[0].detections[1].facing->attitudes[0].yaw, 0.9, 1e-12);
  EXPECT_NEAR(readings[0].detections[1].facing->attitudes[0].std, 0.05, 1e-12);
}
}  // namespace mrpt_ext::test_bias_inflation
