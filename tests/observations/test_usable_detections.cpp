#include "mrpt_ext/observations/usable_detections.h"

#include <gtest/gtest.h>

#include <limits>

namespace mrpt_ext::test_usable_detections
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}

TEST(UsableDetections, KeepsTheGoodAndCountsTheRestByReason)
{
  Reading reading;
  reading.detections = {{.bearing = 0.5, .std_bearing = 0.1},
                        {.range = 2.0, .std_range = 0.1},
                        {.range = 0.0, .std_range = 0.1},
                        {.range = -1.0, .std_range = 0.1},
                        {.range = kNan, .std_range = 0.1},
                        {.bearing = kNan, .std_bearing = 0.1},
                        {.bearing = 0.5, .range = 2.0, .std_bearing = -0.1, .std_range = 0.1},
                        {}};
  UnusableCounts counts;
  removeUnusable(reading, counts);
  EXPECT_EQ(reading.detections.size(), 2U);
  const UnusableCounts expected = {{"range not positive", 2},
                                   {"range not finite", 1},
                                   {"bearing not finite", 1},
                                   {"bearing std negative or not finite", 1},
                                   {"neither bearing nor range", 1}};
  EXPECT_EQ(counts, expected);
}

TEST(UsableDetections, WrapsBearings)
{
  Reading reading;
  reading.detections = {{.bearing = 1.5 * kPi, .std_bearing = 0.1}};
  UnusableCounts counts;
  removeUnusable(reading, counts);
  EXPECT_NEAR(*reading.detections.at(0).bearing, -0.5 * kPi, 1e-12);
  EXPECT_TRUE(counts.empty());
}

TEST(UsableDetections, ChecksRunningFixes)
{
  RunningFixReading fix;
  fix.first_range = 1;
  fix.second_range = 2;
  EXPECT_EQ(whyUnusable(fix), "");
  fix.second_range = 0;
  EXPECT_EQ(whyUnusable(fix), "range not positive");
  fix.second_range = 2;
  fix.displacement.x = kNan;
  EXPECT_EQ(whyUnusable(fix), "displacement not finite");
  fix.displacement.x = 0;
  fix.second_bearing = kNan;
  EXPECT_EQ(whyUnusable(fix), "bearing not finite");
}

TEST(UsableDetections, AnImpossibleFacingIsDroppedAlone)
{
  const auto kept = [](const Facing& facing)
  {
    Reading reading;
    reading.detections = {{.bearing = 0.5, .std_bearing = 0.1, .facing = facing}};
    UnusableCounts counts;
    removeUnusable(reading, counts);
    EXPECT_EQ(reading.detections.size(), 1U);
    EXPECT_EQ(counts.empty(), reading.detections.at(0).facing.has_value());
    return reading.detections.at(0).facing.has_value();
  };
  EXPECT_TRUE(kept(Facing::single(1, 0.1)));
  EXPECT_TRUE(kept(Facing::either({1, 0.1}, {2, 0.1}, 0.3)));
  EXPECT_FALSE(kept(Facing::single(1, 0)));
  EXPECT_FALSE(kept(Facing::single(kNan, 0.1)));
  EXPECT_FALSE(kept(Facing::either({1, 0.1}, {2, kNan}, 0.3)));
  EXPECT_FALSE(kept(Facing{{{{1, 0.1, 1.5}, {2, 0.1, -0.5}}}}));
  EXPECT_FALSE(kept(Facing{{{{1, 0.1, kNan}, {2, 0.1, kNan}}}}));
}
}  // namespace mrpt_ext::test_usable_detections
