#include "mrpt_ext/scene/playback_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mrpt_ext::test_playback_recorder
{
TEST(ParticlesByWeight, AreDrawnInProportionToTheirWeight)
{
  ParticleSet particles(Vector2d{0, 0});
  for (int i = 0; i < 1000; ++i) particles.add({i < 10 ? 1.0 : 2.0, 0, 0}, std::log(i < 10 ? 0.05 : 0.5 / 990));
  const std::vector<Pose2> drawn = particlesByWeight(particles, 100);
  ASSERT_EQ(drawn.size(), 100u);
  const auto heavy = std::count_if(drawn.begin(), drawn.end(), [](const Pose2& pose) { return pose.x == 1.0; });
  EXPECT_GE(heavy, 49);
  EXPECT_LE(heavy, 51);
}

TEST(ParticlesByWeight, OfFewAreAll)
{
  ParticleSet particles(Vector2d{0, 0});
  for (int i = 0; i < 7; ++i) particles.add({i * 1.0, 0, 0}, std::log(1.0 / 7));
  EXPECT_EQ(particlesByWeight(particles, 100).size(), 7u);
  EXPECT_TRUE(particlesByWeight(ParticleSet(Vector2d{0, 0}), 100).empty());
}

TEST(PlaybackRecorder, KeepsEveryFrameOfAShortRunAndAThousandOfALongOne)
{
  const LandmarkTable map;
  for (const std::size_t frames : {40u, 1000u, 1001u, 30000u})
  {
    PlaybackRecorder recorder(frames, map);
    std::vector<PlaybackStep> playback;
    for (std::size_t i = 0; i < frames; ++i)
    {
      Frame frame;
      frame.time = static_cast<double>(i);
      recorder.add(frame, nullptr, playback);
    }
    EXPECT_LE(playback.size(), 1000u);
    EXPECT_GE(playback.size(), std::min<std::size_t>(frames, 500));
    EXPECT_EQ(playback.front().time, 0);
  }
}

TEST(PlaybackRecorder, SlantRangesAreProjectedToThePlane)
{
  const LandmarkTable map({{4, {0, 0, 3}, "", {0, 0}}});
  Reading reading;
  reading.detections = {{.id = 4, .range = 5.0}, {.range = 5.0}};
  Frame frame;
  frame.readings = {reading};
  std::vector<PlaybackStep> playback;
  PlaybackRecorder(1, map).add(frame, nullptr, playback);
  ASSERT_EQ(playback.at(0).detections.size(), 2u);
  EXPECT_NEAR(*playback[0].detections[0].range, 4.0, 1e-12);
  EXPECT_NEAR(*playback[0].detections[1].range, 5.0, 1e-12);
}
}  // namespace mrpt_ext::test_playback_recorder
