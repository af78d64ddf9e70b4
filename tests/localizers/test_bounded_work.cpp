#include <gtest/gtest.h>

#include "mrpt_ext/geometry/bounded_frame.h"
#include "mrpt_ext/geometry/work_counter.h"
#include "mrpt_ext/localizers/kalman_localizer.h"
#include "mrpt_ext/localizers/particle_filter_localizer.h"
#include "random_frames.h"
#include "test_length.h"

// Whatever the sensors report in whatever map, a step ends soon. Time is not tested: what is counted is done by the
// innermost loops themselves (work_counter.h), so that a loop around them that asks no budget is seen.
namespace mrpt_ext::test_bounded_work
{
namespace
{
constexpr double kSeedWindow = 3;             // [s]
constexpr std::size_t kFrames = 5;            // the window, the start, what follows
constexpr std::uint64_t kMost = 900'000'000;  // operations of a nanosecond or less, in one step

/// Each sensor with and without range limit, in right and wrong maps, with and without names, driving and standing.
std::vector<RandomFrames> extremeScenes(int landmarks, int detections)
{
  std::vector<RandomFrames> scenes;
  const int step = testing::isShort() ? 4 : 1;
  for (int k = 0; k < 6; k += step)
  {
    RandomFrames scene{.landmarks = landmarks, .detections = detections};
    scene.bearings = k % 3 != 1;
    scene.ranges = k % 3 != 0;
    scene.limited = k < 3;
    scene.right = k % 2 == 0;
    scene.standing = k == 3;
    scene.named = k == 5;
    RandomStream random(3, static_cast<std::uint64_t>(k));
    fillFrames(scene, kFrames, random);
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

ParticleFilterOptions filterOptions(const RandomFrames& scene)
{
  ParticleFilterOptions options;
  options.region = scene.region;
  options.motion = {.std_xy_per_m = 0.05, .std_phi_per_deg = 0.05};
  return options;
}

/// Operations of the costliest step.
std::uint64_t mostWork(Localizer& localizer, const RandomFrames& scene)
{
  std::uint64_t most = 0;
  for (const Frame& frame : scene.frames)
  {
    const std::uint64_t before = WorkCounter::done();
    (void)localizer.process(frame);
    most = std::max(most, WorkCounter::done() - before);
  }
  return most;
}

class BoundedWork : public ::testing::TestWithParam<std::pair<int, int>>
{
 protected:
  std::vector<RandomFrames> scenes_ = extremeScenes(GetParam().first, GetParam().second);
};
}  // namespace

TEST_P(BoundedWork, OfTheParticleFilter)
{
  for (const RandomFrames& scene : scenes_)
  {
    const auto search = std::make_shared<const GlobalPoseSearch>(scene.map);
    const ParticleFilterOptions options = filterOptions(scene);
    ParticleFilterLocalizer filter(options, scene.map, kSeedWindow, 1, 0, search);
    EXPECT_LT(mostWork(filter, scene), kMost) << scene.text();
    const FilterStep& step = filter.lastStep();
    EXPECT_LE(step.search_operations, search->budget().limit()) << scene.text();
    EXPECT_GE(step.detections_left_out + kMostDetections, detectionCount(scene.frames.back())) << scene.text();
    EXPECT_LE(filter.particles().size(), options.initial_particles) << scene.text();
  }
}

TEST_P(BoundedWork, OfTheKalmanFilterBank)
{
  for (const RandomFrames& scene : scenes_)
  {
    const ParticleFilterOptions like = filterOptions(scene);
    KalmanLocalizer filter("kalman_filter_bank", {.motion = like.motion}, scene.map, like.region, kSeedWindow,
                           std::make_shared<const GlobalPoseSearch>(scene.map));
    EXPECT_LT(mostWork(filter, scene), kMost) << scene.text();
  }
}

INSTANTIATE_TEST_SUITE_P(LandmarksAndDetections, BoundedWork,
                         ::testing::Values(std::pair{30, 30}, std::pair{1000, 20}, std::pair{1, 5000},
                                           std::pair{10'000, 5000}));
}  // namespace mrpt_ext::test_bounded_work
