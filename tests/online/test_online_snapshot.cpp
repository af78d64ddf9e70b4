#include "mrpt_ext/online/online_snapshot.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::test_online_snapshot
{
TEST(OnlineSnapshot, IsReadBackWithoutLoss)
{
  OnlineSnapshot saved;
  saved.pose = GaussianPose{{1.0 / 3, -2e-7, 3.1}, Matrix3d::Identity() * 0.1};
  saved.pose->covariance(0, 2) = saved.pose->covariance(2, 0) = 0.01 / 7;
  saved.biases = {{0.12, 0.003}, {-1e-9, 0}};
  const OnlineSnapshot read = snapshotFrom(textOf(saved));
  ASSERT_TRUE(read.pose);
  EXPECT_EQ(read.pose->mean.x, saved.pose->mean.x);
  EXPECT_EQ(read.pose->mean.phi, saved.pose->mean.phi);
  EXPECT_EQ(read.pose->covariance, saved.pose->covariance);
  ASSERT_EQ(read.biases.size(), 2U);
  EXPECT_EQ(read.biases[1].mean, -1e-9);
  EXPECT_FALSE(snapshotFrom(textOf({})).pose);
}

TEST(OnlineSnapshot, OtherTextIsAnError)
{
  const std::string whole = textOf({.pose = GaussianPose{}, .biases = {{1, 2}}});
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THROW((void)snapshotFrom(whole.substr(0, length)), InputError) << length;
  EXPECT_THROW((void)snapshotFrom(whole + " 1"), InputError);
  EXPECT_THROW((void)snapshotFrom("mrpt_ext-snapshot 2 0 0"), InputError);
  EXPECT_THROW((void)snapshotFrom("mrpt_ext-snapshot 1 0 2000000000"), InputError);
}
}  // namespace mrpt_ext::test_online_snapshot
