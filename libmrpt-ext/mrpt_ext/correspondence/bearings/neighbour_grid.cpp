#include "mrpt_ext/correspondence/bearings/neighbour_grid.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/vector_clones.h"

namespace mrpt_ext
{
namespace
{
constexpr double kPerBucket = 2;

/// Writes the neighbours among `count` landmarks; each is written and stays if it is one. Returns their number.
MRPT_EXT_VECTOR_CLONES
std::size_t appendNear(const double* x, const double* y, std::size_t count, double centre_x, double centre_y,
                       double radius2, float* out_x, float* out_y)
{
  std::size_t found = 0;
  for (std::size_t l = 0; l < count; ++l)
  {
    const double dx = x[l] - centre_x, dy = y[l] - centre_y;
    const double d2 = dx * dx + dy * dy;
    out_x[found] = static_cast<float>(dx);
    out_y[found] = static_cast<float>(dy);
    found += static_cast<std::size_t>((d2 <= radius2) & (d2 > 0));
  }
  return found;
}
}  // namespace

NeighbourGrid::NeighbourGrid(const LandmarkIndex& map, int category) : low_(map.low())
{
  std::vector<Vector2d> landmarks;
  for (std::size_t l = 0; l < map.size(); ++l)
    if (map.mayShow(category, l)) landmarks.push_back(map.position(l));
  const Vector2d extent = (map.high() - map.low()).cwiseMax(1e-3 * (map.high() - map.low()).maxCoeff() + 1e-9);
  const double bucket = std::sqrt(kPerBucket * extent.prod() / std::max(1.0, static_cast<double>(landmarks.size())));
  inverse_bucket_ = 1 / bucket;
  columns_ = static_cast<int>(extent.x() / bucket) + 1;
  rows_ = static_cast<int>(extent.y() / bucket) + 1;

  const auto bucket_of = [&](const Vector2d& p)
  {
    const Vector2d at = (p - low_) * inverse_bucket_;
    const int column = std::clamp(static_cast<int>(at.x()), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>(at.y()), 0, rows_ - 1);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  };
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Vector2d& p : landmarks) ++first_[bucket_of(p) + 1];
  for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  x_.resize(landmarks.size());
  y_.resize(landmarks.size());
  for (const Vector2d& p : landmarks)
  {
    const std::uint32_t slot = next[bucket_of(p)]++;
    x_[slot] = p.x();
    y_[slot] = p.y();
  }
}

void NeighbourGrid::collect(const Vector2d& centre, double radius, Neighbours& out) const
{
  const auto bucket = [this](double offset, int count)
  { return static_cast<int>(std::clamp(offset * inverse_bucket_, 0.0, count - 1.0)); };
  const Vector2d from = centre - low_;
  const int column0 = bucket(from.x() - radius, columns_), column1 = bucket(from.x() + radius, columns_);
  const int row0 = bucket(from.y() - radius, rows_), row1 = bucket(from.y() + radius, rows_);
  out.count = 0;
  for (int row = row0; row <= row1; ++row)  // the buckets of a row are contiguous
  {
    const auto start = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    const std::size_t begin = first_[start + static_cast<std::size_t>(column0)];
    const std::size_t end = first_[start + static_cast<std::size_t>(column1) + 1];
    out.reserve(out.count + end - begin);
    out.count += appendNear(x_.data() + begin, y_.data() + begin, end - begin, centre.x(), centre.y(), radius * radius,
                            out.x.data() + out.count, out.y.data() + out.count);
  }
  out.pad();
}
}  // namespace mrpt_ext
