#include "mrpt_ext/diagnosis/uncertain_odometry.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_uncertain_odometry
{
namespace
{
LocalizationInput anonymousBearings()
{
  LocalizationInput input;
  input.log.available.anonymous_bearing = input.log.available.odometry = true;
  return input;
}
}  // namespace

// With a log: test_auto_calibration.
TEST(UncertainOdometry, IsForAnonymousBearingsWithOdometryAlone)
{
  EXPECT_TRUE(uncertainOdometry({}).empty());
  LocalizationInput input = anonymousBearings();
  input.log.available.odometry = false;
  EXPECT_TRUE(uncertainOdometry(input).empty());
  input = anonymousBearings();
  input.log.available.identified_bearing = true;
  EXPECT_TRUE(uncertainOdometry(input).empty());
  input = anonymousBearings();
  input.config.frames.independent = true;
  EXPECT_TRUE(uncertainOdometry(input).empty());
  input = anonymousBearings();
  input.config.filter.motion.type = MotionType::random_walk;
  EXPECT_TRUE(uncertainOdometry(input).empty());
}

TEST(UncertainOdometry, IsAsUncertainAsTheConfigurationSaysWhereItDoes)
{
  LocalizationInput input = anonymousBearings();
  input.config.biases = {{.kind = BiasKind::rotation_scale, .std = 0.02}};
  EXPECT_TRUE(uncertainOdometry(input).empty());
}
}  // namespace mrpt_ext::test_uncertain_odometry
