#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "../support/synthetic_field.h"
#include "mrpt_ext/vision/stereo/stereo_goal.h"

namespace mrpt_ext::test_goal_corners
{
namespace
{
using testing::Board;
using testing::FieldPicture;

/// A wall with a goal of 40 cm in it.
FieldPicture withGoal(double wall, double middle, const cv::Vec3d& colour = testing::kYellow)
{
  FieldPicture picture;
  picture.wall = wall;
  picture.boards.push_back({wall, middle - 0.2, middle + 0.2, 0.05, colour});
  return picture;
}

StereoGoalSettings settingsFor(const FieldPicture& picture)
{
  StereoGoalSettings settings;
  settings.camera = picture.camera;
  settings.with_lines = false;
  return settings;
}

std::vector<GoalCorner> cornersOf(const FieldPicture& picture, int seed = 1)
{
  const auto pair = testing::paint(picture, seed);
  const StereoGoalView view = viewStereoGoal(pair.left, pair.right, settingsFor(picture));
  EXPECT_EQ(view.problem, "");
  return view.corners;
}

/// The goal has both corners, at these positions.
void expectGoal(const std::vector<GoalCorner>& corners, double wall, double middle, int colour)
{
  ASSERT_EQ(corners.size(), 2u);
  for (const GoalCorner& corner : corners)
  {
    const Eigen::Vector2d position(wall, middle + 0.2 * corner.side);
    EXPECT_EQ(corner.colour, colour);
    EXPECT_LT(std::abs(corner.measured.range - position.norm()), 4 * corner.measured.std_range);
    EXPECT_LT(std::abs(corner.measured.bearing - std::atan2(position.y(), position.x())),
              4 * corner.measured.std_bearing);
    EXPECT_LT(corner.measured.std_range, 0.03);
  }
  EXPECT_NE(corners[0].side, corners[1].side);
}
/// A goal that is recessed into the wall, with sides and a back in these colours.
FieldPicture recessed(double wall, const cv::Vec3d& sides, const cv::Vec3d& back)
{
  FieldPicture picture;
  picture.wall = wall + 0.15;
  picture.boards = {{wall, 0.2, 3, 0.05, testing::kWhite},
                    {wall, -3, -0.2, 0.05, testing::kWhite},
                    {wall + 0.15, -0.2, 0.2, 0.05, back}};
  picture.sides = {{0.2, wall, wall + 0.15, 0.05, sides}, {-0.2, wall, wall + 0.15, 0.05, sides}};
  return picture;
}
}  // namespace

TEST(GoalCorners, OfTheBackAreNone)
{
  for (const double wall : {0.6, 0.8})
  {
    expectGoal(cornersOf(recessed(wall, testing::kYellow, testing::kYellow)), wall, 0, 0);
    EXPECT_TRUE(cornersOf(recessed(wall, testing::kWhite, testing::kYellow)).empty()) << wall;
    EXPECT_TRUE(cornersOf(recessed(wall, testing::kWhite, testing::kBlue)).empty()) << wall;
  }
}

TEST(GoalCorners, AreWhereAWhiteSideBeginsWhenItIsInTheShade)
{
  for (const double wall : {0.6, 0.8})
    for (const double shade : {0.8, 0.9})
      expectGoal(cornersOf(recessed(wall, shade * testing::kWhite, testing::kYellow)), wall, 0, 0);
  EXPECT_EQ(cornersOf(recessed(0.7, 0.8 * testing::kWhite, testing::kBlue)).size(), 2u);
}

TEST(GoalCorners, HaveTheirFootWhereAWhiteSideBegins)
{
  for (const double wall : {0.6, 0.8})
  {
    const FieldPicture picture = recessed(wall, 0.8 * testing::kWhite, testing::kYellow);
    const auto corners = cornersOf(picture);
    ASSERT_EQ(corners.size(), 2u) << wall;
    for (const GoalCorner& corner : corners)
      EXPECT_NEAR(corner.white_bottom, picture.camera.pixelOf({wall, 0})->y, 1) << wall;
  }
}

TEST(GoalCorners, AreWhereTheGoalIsThoughOneImageAloneShowsItsSide)
{
  double squares = 0;
  int n = 0;
  for (const cv::Vec3d& colour : {testing::kYellow, cv::Vec3d(115, 180, 190), testing::kBlue})
    for (const double left : {-0.02, -0.01, -0.005, 0.0})  // [m] of the left camera, and 3 cm of the right one
    {
      FieldPicture picture = recessed(0.8, 0.7 * colour, colour);
      picture.boards[0].right = picture.sides[0].left = picture.boards[2].left = left;
      picture.boards[1].left = picture.sides[1].left = picture.boards[2].right = left - 0.4;
      const auto corners = cornersOf(picture);
      ASSERT_EQ(corners.size(), 2u) << left;
      for (const GoalCorner& corner : corners)
      {
        const double error = corner.measured.range - std::hypot(0.8, corner.side > 0 ? left : left - 0.4);
        squares += square(error / corner.measured.std_range), ++n;
        EXPECT_LT(std::abs(error), 0.03) << left;
      }
    }
  EXPECT_LT(squares / n, 2);
}

TEST(GoalCorners, AreNotMeasuredAtTheBackOfASideTooNarrowToBeSeen)
{
  for (const double pixels : {2.0, 3.0})
    for (const cv::Vec3d& colour : {testing::kYellow, testing::kBlue})
    {
      FieldPicture picture = recessed(0.8, 0.8 * testing::kWhite, colour);
      const double left = pixels / (300 * (1 / 0.8 - 1 / 0.95));  // its side covers so many pixels
      picture.boards[0].right = picture.sides[0].left = left;
      picture.boards[2].left = left;
      for (const GoalCorner& corner : cornersOf(picture))
      {
        EXPECT_LT(std::abs(corner.measured.position.x() - 0.8), 4 * corner.measured.std_range) << pixels;
      }
    }
}

TEST(GoalCorners, AreLeftOutWhereTheOtherSideTellsThatTheirOwnIsTooNarrowToBeSeen)
{
  int found = 0;
  for (const double right : {0.01, 0.02, 0.03})  // [m] of the line of sight to the goal's right side
  {
    FieldPicture picture = recessed(1.1, 0.85 * testing::kWhite, testing::kYellow);
    picture.boards[0].right = picture.sides[0].left = picture.boards[2].left = 0.4 - right;
    picture.boards[1].left = picture.sides[1].left = picture.boards[2].right = -right;
    for (const GoalCorner& corner : cornersOf(picture))
    {
      EXPECT_LT(std::abs(corner.measured.position.x() - 1.1), 3 * corner.measured.std_range) << right;
      found += corner.side > 0;
    }
  }
  EXPECT_EQ(found, 3);
}

TEST(GoalCorners, AreThoseOfPalePaintToo)
{
  expectGoal(cornersOf(withGoal(0.8, 0, {150, 105, 95})), 0.8, 0, 1);
  expectGoal(cornersOf(withGoal(0.8, 0, {115, 180, 190})), 0.8, 0, 0);
  EXPECT_TRUE(cornersOf(withGoal(0.8, 0, {190, 175, 170})).empty());  // a wall in blue light
  EXPECT_TRUE(cornersOf(withGoal(0.8, 0, {60, 170, 70})).empty());
}

TEST(GoalCorners, AreNotThoseOfTheMirroredGoal)
{
  for (const double wall : {0.6, 0.9})
  {
    FieldPicture picture = withGoal(wall, 0);
    picture.mirrors = true;
    expectGoal(cornersOf(picture), wall, 0, 0);
    const auto corners = cornersOf(picture);
    ASSERT_EQ(corners.size(), 2u) << wall;
    for (const GoalCorner& corner : corners)
      EXPECT_NEAR(corner.white_bottom, picture.camera.pixelOf({wall, 0})->y, 1.5);
    picture = {};
    picture.mirrors = true;
    picture.boards = {Board{wall - 0.2, -0.03, 0.045, 0.075, testing::kYellow}};
    EXPECT_TRUE(cornersOf(picture).empty()) << wall;
  }
}

TEST(GoalCorners, AreWhereTheGoalIs)
{
  for (const double wall : {0.5, 0.8, 1.2}) expectGoal(cornersOf(withGoal(wall, 0.02)), wall, 0.02, 0);
  expectGoal(cornersOf(withGoal(0.9, -0.05, testing::kBlue)), 0.9, -0.05, 1);
}

TEST(GoalCorners, AreFoundBesideTheBorderOfTheImage)
{
  constexpr double kWall = 0.8;
  for (const double column : {3.0, 4.5})  // [px] of the left corner in the right image
  {
    FieldPicture picture = withGoal(kWall, 0);
    const StereoCamera& camera = picture.camera;
    const double depth = kWall * std::cos(camera.pitch) + camera.height * std::sin(camera.pitch);
    const double left_end = (camera.cx - column - camera.disparityAt(depth)) * depth / camera.fx;
    picture = withGoal(kWall, left_end - 0.2);
    expectGoal(cornersOf(picture), kWall, left_end - 0.2, 0);
  }
}

TEST(GoalCorners, HaveStandardDeviations)
{
  double ranges = 0, bearings = 0;
  int n = 0;
  FieldPicture picture = withGoal(0.9, 0);
  picture.noise = 8;
  auto settings = settingsFor(picture);
  settings.corners.std_column = 0, settings.corners.std_disparity = 0;  // there is nothing but noise
  for (int seed = 1; seed <= 12; ++seed)
  {
    const auto pair = testing::paint(picture, seed);
    for (const GoalCorner& corner : viewStereoGoal(pair.left, pair.right, settings).corners)
    {
      const StereoMeasurement& m = corner.measured;
      ranges += square((m.range - std::hypot(0.9, 0.2)) / m.std_range);
      bearings += square((m.bearing - std::atan2(0.2 * corner.side, 0.9)) / m.std_bearing);
      ++n;
    }
  }
  ASSERT_EQ(n, 24);
  EXPECT_GT(ranges / n, 0.3);
  EXPECT_LT(ranges / n, 3.0);
  EXPECT_GT(bearings / n, 0.3);
  EXPECT_LT(bearings / n, 4.0);
}

TEST(GoalCorners, StateTheErrorOfColourThatIsCoarserThanThePixels)
{
  double squares = 0, largest = 0;
  int n = 0;
  for (int i = 0; i < 16; ++i)
    for (const cv::Vec3d& colour : {testing::kYellow, testing::kBlue})
    {
      const double wall = 0.8 + 0.023 * i;
      const FieldPicture picture = withGoal(wall, 0.003 * i, colour);
      auto pair = testing::paint(picture, i + 1);
      for (cv::Mat* image : {&pair.left, &pair.right})
      {
        std::vector<unsigned char> file;
        cv::imencode(".jpg", *image, file, {cv::IMWRITE_JPEG_QUALITY, 60});  // a colour for every second pixel
        *image = cv::imdecode(file, cv::IMREAD_COLOR);
      }
      for (const GoalCorner& corner : viewStereoGoal(pair.left, pair.right, settingsFor(picture)).corners)
      {
        const double error = corner.measured.range - std::hypot(wall, 0.003 * i + 0.2 * corner.side);
        squares += square(error / corner.measured.std_range), ++n;
        largest = std::max(largest, std::abs(error / corner.measured.std_range));
      }
    }
  ASSERT_GE(n, 56);
  EXPECT_LT(squares / n, 1.3);
  EXPECT_LT(largest, 3.3);
}

TEST(GoalCorners, AreFoundInOtherLightAndMoreNoise)
{
  const FieldPicture picture = withGoal(0.9, 0, testing::kBlue);
  auto pair = testing::paint(picture);
  for (cv::Mat* image : {&pair.left, &pair.right})
  {
    cv::Mat noise(image->size(), CV_32FC3);
    image->convertTo(*image, CV_32FC3, 0.7);
    cv::multiply(*image, cv::Scalar(0.8, 1.0, 1.15), *image);
    cv::RNG(image == &pair.left ? 5 : 6).fill(noise, cv::RNG::NORMAL, 0, 6);
    *image += noise;
    image->convertTo(*image, CV_8UC3);
  }
  expectGoal(viewStereoGoal(pair.left, pair.right, settingsFor(picture)).corners, 0.9, 0, 1);
}

TEST(GoalCorners, AreNotSeenInRobotsBeforeAWhiteWall)
{
  for (const cv::Vec3d& colour : {testing::kYellow, testing::kBlue})
    for (const double forward : {0.4, 0.6, 0.79})
    {
      FieldPicture picture;
      picture.boards = {Board{forward, -0.03, 0.045, 0.075, colour}};
      EXPECT_TRUE(cornersOf(picture).empty()) << forward;
    }
}

TEST(GoalCorners, OfAGoalStayWhenARobotOfItsColourHidesOne)
{
  FieldPicture picture = withGoal(0.9, 0);
  picture.boards.insert(picture.boards.begin(), Board{0.5, 0.08, 0.155, 0.075, testing::kYellow});
  const auto corners = cornersOf(picture);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_EQ(corners.front().side, -1);
  EXPECT_NEAR(corners.front().measured.range, std::hypot(0.9, 0.2), 0.03);
}

TEST(GoalCorners, AreFoundByTheCoarseScanAsByTheFullOne)
{
  const auto pair = testing::paint(withGoal(1.0, 0.05));
  GoalCornerSettings coarse, full;
  full.scan_step = 1;
  ASSERT_EQ(scanForGoals(pair.left, coarse).size(), scanForGoals(pair.left, full).size());
}

TEST(StereoGoal, StatesWhyThereIsNoMeasurement)
{
  StereoGoalSettings settings;
  settings.camera = testing::smallCamera();
  const auto good = testing::paint(withGoal(0.8, 0));
  const auto problem = [&](const cv::Mat& left, const cv::Mat& right)
  {
    const StereoGoalView view = viewStereoGoal(left, right, settings);
    EXPECT_TRUE(view.corners.empty() && view.landmarks.empty());
    static_cast<void>(drawStereoGoal(left, view, settings));
    return view.problem;
  };
  EXPECT_EQ(problem({}, good.right), "left image is missing, empty or damaged");
  EXPECT_EQ(problem(good.left, {}), "right image is missing, empty or damaged");
  EXPECT_EQ(problem(good.left, cv::Mat::zeros(480, 640, CV_8UC3)), "right image is 640x480 pixels, expected 320x240");
  EXPECT_EQ(problem(cv::Mat::zeros(240, 320, CV_8UC3), good.right), "left image is black or of one colour");
  cv::Mat grey;
  cv::cvtColor(good.left, grey, cv::COLOR_BGR2GRAY);
  EXPECT_EQ(problem(grey, good.right), "left and right image differ in channels");
  EXPECT_EQ(problem(grey, grey), "image is grey, goals are known by their colour");
}

TEST(StereoGoal, MeasuresNothingInNoise)
{
  StereoGoalSettings settings;
  settings.camera = testing::smallCamera();
  cv::Mat left(240, 320, CV_8UC3), right(240, 320, CV_8UC3);
  cv::RNG random(7);
  random.fill(left, cv::RNG::UNIFORM, 0, 256), random.fill(right, cv::RNG::UNIFORM, 0, 256);
  const StereoGoalView view = viewStereoGoal(left, right, settings);
  EXPECT_TRUE(view.corners.empty());
  EXPECT_TRUE(view.landmarks.empty());
}

TEST(StereoGoal, DrawsFeatures)
{
  const FieldPicture picture = withGoal(0.8, 0);
  const auto pair = testing::paint(picture);
  const auto settings = settingsFor(picture);
  const cv::Mat drawing = drawStereoGoal(pair.left, viewStereoGoal(pair.left, pair.right, settings), settings);
  ASSERT_EQ(drawing.size(), pair.left.size());
  cv::Mat changed;
  cv::cvtColor(drawing != pair.left, changed, cv::COLOR_BGR2GRAY);
  EXPECT_GT(cv::countNonZero(changed), 20);
}
}  // namespace mrpt_ext::test_goal_corners
