#include "mrpt_ext/vision/tags/tag_detector.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"
#include "tag_picture.h"

namespace mrpt_ext::test_tag_detector
{
namespace
{
using testing::PaintedTag;
using testing::paintTags;
using testing::PlacedTag;
using testing::wallCamera;

/// Codes of n x n cells that differ from each other in any turn, by a fixed seed.
TagDictionary randomDictionary(int cells, int count)
{
  RandomStream random(5);
  TagDictionary dictionary{cells, {}};
  for (int id = 0; id < count; ++id) dictionary.codes.push_back(random.nextBits() >> (64 - cells * cells));
  return dictionary;
}

/// Root mean square distance of the corners, whichever comes first.
double distance(const TagCorners& found, const TagCorners& painted)
{
  double least = 1e9;
  for (std::size_t first = 0; first < 4; ++first)
    for (const std::size_t step : {1U, 3U})
    {
      double sum = 0;
      for (std::size_t i = 0; i < 4; ++i) sum += (found[(first + step * i) % 4] - painted[i]).squaredNorm();
      least = std::min(least, std::sqrt(sum / 8));
    }
  return least;
}

double diagonal(const TagCorners& corners)
{
  return 0.5 * ((corners[0] - corners[2]).norm() + (corners[1] - corners[3]).norm());
}

std::vector<PaintedTag> threeTags()
{
  return {{3, PlacedTag{.range = 1, .bearing = 0.3}.corners(wallCamera())},
          {7, PlacedTag{.range = 2, .bearing = -0.1, .turned = -0.8}.corners(wallCamera())},
          {1, PlacedTag{.range = 3, .bearing = -0.45}.corners(wallCamera())}};
}
}  // namespace

TEST(TagDetector, FindsTagsOfAnySizeOfDictionaryWithPreciseCorners)
{
  for (const int cells : {4, 5, 6, 7})
  {
    TagDetectorSettings settings;
    settings.dictionary = randomDictionary(cells, 20);
    const auto painted = threeTags();
    const auto found = TagDetector(settings).detect(paintTags({640, 480}, settings.dictionary, painted));
    ASSERT_EQ(found.size(), 3U) << cells;
    const std::array<std::size_t, 3> by_id{2, 0, 1};
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_EQ(found[i].id, painted[by_id[i]].id);
      EXPECT_LT(distance(found[i].corners, painted[by_id[i]].corners), 0.12) << cells << ", tag " << found[i].id;
    }
  }
}

TEST(TagDetector, SeesLightWhereScreensShowGreyLevels)
{
  // Taken for light, grey levels make a black square smaller, and more so in a blurred image.
  TagDetectorSettings settings;
  settings.dictionary = arucoOriginal();
  const PaintedTag tag{9, PlacedTag{.range = 1.5}.corners(wallCamera())};
  const cv::Mat image = paintTags({640, 480}, settings.dictionary, {tag});
  const auto excess = [&]
  { return diagonal(TagDetector(settings).detect(image).at(0).corners) - diagonal(tag.corners); };
  EXPECT_NEAR(excess(), 0, 0.1);
  settings.linear_camera = true;
  EXPECT_LT(excess(), -0.15);
}

TEST(TagDetector, FindsTagsInTheDark)
{
  TagDetectorSettings settings;
  settings.dictionary = arucoOriginal();
  const PaintedTag tag{9, PlacedTag{.range = 1.5}.corners(wallCamera())};
  const cv::Mat dark = paintTags({640, 480}, settings.dictionary, {tag}) * 0.2;
  EXPECT_EQ(TagDetector(settings).detect(dark).size(), 1U);
}

TEST(TagDetector, CorrectsBitsAsConfigured)
{
  TagDetectorSettings settings;
  settings.dictionary = randomDictionary(6, 10);
  TagDictionary damaged = settings.dictionary;
  damaged.codes[4] ^= 1ULL << 17;
  const PaintedTag tag{4, PlacedTag{.range = 1}.corners(wallCamera())};
  const cv::Mat image = paintTags({640, 480}, damaged, {tag});
  EXPECT_EQ(TagDetector(settings).detect(image).size(), 1U);
  settings.corrected_bits = 0;
  EXPECT_TRUE(TagDetector(settings).detect(image).empty());
}

TEST(TagDetector, CorrectsNothingWhereNoiseWouldBeATag)
{
  TagDetectorSettings settings;
  settings.dictionary = randomDictionary(4, 50);
  settings.corrected_bits = 2;
  TagDictionary damaged = settings.dictionary;
  damaged.codes[4] ^= 1ULL << 7;
  const PaintedTag tag{4, PlacedTag{.range = 1}.corners(wallCamera())};
  EXPECT_EQ(TagDetector(settings).detect(paintTags({640, 480}, settings.dictionary, {tag})).size(), 1U);
  EXPECT_TRUE(TagDetector(settings).detect(paintTags({640, 480}, damaged, {tag})).empty());
}

TEST(TagDetector, AprilTagFamiliesAreKnownByName)
{
  for (const std::string& family : tagFamilies())
  {
    TagDetectorSettings settings;
    settings.family = family;
    EXPECT_TRUE(TagDetector(settings).detect(cv::Mat(480, 640, CV_8U, cv::Scalar(90))).empty()) << family;
  }
  EXPECT_EQ(tagFamilies().front(), TagDetectorSettings{}.family);
}
}  // namespace mrpt_ext::test_tag_detector
