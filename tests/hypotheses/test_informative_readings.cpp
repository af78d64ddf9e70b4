#include "mrpt_ext/hypotheses/informative_readings.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mrpt_ext::test_informative_readings
{
namespace
{
std::vector<Reading> readings(std::size_t count, std::size_t detections, const std::vector<std::string>& sensors)
{
  std::vector<Reading> all;
  for (std::size_t k = 0; k < count; ++k)
    for (const std::string& sensor : sensors)
    {
      Reading& reading = all.emplace_back();
      reading.time = static_cast<double>(k);
      reading.sensor = sensor;
      reading.detections.resize(detections);
    }
  return all;
}

std::size_t countOf(const std::vector<Reading>& all, const std::string& sensor)
{
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [&](const Reading& r) { return r.sensor == sensor; }));
}
}  // namespace

TEST(JoinedReadings, AWindowOfUsualSizeStaysWhole)
{
  EXPECT_EQ(informativeReadings(readings(24, 8, {"laser"})).size(), 24u);
  EXPECT_TRUE(informativeReadings({}).empty());
}

TEST(JoinedReadings, OfManyDetectionsEveryNthReadingIsTaken)
{
  const auto all = readings(24, 60, {"laser"});
  const auto chosen = informativeReadings(all);
  EXPECT_EQ(chosen.size(), kLeastJoinedReadings);
  EXPECT_EQ(chosen.back().time, all.back().time);
  EXPECT_LE(chosen.front().time, 4) << "the window keeps its length";
}

TEST(JoinedReadings, EverySensorKeepsItsShare)
{
  const auto chosen = informativeReadings(readings(90, 3, {"left", "right"}));
  EXPECT_EQ(countOf(chosen, "left"), countOf(chosen, "right"));
  EXPECT_LE(countOf(chosen, "left"), kMostJoinedReadings);
  EXPECT_EQ(chosen.back().time, 89);
}
}  // namespace mrpt_ext::test_informative_readings
