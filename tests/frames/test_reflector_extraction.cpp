#include "mrpt_ext/frames/reflector_extraction.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_reflector_extraction
{
namespace
{
constexpr double kBright = 1000, kDark = 10;
const ReflectorOptions kPost{.intensity_above = 500, .diameter = 0.1, .shape = ReflectorShape::round};

/// Beams from one bearing [deg] on, without an echo.
RangeScan emptyScan(double first, double step, std::size_t beams)
{
  RangeScan scan;
  scan.sensor = "laser";
  scan.first_bearing = degToRad(first);
  scan.bearing_step = degToRad(step);
  scan.std_range = 0.01;
  scan.ranges.assign(beams, 0);
  scan.intensities.assign(beams, kDark);
  return scan;
}

/// Puts a bright post into the scan, seen from its origin.
void addPost(RangeScan& scan, const Vector2d& centre, double diameter, RandomStream* noise = nullptr)
{
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam)
  {
    const Vector2d way(std::cos(bearingOf(scan, beam)), std::sin(bearingOf(scan, beam)));
    const double along = way.dot(centre), across = way.x() * centre.y() - way.y() * centre.x();
    if (along < 0 || std::abs(across) > diameter / 2) continue;
    const double error = noise ? scan.std_range * noise->gaussian() : 0;
    scan.ranges[beam] = static_cast<float>(along - std::sqrt(square(diameter / 2) - square(across)) + error);
    scan.intensities[beam] = kBright;
  }
}
}  // namespace

TEST(ReflectorExtraction, FindsTheCentreOfAPost)
{
  RangeScan scan = emptyScan(-90, 0.25, 721);
  addPost(scan, {3, 1}, 0.1);
  const Reflectors found = extractReflectors(scan, kPost);
  ASSERT_EQ(found.detections.size(), 1U);
  EXPECT_NEAR(*found.detections[0].range, std::hypot(3, 1), 0.002);
  EXPECT_NEAR(*found.detections[0].bearing, std::atan2(1, 3), degToRad(0.125));
  EXPECT_EQ(found.detections[0].id, kNoId);
}

TEST(ReflectorExtraction, ErrorsAreAsLargeAsStated)
{
  RandomStream random(3, 0);
  double bearing_nees = 0, range_nees = 0;
  constexpr int kTrials = 2000;
  for (int trial = 0; trial < kTrials; ++trial)
  {
    RangeScan scan = emptyScan(-90, 0.5, 361);
    const double range = 2 + 3 * random.uniform(), bearing = degToRad(160 * random.uniform() - 80);
    addPost(scan, range * Vector2d(std::cos(bearing), std::sin(bearing)), 0.1, &random);
    const Reflectors found = extractReflectors(scan, kPost);
    ASSERT_EQ(found.detections.size(), 1U);
    const Detection& detection = found.detections[0];
    bearing_nees += square((*detection.bearing - bearing) / detection.std_bearing) / kTrials;
    range_nees += square((*detection.range - range) / detection.std_range) / kTrials;
  }
  EXPECT_GT(bearing_nees, 0.7);
  EXPECT_LT(bearing_nees, 1.3);
  EXPECT_LT(range_nees, 1.2);
}

TEST(ReflectorExtraction, SeparatesByDistanceAndByDarkBeams)
{
  RangeScan scan = emptyScan(-90, 1, 181);
  for (const std::size_t beam : {10U, 11U, 13U, 20U, 21U, 30U, 31U, 40U}) scan.intensities[beam] = kBright;
  for (const std::size_t beam : {10U, 11U, 13U}) scan.ranges[beam] = 1;  // one dark beam between them
  scan.ranges[20] = 2;
  scan.ranges[21] = 3;                    // two surfaces
  scan.ranges[30] = scan.ranges[31] = 2;  // one
  scan.ranges[40] = 0;                    // no echo
  EXPECT_EQ(extractReflectors(scan, kPost).detections.size(), 4U);
}

TEST(ReflectorExtraction, LeavesOutWhatIsTooWide)
{
  RangeScan scan = emptyScan(-90, 1, 181);
  for (std::size_t beam = 50; beam < 70; ++beam)
  {
    scan.ranges[beam] = 2;
    scan.intensities[beam] = kBright;
  }
  const Reflectors found = extractReflectors(scan, kPost);
  EXPECT_TRUE(found.detections.empty());
  EXPECT_EQ(found.too_wide, 1U);
  ReflectorOptions unknown = kPost;
  unknown.diameter = 0;
  EXPECT_EQ(extractReflectors(scan, unknown).detections.size(), 1U);
}

TEST(ReflectorExtraction, APlateLiesOnItsSurface)
{
  RangeScan scan = emptyScan(-5, 0.5, 21);
  for (const std::size_t beam : {9U, 10U, 11U})
  {
    scan.ranges[beam] = static_cast<float>(4 / std::cos(bearingOf(scan, beam)));
    scan.intensities[beam] = kBright;
  }
  ReflectorOptions plate = kPost;
  plate.shape = ReflectorShape::flat;
  const Reflectors found = extractReflectors(scan, plate);
  ASSERT_EQ(found.detections.size(), 1U);
  EXPECT_NEAR(*found.detections[0].range, 4, 1e-6);
  EXPECT_NEAR(*found.detections[0].bearing, 0, 1e-12);
}

TEST(ReflectorExtraction, AFullTurnHasNoSeam)
{
  RangeScan scan = emptyScan(-180, 0.5, 720);
  addPost(scan, {-3, 0}, 0.1);
  const Reflectors found = extractReflectors(scan, kPost);
  ASSERT_EQ(found.detections.size(), 1U);
  EXPECT_NEAR(std::abs(*found.detections[0].bearing), kPi, degToRad(0.3));
  EXPECT_DOUBLE_EQ(reflectorReading(scan, found).model.field_of_view, kTwoPi);
}

TEST(ReflectorExtraction, ScansThatTurnClockwiseGiveTheSame)
{
  RangeScan left = emptyScan(-90, 0.5, 361), right = emptyScan(90, -0.5, 361);
  for (RangeScan* scan : {&left, &right}) addPost(*scan, {2, -1}, 0.1);
  const Detection a = extractReflectors(left, kPost).detections.at(0),
                  b = extractReflectors(right, kPost).detections.at(0);
  EXPECT_NEAR(*a.bearing, *b.bearing, 1e-12);
  EXPECT_NEAR(*a.range, *b.range, 1e-6);
}

TEST(ReflectorExtraction, NothingComesOfNothing)
{
  EXPECT_TRUE(extractReflectors(RangeScan(), kPost).detections.empty());
  RangeScan dark = emptyScan(-90, 0.5, 361);
  dark.intensities.clear();
  EXPECT_TRUE(extractReflectors(dark, kPost).detections.empty());
  EXPECT_TRUE(reflectorReading(RangeScan(), {}).detections.empty());
}
}  // namespace mrpt_ext::test_reflector_extraction
