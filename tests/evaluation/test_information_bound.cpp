#include "mrpt_ext/evaluation/information_bound.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_information_bound
{
TEST(InformationBound, ThreeRangesFromFourSides)
{
  Matrix2d information = Matrix2d::Zero();
  information.diagonal() << 100, 25;
  const auto bound = informationBound(information);
  ASSERT_TRUE(bound);
  EXPECT_NEAR(bound->covariance(0, 0), 0.01, 1e-12);
  EXPECT_NEAR(bound->position_rms, std::sqrt(0.05), 1e-12);
}

TEST(InformationBound, RangesDoNotConstrainTheHeading)
{
  Matrix3d information = Matrix3d::Zero();
  for (const Vector2d& landmark : {Vector2d{5, 0}, Vector2d{0, 5}, Vector2d{-3, 1}})
    addInformation(information, rangeJacobian({0, 0, 0.3}, landmark), 0.1);
  EXPECT_EQ(informationRank(information), 2);
  EXPECT_FALSE(informationBound(information));
}

TEST(InformationBound, BearingsOnTheCircleOfTheLandmarksAreSingular)
{
  Matrix3d information = Matrix3d::Zero();
  for (const double angle : {0.3, 1.4, 2.9, 4.0})
    addInformation(information, bearingJacobian({5, 0, 0.3}, {5 * std::cos(angle), 5 * std::sin(angle)}), 0.01);
  EXPECT_EQ(informationRank(information), 2);
  EXPECT_FALSE(informationBound(information));
}

TEST(InformationBound, NoInformationOrNotFinite)
{
  EXPECT_FALSE(informationBound(Matrix3d::Zero()));
  EXPECT_FALSE(informationBound(Matrix3d::Constant(NAN)));
}
}  // namespace mrpt_ext::test_information_bound
