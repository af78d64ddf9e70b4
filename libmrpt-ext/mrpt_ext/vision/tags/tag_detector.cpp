#include "mrpt_ext/vision/tags/tag_detector.h"

#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h10.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagCircle21h7.h>
#include <apriltag/tagStandard41h12.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>

namespace mrpt_ext
{
namespace
{
constexpr double kPixelCentre = 0.5;      ///< the library counts from the corner of a pixel
constexpr double kMostRandomTags = 1e-3;  ///< share of quads with random cells that are taken for tags

struct LibraryFamily
{
  const char* name;
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
};

constexpr std::array kLibraryFamilies{
    LibraryFamily{"tag36h11", tag36h11_create, tag36h11_destroy},
    LibraryFamily{"tag25h9", tag25h9_create, tag25h9_destroy},
    LibraryFamily{"tag16h5", tag16h5_create, tag16h5_destroy},
    LibraryFamily{"tag36h10", tag36h10_create, tag36h10_destroy},
    LibraryFamily{"tagStandard41h12", tagStandard41h12_create, tagStandard41h12_destroy},
    LibraryFamily{"tagCircle21h7", tagCircle21h7_create, tagCircle21h7_destroy}};

/// A dictionary in the library's terms. It turns a code by a quarter by shifting a quarter of its bits, so the cells
/// are told quarter by quarter, each turned against the one before; a cell in the middle comes last.
struct DictionaryFamily
{
  explicit DictionaryFamily(const TagDictionary& dictionary)
  {
    const int n = dictionary.cells;
    std::vector<int> cells;  // row by row, of the first quarter
    for (int row = 0; row < n / 2; ++row)
      for (int column = 0; column < n - n / 2; ++column) cells.push_back(row * n + column);
    const std::size_t quarter = cells.size();
    for (std::size_t k = 0; k < 3 * quarter; ++k) cells.push_back(cells[k] % n * n + n - 1 - cells[k] / n);
    if (n % 2 == 1) cells.push_back(n * n / 2);
    for (const int cell : cells)
      columns.push_back(static_cast<std::uint32_t>(cell % n + 1)),
          rows.push_back(static_cast<std::uint32_t>(cell / n + 1));
    for (const std::uint64_t by_rows : dictionary.codes)
    {
      std::uint64_t code = 0;
      for (const int cell : cells) code = code << 1 | (by_rows >> (n * n - 1 - cell) & 1);
      codes.push_back(code);
    }
    family.ncodes = static_cast<std::uint32_t>(codes.size()), family.codes = codes.data();
    family.nbits = static_cast<std::uint32_t>(n * n), family.bit_x = columns.data(), family.bit_y = rows.data();
    family.width_at_border = n + 2, family.total_width = n + 4;
    family.name = name.data();
  }

  std::vector<std::uint64_t> codes;
  std::vector<std::uint32_t> columns, rows;
  std::string name = "dictionary";
  apriltag_family_t family{};
};

std::shared_ptr<apriltag_family_t> familyOf(const TagDetectorSettings& settings)
{
  if (!settings.dictionary.codes.empty())
  {
    const auto own = std::make_shared<DictionaryFamily>(settings.dictionary);
    return {own, &own->family};
  }
  for (const LibraryFamily& known : kLibraryFamilies)
    if (settings.family == known.name) return {known.create(), known.destroy};
  throw std::logic_error("no tag family " + settings.family);
}

/// Bits of a code that may be wrong, as wanted or as few as keep random codes from being tags, in any of four turns.
int correctedBits(const apriltag_family_t& family, int wanted)
{
  double taken = 4.0 * family.ncodes / std::pow(2.0, family.nbits), with_errors = 1;
  for (int bits = 1; bits <= wanted; ++bits)
  {
    with_errors *= (family.nbits - bits + 1.0) / bits;
    taken += 4.0 * family.ncodes / std::pow(2.0, family.nbits) * with_errors;
    if (taken > kMostRandomTags) return bits - 1;
  }
  return wanted;
}

/// Light that a grey level codes for a screen (IEC 61966-2-1), both from 0 to 1.
double lightOfScreen(double level) { return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4); }

/// Light from 0 to 255: the brightest pixel of the image is 255.
cv::Mat lightOf(const cv::Mat& grey, bool linear_camera)
{
  constexpr double kWhite = 255;
  const auto light = [&](double level) { return linear_camera ? level / kWhite : lightOfScreen(level / kWhite); };
  double brightest = 0;
  cv::minMaxLoc(grey, nullptr, &brightest);
  cv::Mat result, of_level(1, 256, CV_8U);
  for (int level = 0; level < 256; ++level)
    of_level.at<std::uint8_t>(level) =
        cv::saturate_cast<std::uint8_t>(kWhite * light(level) / light(std::max(brightest, 1.0)));
  cv::LUT(grey, of_level, result);
  return result;
}
}  // namespace

std::vector<std::string> tagFamilies()
{
  std::vector<std::string> names;
  for (const LibraryFamily& known : kLibraryFamilies) names.emplace_back(known.name);
  return names;
}

struct TagDetector::Library
{
  explicit Library(const TagDetectorSettings& settings) : family(familyOf(settings))
  {
    detector->quad_decimate = static_cast<float>(settings.decimation);
    apriltag_detector_add_family_bits(detector.get(), family.get(), correctedBits(*family, settings.corrected_bits));
  }

  std::shared_ptr<apriltag_family_t> family;  // outlives the detector
  std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)> detector{apriltag_detector_create(),
                                                                                apriltag_detector_destroy};
};

TagDetector::TagDetector(const TagDetectorSettings& settings)
    : settings_(settings), library_(std::make_unique<Library>(settings))
{
}

TagDetector::~TagDetector() = default;

std::vector<DetectedTag> TagDetector::detect(const cv::Mat& grey) const
{
  cv::Mat light = lightOf(grey, settings_.linear_camera);
  image_u8_t image{light.cols, light.rows, static_cast<int>(light.step), light.data};
  const std::unique_ptr<zarray_t, void (*)(zarray_t*)> found(apriltag_detector_detect(library_->detector.get(), &image),
                                                             apriltag_detections_destroy);
  std::vector<DetectedTag> tags;
  for (int i = 0; i < zarray_size(found.get()); ++i)
  {
    apriltag_detection_t* detection = nullptr;
    zarray_get(found.get(), i, &detection);
    if (detection->decision_margin < settings_.min_margin) continue;
    DetectedTag tag{detection->id, {}};
    for (std::size_t k = 0; k < tag.corners.size(); ++k)
      tag.corners[k] = {detection->p[k][0] - kPixelCentre, detection->p[k][1] - kPixelCentre};
    tags.push_back(tag);
  }
  std::stable_sort(tags.begin(), tags.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return tags;
}
}  // namespace mrpt_ext
