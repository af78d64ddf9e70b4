#include "mrpt_ext/experiment/oracle_trajectories.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_oracle_trajectories
{
namespace
{
/// A robot that drives along the x axis at 1 m/s.
const Trajectory kTruth{{0, {0, 0, 0}}, {0.5, {0.5, 0, 0}}, {1, {1, 0, 0}}, {3, {3, 0, 0}}};

PoseHypothesis at(double x, double y, double weight) { return {.pose = {{x, y, 1}, {}}, .weight = weight}; }

MethodTrajectory methodAfter(std::size_t frames) { return {.name = "tree", .frames_offered = frames}; }

Estimate estimateOf(HypothesisSet candidates) { return {.candidates = std::move(candidates)}; }
}  // namespace

TEST(OracleTrajectories, KeepsTheCandidateNearestTheTruth)
{
  OracleTrajectories oracles(kTruth);
  oracles.add(methodAfter(1), estimateOf({at(5, 5, 0.7), at(0.3, 0.1, 0.2), at(9, 9, 0.1)}), 0.25);
  const std::vector<MethodTrajectory> tracks = oracles.take();
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(tracks[0].name, "oracle_tree");
  EXPECT_TRUE(tracks[0].oracle);
  EXPECT_EQ(tracks[0].frames_answered, 1u);
  ASSERT_EQ(tracks[0].points.size(), 1u);
  EXPECT_EQ(tracks[0].points.front().time, 0.25);
  EXPECT_EQ(tracks[0].points.front().pose.mean.x, 0.3);
  EXPECT_EQ(tracks[0].points.front().modes, 3);
  EXPECT_EQ(tracks[0].points.front().best_weight, 0.2);
}

TEST(OracleTrajectories, MethodsWithSingleCandidatesHaveNoOracle)
{
  OracleTrajectories oracles(kTruth);
  oracles.add(methodAfter(1), estimateOf({at(0, 0, 1)}), 0.25);
  EXPECT_TRUE(oracles.take().empty());
  OracleTrajectories chosen_once(kTruth);
  chosen_once.add(methodAfter(1), estimateOf({at(0, 0, 1)}), 0.25);
  chosen_once.add(methodAfter(2), estimateOf({at(0, 0, 0.5), at(1, 0, 0.5)}), 0.5);
  const std::vector<MethodTrajectory> tracks = chosen_once.take();
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(tracks[0].points.size(), 2u);
}

TEST(OracleTrajectories, WithoutTruthThereIsNone)
{
  const Trajectory no_truth;
  OracleTrajectories none(no_truth);
  none.add(methodAfter(1), estimateOf({at(0, 0, 0.5), at(1, 0, 0.5)}), 0.25);
  EXPECT_TRUE(none.take().empty());
  OracleTrajectories gap(kTruth);
  gap.add(methodAfter(1), estimateOf({at(0, 0, 0.5), at(1, 0, 0.5)}), 2);  // in a gap of two seconds
  const std::vector<MethodTrajectory> tracks = gap.take();
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_TRUE(tracks[0].points.empty());
}

TEST(OracleTrajectories, FramesWithoutCandidatesCountAsOffered)
{
  OracleTrajectories oracles(kTruth);
  oracles.add(methodAfter(1), estimateOf({at(0, 0, 0.5), at(1, 0, 0.5)}), 0.25);
  oracles.add(methodAfter(2), estimateOf({}), 0.5);
  oracles.add(methodAfter(3), estimateOf({}), 0.75);
  const std::vector<MethodTrajectory> tracks = oracles.take();
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(tracks[0].frames_answered, 1u);
  EXPECT_EQ(tracks[0].frames_offered, 3u);
}

TEST(OracleTrajectories, TrajectoriesAreInOrderOfAppearance)
{
  OracleTrajectories oracles(kTruth);
  for (const char* name : {"zebra", "ant", "zebra"})
    oracles.add({.name = name, .frames_offered = 1}, estimateOf({at(0, 0, 0.5), at(1, 0, 0.5)}), 0.25);
  const std::vector<MethodTrajectory> tracks = oracles.take();
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].name, "oracle_zebra");
  EXPECT_EQ(tracks[0].points.size(), 2u);
  EXPECT_EQ(tracks[1].name, "oracle_ant");
}
}  // namespace mrpt_ext::test_oracle_trajectories
