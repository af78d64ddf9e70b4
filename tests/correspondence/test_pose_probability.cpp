#include <gtest/gtest.h>

#include "mrpt_ext/correspondence/bearings/bearing_search.h"
#include "mrpt_ext/correspondence/points/point_search.h"
#include "mrpt_ext/correspondence/scan_matching.h"
#include "mrpt_ext/correspondence/unsearched_evidence.h"
#include "probability_calibration.h"
#include "test_length.h"

namespace mrpt_ext::test_pose_probability
{
namespace
{
/// Where the robot of a lost scene can be: away from the border.
Box2 inner(const SceneMap& map, double border)
{
  return {Vector2d::Constant(border), Vector2d::Constant(map.side - border)};
}

struct Tally
{
  ProbabilityCalibration calibration;
  int unique = 0, unique_wrong = 0, unique_by_chance = 0;
};

/// Trials on fresh maps, twenty on each.
template <typename Search>
void run(const SearchSceneOptions& options, int maps, std::uint64_t seed, Tally& tally)
{
  for (int m = 0; m < testing::runsOfTest(maps); ++m)
  {
    RandomStream random(seed, static_cast<std::uint64_t>(m));
    const SceneMap map = randomMap(options, random);
    const LandmarkIndex index = map.index();
    const Search search(index);
    PoseSearchOptions how;
    how.area = inner(map, options.border);
    for (int t = 0; t < 20; ++t)
    {
      const SceneScan view = observeSomewhere(map, index, options, random);
      const PoseSearchResult found = search.search({&view.scan, 1}, how);
      if (found.poses.empty()) continue;
      const bool hit = isTruthsMode(found.poses.front(), view);
      tally.calibration.add(found.poses.front().probability, hit);
      tally.unique += found.unique;
      tally.unique_wrong += found.unique && !hit;
      tally.unique_by_chance += found.unique && found.expected_false > 0.05;
    }
  }
}

void expectCalibrated(const Tally& tally)
{
  if (testing::isShort()) return;  // too few trials for the bounds
  int verified = 0;
  for (const ProbabilityCalibration::Bin& bin : tally.calibration.bins)
    if (bin.isEnough())
    {
      ++verified;
      EXPECT_TRUE(bin.isInside()) << bin.hits << " of " << bin.trials << " at " << bin.meanStated();
    }
  EXPECT_GE(verified, 3);
  EXPECT_EQ(tally.unique_by_chance, 0);
  EXPECT_GT(tally.unique, 0);
  EXPECT_LE(tally.unique_wrong, tally.unique / 20 + 1);
}

TEST(PoseProbability, CalibratedForPoints)
{
  Tally tally;
  SearchSceneOptions options;
  options.landmarks = 150;
  options.max_range = options.border = 6;
  options.random_false = true;
  options.with_range = true;
  options.std_bearing = degToRad(0.5);
  std::uint64_t seed = 21;
  for (const double detection : {0.2, 0.3})
  {
    options.detection_probability = detection;
    run<PointSearch>(options, 28, seed++, tally);
  }
  expectCalibrated(tally);
}

TEST(PoseProbability, CalibratedForBearings)
{
  Tally tally;
  SearchSceneOptions options;
  options.max_range = options.border = 6;
  options.random_false = true;
  options.landmarks = 60;
  options.detection_probability = 0.45;
  options.std_bearing = degToRad(0.15);
  run<BearingSearch>(options, 4, 25, tally);
  options.landmarks = 100;
  options.detection_probability = 0.4;
  options.std_bearing = degToRad(0.3);
  options.categories = 2;
  run<BearingSearch>(options, 20, 26, tally);
  expectCalibrated(tally);
}

/// All matches counted, the expected evidence is the likelihood averaged over poses, times their volume.
TEST(PoseProbability, EvidenceOfAllPosesIsTheIntegralOfTheLikelihood)
{
  RandomStream random(23);
  for (const std::optional<double> range : {std::optional<double>(), std::optional<double>(6)})
  {
    SearchSceneOptions options;
    options.landmarks = 150;
    const SceneMap map = randomMap(options, random);
    const LandmarkIndex index = map.index();
    Scan scan;
    scan.model.max_range = range;
    scan.model.detection_probability = range ? 0.3 : 0.02;
    scan.model.clutter_probability = 0.2;
    for (int d = 0; d < 3; ++d)
      scan.detections.push_back({.bearing = random.uniform(-kPi, kPi), .std_bearing = degToRad(10)});
    const Box2 area = inner(map, 8);
    double mean = 0;
    constexpr int kPoses = 20000;
    const std::vector<int> none(3, -1);
    for (int i = 0; i < kPoses; ++i)
    {
      const GaussianPose pose{{random.uniform(area.min.x(), area.max.x()), random.uniform(area.min.y(), area.max.y()),
                               random.uniform(-kPi, kPi)},
                              1e-12 * Matrix3d::Identity()};
      mean += std::exp(scanLogLikelihood(index, scan, expectedLandmarks(index, scan, pose), none)) / kPoses;
    }
    const double integral = std::log(mean * kTwoPi * (area.max - area.min).prod());
    EXPECT_NEAR(logEvidenceOfUnsearched(index, {&scan, 1}, area, 4), integral, 0.3);
    EXPECT_LT(logEvidenceOfUnsearched(index, {&scan, 1}, area, 3), integral);
  }
}
}  // namespace
}  // namespace mrpt_ext::test_pose_probability
