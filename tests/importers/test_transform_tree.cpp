#include "mrpt_ext/importers/rosbag2/transform_tree.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_transform_tree
{
namespace
{
RosPose transform(double time, const std::string& parent, const std::string& child, double x)
{
  RosPose pose{.header = {time, parent}, .child_frame = child, .pose = {}};
  pose.pose.position.x() = x;
  return pose;
}
}  // namespace

TEST(TransformTree, FindsFixedPosesInEitherDirection)
{
  TransformTree tree;
  tree.add(transform(0, "base", "mast", 1));
  tree.add(transform(0, "laser", "mast", 0.25));
  tree.finish();
  ASSERT_TRUE(tree.fixedPose("base", "laser"));
  EXPECT_DOUBLE_EQ(tree.fixedPose("base", "laser")->position.x(), 0.75);
  EXPECT_DOUBLE_EQ(tree.fixedPose("laser", "base")->position.x(), -0.75);
  EXPECT_FALSE(tree.fixedPose("base", "camera"));
}

TEST(TransformTree, WhatMovesIsNotFixed)
{
  TransformTree tree;
  for (const double time : {2.0, 1.0, 3.0}) tree.add(transform(time, "odom", "base", time));
  for (const double time : {1.0, 2.0, 3.0}) tree.add(transform(time, "base", "laser", 0.5));
  tree.finish();
  EXPECT_FALSE(tree.fixedPose("odom", "base"));
  EXPECT_TRUE(tree.fixedPose("base", "laser"));
  EXPECT_EQ(tree.movingEdges(), (std::set<TransformTree::Edge>{{"odom", "base"}}));
  const auto& transforms = tree.transforms({"odom", "base"});
  ASSERT_EQ(transforms.size(), 3U);
  EXPECT_EQ(transforms[0].time, 1);
  EXPECT_EQ(transforms[2].pose.position.x(), 3);
}

TEST(TransformTree, LoopsEnd)
{
  TransformTree tree;
  tree.add(transform(0, "a", "b", 1));
  tree.add(transform(0, "b", "c", 1));
  tree.add(transform(0, "c", "a", 1));
  tree.add(transform(0, "a", "a", 1));
  tree.finish();
  EXPECT_TRUE(tree.fixedPose("a", "c"));
  EXPECT_FALSE(tree.fixedPose("a", "d"));
}
}  // namespace mrpt_ext::test_transform_tree
