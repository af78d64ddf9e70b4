#include "mrpt_ext/filter/integrity/pose_support.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_pose_support
{
namespace
{
Matrix3d spread(double std_xy, double std_phi) { return Vector3d(std_xy, std_xy, std_phi).cwiseAbs2().asDiagonal(); }
}  // namespace

TEST(PoseSupport, ClutterAfterASpellThatOdometryBridgedLeavesThePoseUnsupported)
{
  PoseSupport support;
  support.observe(1, 1, spread(0.1, 0.02));
  EXPECT_TRUE(support.supported());
  support.observe(0.1, 1, spread(0.25, 0.02));
  EXPECT_FALSE(support.supported()) << "the position is odometry's";
  support.observe(0.1, 1, spread(0.1, 0.02));
  EXPECT_FALSE(support.supported()) << "until a landmark fits";
  support.observe(1.8, 2, spread(0.3, 0.05));
  EXPECT_TRUE(support.supported());
  support.observe(0, 2, spread(0.3, 0.15));
  EXPECT_FALSE(support.supported()) << "the heading is odometry's";
}

TEST(PoseSupport, ClutterNearTheLastLandmarkSaysNothing)
{
  PoseSupport support;
  support.observe(1, 1, spread(0.1, 0.02));
  for (int k = 0; k < 20; ++k) support.observe(0, 1, spread(0.15, 0.03));
  EXPECT_TRUE(support.supported());
}

TEST(PoseSupport, WithoutDetectionsThereIsNoSignOfAnError)
{
  PoseSupport support;
  support.observe(1, 1, spread(0.1, 0.02));
  support.observe(0, 0, spread(0.4, 0.1));
  support.observe(0, 0, spread(0.5, 0.2));
  EXPECT_TRUE(support.supported());
}

TEST(PoseSupport, AKnownStartIsAsGoodAsALandmark)
{
  PoseSupport support;
  support.observe(0, 1, spread(0.01, 0.01));
  EXPECT_TRUE(support.supported());
  support.observe(0, 1, spread(0.1, 0.01));
  EXPECT_FALSE(support.supported());
}

TEST(PoseSupport, ASpellIsAsLongAsNoLandmarkHasFitted)
{
  PoseSupport support;
  EXPECT_FALSE(support.spell(spread(1, 1))) << "nothing was seen yet";
  support.observe(1, 1, spread(0.1, 0.02));
  support.move(2);
  support.observe(0, 1, spread(0.12, 0.02));
  support.move(3);
  EXPECT_FALSE(support.spell(spread(0.15, 0.03))) << "most of that was there before";
  EXPECT_EQ(support.spell(spread(0.25, 0.03)), 5);
  support.observe(1, 1, spread(0.2, 0.04));
  EXPECT_FALSE(support.spell(spread(0.25, 0.05)));
}
}  // namespace mrpt_ext::test_pose_support
