#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mrpt_ext/vision/radial_peaks.h"

namespace mrpt_ext
{
/// The profile of an edge that is sharp in the room, summed over rows of different widths. Lengths are columns.
class EdgeShape
{
 public:
  /// Standard deviation of the profile of one row and its weight in the sum.
  struct Row
  {
    double width = 0, weight = 0;
  };
  explicit EdgeShape(const std::vector<Row>& rows);

  /// Height so far from the edge, 1 at the edge.
  [[nodiscard]] double operator()(double offset) const;
  /// Standard deviation of a Gaussian that is as much bent at its top.
  [[nodiscard]] double width() const { return width_; }

 private:
  std::vector<double> samples_;
  double width_ = 0;
};

/// Two edges of one polarity whose profiles are one peak.
struct EdgePair
{
  std::array<double, 2> column{}, height{};
  double std_column = 0;  ///< of either, by noise, by an error of the shape and by what else may be in the peak
};

/// Explains a peak by one soft edge (of a shadow, with even or normally distributed light) and by two sharp ones, with
/// least squares. Two when their residuals are smaller by more than noise and an uneven wall explain.
[[nodiscard]] std::optional<EdgePair> fitEdgePair(const RunProfile& profile, double column, const EdgeShape& shape);
}  // namespace mrpt_ext
