#include "mrpt_ext/vision/stereo/corner_agreement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../support/synthetic_field.h"

// What goal corners of many frames must have in common, and what is told of a frame that does not.
namespace mrpt_ext::test_corner_agreement
{
namespace
{
constexpr double kGoalWidth = 0.4;

/// A goal across the view as a camera sees it that is not quite as stated: corner's foot by `is`, its place by
/// `stated`.
std::vector<CornerEvidence> goalAt(const StereoCamera& is, const StereoCamera& stated, double forward, double left,
                                   std::mt19937& random, double off_rows = 0)
{
  std::normal_distribution<double> rows(0, 0.3), disparities(0, 0.1);
  std::vector<CornerEvidence> frame;
  for (const double side : {-0.5, 0.5})
  {
    const Eigen::Vector2d place(forward, left + side * kGoalWidth);
    const double depth = forward * std::cos(is.pitch) + is.height * std::sin(is.pitch);
    const cv::Point2d foot = *is.pixelOf(place);
    GoalCorner corner;
    corner.side = side > 0 ? 1 : -1;
    corner.white_bottom = foot.y + rows(random) + off_rows;
    corner.u_left = foot.x;
    corner.measured = *measureStereo(stated, foot, is.disparityAt(depth) + disparities(random), 0.15, 0.12);
    frame.push_back(evidenceOf(corner, cv::Mat(is.size, CV_8UC3, cv::Scalar::all(0)),
                               cv::Mat(is.size, CV_8UC3, cv::Scalar::all(0)), stated));
  }
  return frame;
}

std::vector<std::vector<CornerEvidence>> drive(const StereoCamera& is, const StereoCamera& stated)
{
  std::mt19937 random(1);
  std::vector<std::vector<CornerEvidence>> frames;
  for (int i = 0; i < 12; ++i) frames.push_back(goalAt(is, stated, 0.4 + 0.06 * i, 0.03 * (i % 3), random));
  return frames;
}
}  // namespace

TEST(CornerAgreement, NothingDiffersWhereTheCameraIsAsStated)
{
  const StereoCamera camera = testing::smallCamera();
  const auto frames = drive(camera, camera);
  const CornerConstants constants = constantsOf(frames);
  ASSERT_TRUE(constants.foot && constants.goal_width);
  EXPECT_TRUE(constants.pitch.has_value() != constants.height.has_value());
  if (constants.pitch)
  {
    EXPECT_NEAR(constants.pitch->value, 0, 4 * constants.pitch->std() + 1e-4);
  }
  if (constants.height)
  {
    EXPECT_NEAR(constants.height->value, 0, 4 * constants.height->std() + 1e-5);
  }
  EXPECT_NEAR(constants.goal_width->value, kGoalWidth, 0.01);
  for (const auto& frame : frames) EXPECT_EQ(agreeingCorners(frame, constants), std::vector<bool>(2, true));
}

TEST(CornerAgreement, FindsPitchAndHeight)
{
  const StereoCamera is = testing::smallCamera();
  StereoCamera stated = is;
  stated.pitch += degToRad(1.5);
  const CornerConstants tilted = constantsOf(drive(is, stated));
  ASSERT_TRUE(tilted.pitch);
  EXPECT_NEAR(tilted.pitch->value, degToRad(-1.5), degToRad(0.1));
  stated = is;
  stated.height += 0.01;
  const CornerConstants higher = constantsOf(drive(is, stated));
  ASSERT_TRUE(higher.height);
  EXPECT_NEAR(higher.height->value, -0.01, 0.001);
}

TEST(CornerAgreement, AGoalOfAnotherWidthIsSeenAsAnotherBaseline)
{
  const StereoCamera is = testing::smallCamera();
  StereoCamera stated = is;
  stated.baseline *= 1.1;
  const CornerConstants constants = constantsOf(drive(is, stated));
  ASSERT_TRUE(constants.goal_width);
  EXPECT_NEAR(constants.goal_width->value, 1.1 * kGoalWidth, 0.01);
}

TEST(CornerAgreement, LeavesOutWhatDoesNotAgree)
{
  const StereoCamera camera = testing::smallCamera();
  const CornerConstants constants = constantsOf(drive(camera, camera));
  std::mt19937 random(2);
  EXPECT_EQ(agreeingCorners(goalAt(camera, camera, 0.7, 0, random, 6), constants), std::vector<bool>(2, false));
  auto narrow = goalAt(camera, camera, 0.5, 0, random);
  narrow[1].measured.position.y() -= 0.15;
  EXPECT_EQ(agreeingCorners(narrow, constants), std::vector<bool>(2, false));
  narrow[1].colour = 1;
  EXPECT_EQ(agreeingCorners(narrow, constants), std::vector<bool>(2, true)) << "two goals have no width in common";
}

TEST(CornerAgreement, FewCornersTellNothing)
{
  const StereoCamera camera = testing::smallCamera();
  std::mt19937 random(3);
  const auto frame = goalAt(camera, camera, 0.7, 0, random);
  const CornerConstants constants = constantsOf({frame});
  EXPECT_FALSE(constants.pitch || constants.height || constants.foot || constants.right || constants.goal_width);
  EXPECT_EQ(agreeingCorners(goalAt(camera, camera, 0.7, 0, random, 9), constants), std::vector<bool>(2, true));
}

TEST(CornerAgreement, ImagesTellByHowManyRowsTheRightOneIsLower)
{
  testing::FieldPicture picture;
  picture.boards.push_back({picture.wall, -0.15, 0.25, 0.05, testing::kYellow});
  const auto pair = testing::paint(picture);
  GoalCornerSettings settings;
  const auto corners = findGoalCorners(pair.left, pair.right, picture.camera, settings);
  ASSERT_EQ(corners.size(), 2u);
  for (const int lower : {-2, 0, 3})
  {
    const cv::Mat move = (cv::Mat_<double>(2, 3) << 1, 0, 0, 0, 1, lower);
    cv::Mat right;
    cv::warpAffine(pair.right, right, move, pair.right.size(), cv::INTER_NEAREST, cv::BORDER_REPLICATE);
    for (const GoalCorner& corner : corners)
    {
      const CornerEvidence evidence = evidenceOf(corner, pair.left, right, picture.camera);
      ASSERT_TRUE(evidence.right) << lower;
      EXPECT_NEAR(*evidence.right, lower, 0.2);
      ASSERT_TRUE(evidence.foot);
      EXPECT_NEAR(*evidence.foot, 0, 1);
    }
  }
}
}  // namespace mrpt_ext::test_corner_agreement
