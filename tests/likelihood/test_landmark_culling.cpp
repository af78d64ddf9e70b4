#include "mrpt_ext/likelihood/landmark_culling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"

namespace mrpt_ext::test_landmark_culling
{
namespace
{
constexpr double kSide = 20, kCut = 3;
constexpr std::size_t kRobots = SensorTile::kSize;

struct Scene
{
  LandmarkTable map;
  Reading reading;
  Pose2 middle;
  std::vector<Pose2> robots;
  std::vector<float> x, y, phi;

  [[nodiscard]] PoseBatch batch() const { return {.x = x, .y = y, .phi = phi}; }
};

/// Robots within `spread` [m] and `turn` [rad] of one place in a hall of landmarks.
Scene sceneOf(std::uint64_t seed, double spread, double turn)
{
  RandomStream random(seed);
  std::vector<Landmark> landmarks;
  for (int j = 0; j < 200; ++j)
    landmarks.push_back({.id = j, .position = {random.uniform(0, kSide), random.uniform(0, kSide), 0}});
  Scene scene{LandmarkTable(landmarks), {}, {random.uniform(0, kSide), random.uniform(0, kSide), 0}, {}, {}, {}, {}};
  scene.middle.phi = random.uniform(-kPi, kPi);
  scene.reading.model.field_of_view = degToRad(90);
  scene.reading.model.has_field_of_view = true;
  scene.reading.model.max_range = 8;
  for (std::size_t i = 0; i < kRobots; ++i)
  {
    const Pose2 robot{scene.middle.x + random.uniform(-spread, spread),
                      scene.middle.y + random.uniform(-spread, spread),
                      wrap(scene.middle.phi + random.uniform(-turn, turn))};
    scene.robots.push_back(robot);
    scene.x.push_back(static_cast<float>(robot.x));
    scene.y.push_back(static_cast<float>(robot.y));
    scene.phi.push_back(static_cast<float>(robot.phi));
  }
  return scene;
}

LandmarkCulling windowOf(const Scene& scene)
{
  SensorTile tile;
  fillTile(tile, scene.batch(), 0, kRobots, scene.reading);
  std::fill_n(tile.range_scale, kRobots, 1.0F);
  std::fill_n(tile.range_shift, kRobots, 0.0F);
  LandmarkCulling culling(scene.map, ScoringFrame(scene.reading, {0, 0}));
  culling.update(boundsOf(std::span(&tile, 1)), VisibilityLimits(scene.reading.model));
  return culling;
}
}  // namespace

TEST(LandmarkCulling, ClassifiesByTheChancesOfAllSensors)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const Scene scene = sceneOf(seed, 0.3, 0.1);
    const LandmarkCulling culling = windowOf(scene);
    for (std::size_t j = 0; j < scene.map.size(); ++j)
      for (const Pose2& robot : scene.robots)
      {
        const double visibility = predict(scene.map[j], scene.reading, robot).visibility;
        const InView view = culling.inView()[j];
        EXPECT_LE(visibility, view == InView::no ? 1e-3 : 1.0);
        EXPECT_GE(visibility, view == InView::all ? 1 - 1e-3 : 0.0);
      }
  }
}

TEST(LandmarkCulling, LeavesOutOnlyWhatNoSensorCanHaveSeen)
{
  std::vector<std::uint32_t> all(200);
  std::iota(all.begin(), all.end(), 0U);
  std::size_t kept = 0, trials = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    const Scene scene = sceneOf(seed, 0.2, 0.05);
    const LandmarkCulling culling = windowOf(scene);
    RandomStream random(seed, 1);
    const Detection detection{
        .bearing = random.uniform(-0.7, 0.7), .range = random.uniform(1, 7), .std_bearing = 0.02, .std_range = 0.1};
    std::vector<std::uint32_t> near;
    culling.findNear(detection, kCut, all, near);
    kept += near.size();
    trials += all.size();
    for (const std::uint32_t j : all)
    {
      if (std::find(near.begin(), near.end(), j) != near.end()) continue;
      for (const Pose2& robot : scene.robots)
      {
        const LandmarkPrediction seen = predict(scene.map[j], scene.reading, robot);
        const bool possible = seen.visibility > 1e-3 &&
                              std::abs(wrap(*detection.bearing - seen.bearing)) < kCut * 0.02 &&
                              std::abs(*detection.range - seen.range) < kCut * 0.1;
        EXPECT_FALSE(possible) << "landmark " << j << ", seed " << seed;
      }
    }
  }
  EXPECT_LT(kept, trials / 20);  // and that is most of the map
}

TEST(LandmarkCulling, RobotsAllOverLeaveNothingOut)
{
  Scene scene = sceneOf(1, 15, kPi);
  scene.reading.model = {};
  const LandmarkCulling culling = windowOf(scene);
  EXPECT_TRUE(
      std::all_of(culling.inView().begin(), culling.inView().end(), [](InView view) { return view == InView::all; }));
}
}  // namespace mrpt_ext::test_landmark_culling
