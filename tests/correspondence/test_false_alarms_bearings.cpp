#include "mrpt_ext/correspondence/false_alarms_bearings.h"

#include <gtest/gtest.h>

#include <array>

#include "global_search_scene.h"
#include "mrpt_ext/correspondence/bearings/bearing_search.h"
#include "mrpt_ext/correspondence/points/false_alarms_points.h"
#include "mrpt_ext/correspondence/points/point_search.h"
#include "test_length.h"

namespace mrpt_ext::test_false_alarms_bearings
{
namespace
{
constexpr double kGate = 3.3;
constexpr int kMost = 16;

/// Sums over scenes with false detections only, by the number of matches.
struct Account
{
  std::array<double, kMost> expected{}, counted{};

  void expectAgreement(int matched) const
  {
    if (testing::isShort()) return;  // too few scenes
    const auto m = static_cast<std::size_t>(matched);
    EXPECT_GT(counted[m], 20) << matched;
    EXPECT_LT(expected[m], 2.5 * counted[m]) << matched;
    EXPECT_GT(expected[m], counted[m] / 2.5) << matched;
  }
};

SearchSceneOptions falseDetectionsOnly(int landmarks, double detections, double std_bearing_deg)
{
  SearchSceneOptions options;
  options.landmarks = landmarks;
  options.max_range = options.border = 6;
  options.detection_probability = 0;
  options.false_detections = detections;
  options.std_bearing = degToRad(std_bearing_deg);
  return options;
}

/// `expected(index, scan, found, m)`: number of poses with at least m matches.
template <typename Search, typename Expected>
Account countPoses(const SearchSceneOptions& options, int scenes, Expected&& expected)
{
  Account account;
  for (int scene = 0; scene < testing::runsOfTest(scenes); ++scene)
  {
    RandomStream random(5, static_cast<std::uint64_t>(scene));
    const SceneMap map = randomMap(options, random);
    const LandmarkIndex index = map.index();
    Scan scan = observeSomewhere(map, index, options, random).scan;
    scan.model.detection_probability = 0.6;
    scan.model.clutter_probability = 0.1;
    PoseSearchOptions everything;
    everything.keep_log_units = 1e6;
    everything.max_poses = 100'000;
    const PoseSearchResult found = Search(index).search({&scan, 1}, everything);
    for (int m = 3; m < kMost; ++m)
    {
      account.expected[static_cast<std::size_t>(m)] += expected(index, scan, found, m);
      account.counted[static_cast<std::size_t>(m)] += static_cast<double>(std::count_if(
          found.poses.begin(), found.poses.end(), [m](const ConsistentPose& p) { return p.matched >= m; }));
    }
  }
  return account;
}

/// The search reports its expectation for the number of matches of the best pose; this scales it to others.
double expectedOfBearings(const LandmarkIndex& index, const Scan& scan, const PoseSearchResult& found, int matched)
{
  int best = 0;
  for (const ConsistentPose& pose : found.poses) best = std::max(best, pose.matched);
  const double in_view = static_cast<double>(index.size()) *
                         std::min(1.0, kPi * square(*scan.model.max_range) / (index.high() - index.low()).prod());
  const BearingFalseAlarmModel chance{1, static_cast<int>(scan.detections.size()),
                                      chanceMatchProbability(kGate * scan.detections.front().std_bearing, in_view - 3)};
  return best == 0 ? 0 : found.expected_false * expectedFalsePoses(chance, matched) / expectedFalsePoses(chance, best);
}

double expectedOfPoints(const LandmarkIndex& index, const Scan& scan, const PoseSearchResult&, int matched)
{
  return expectedFalsePoses(pointFalseAlarmModel(index, gatherPoints({&scan, 1}, kGate), kGate), matched);
}

TEST(ExpectedFalsePoses, AreAsManyAsChanceMakesOfBearings)
{
  const Account few = countPoses<BearingSearch>(falseDetectionsOnly(60, 7, 0.1), 8, expectedOfBearings);
  few.expectAgreement(5);
  const Account many = countPoses<BearingSearch>(falseDetectionsOnly(60, 9, 0.3), 4, expectedOfBearings);
  many.expectAgreement(6);
}

TEST(ExpectedFalsePoses, AreAsManyAsChanceMakesOfPoints)
{
  SearchSceneOptions options = falseDetectionsOnly(300, 6, 0.5);
  options.with_range = true;
  const Account round = countPoses<PointSearch>(options, 160, expectedOfPoints);
  round.expectAgreement(3);
  round.expectAgreement(4);
  // Points whose errors are long and thin.
  options = falseDetectionsOnly(300, 8, 0.1);
  options.with_range = true;
  const Account thin = countPoses<PointSearch>(options, 40, expectedOfPoints);
  thin.expectAgreement(3);
}

TEST(ExpectedFalsePoses, FallWithTheMatchesAndRiseWithTheReadings)
{
  for (int m = 3; m < 9; ++m)
  {
    const BearingFalseAlarmModel chance{1000, 9, 0.05}, more{1000, 10, 0.05};
    EXPECT_GT(expectedFalsePoses(more, m), expectedFalsePoses(chance, m));
    EXPECT_GT(expectedFalsePoses(chance, m), expectedFalsePoses(chance, m + 1));
  }
  EXPECT_EQ(expectedFalsePoses(BearingFalseAlarmModel{1000, 4, 0.05}, 5), 0);
}
}  // namespace
}  // namespace mrpt_ext::test_false_alarms_bearings
