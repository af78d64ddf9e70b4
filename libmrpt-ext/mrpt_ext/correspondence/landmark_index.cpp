#include "mrpt_ext/correspondence/landmark_index.h"

#include <algorithm>

#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
namespace
{
constexpr double kLandmarksPerBucket = 2;
constexpr int kMaxBucketsPerSide = 4096;
}  // namespace

LandmarkIndex::LandmarkIndex(const LandmarkTable& map, double bucket) : categories_{""}
{
  for (const Landmark& landmark : map.all())
  {
    positions_.emplace_back(landmark.position.head<2>());
    auto known = std::find(categories_.begin(), categories_.end(), landmark.category);
    if (known == categories_.end()) known = categories_.insert(known, landmark.category);
    kinds_.push_back(static_cast<int>(known - categories_.begin()));
  }
  build(bucket);
}

LandmarkIndex::LandmarkIndex(std::vector<Vector2d> landmarks, double bucket)
    : positions_(std::move(landmarks)), kinds_(positions_.size(), 0), categories_{""}
{
  build(bucket);
}

int LandmarkIndex::categoryOf(const std::string& category) const
{
  if (category.empty()) return kAnyCategory;
  const auto known = std::find(categories_.begin(), categories_.end(), category);
  return known == categories_.end() ? kUnknownCategory : static_cast<int>(known - categories_.begin());
}

double LandmarkIndex::measurementVolume(const AnonymousDetection& detection, const SensorModel& model) const
{
  const int categories = detection.category == kAnyCategory ? 1 : std::max(1, categoriesPresent());
  return mrpt_ext::measurementVolume(detection, model, defaultMaxRange(low_, high_), categories);
}

void LandmarkIndex::build(double bucket)
{
  has_uncategorized_ = std::find(kinds_.begin(), kinds_.end(), 0) != kinds_.end();
  if (!positions_.empty()) low_ = high_ = positions_.front();
  for (const Vector2d& p : positions_)
  {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  }
  const Vector2d extent = (high_ - low_).cwiseMax(1e-6);
  if (!(bucket > 0))
    bucket = std::sqrt(extent.prod() * kLandmarksPerBucket / static_cast<double>(std::max<std::size_t>(size(), 1)));
  bucket_ = std::max(bucket, extent.maxCoeff() / kMaxBucketsPerSide);
  columns_ = static_cast<int>(extent.x() / bucket_) + 1;
  rows_ = static_cast<int>(extent.y() / bucket_) + 1;

  const auto bucket_of = [&](const Vector2d& p)
  {
    const int i = std::min(static_cast<int>((p.x() - low_.x()) / bucket_), columns_ - 1);
    const int j = std::min(static_cast<int>((p.y() - low_.y()) / bucket_), rows_ - 1);
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  };
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Vector2d& p : positions_) ++first_[bucket_of(p) + 1];
  for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
  members_.resize(size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t l = 0; l < size(); ++l) members_[next[bucket_of(positions_[l])]++] = static_cast<std::uint32_t>(l);
  in_buckets_.reserve(size());
  for (const std::uint32_t member : members_) in_buckets_.push_back(positions_[member]);
}
}  // namespace mrpt_ext
