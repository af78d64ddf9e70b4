#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/diagnosis/bias_free_filter.h"
#include "mrpt_ext/diagnosis/time_blocks.h"

namespace mrpt_ext
{
/// A systematic error that the innovations show.
struct RegressedError
{
  CalibrationUnknown unknown;
  double value = 0, std = 0;  ///< in the unit of the parameter
  double effect = 0;          ///< root mean square error of the pose that it causes, in standard deviations of the pose
};

/// Linear regression of a filter's innovations on their sensitivities to systematic errors. The standard errors come
/// from the disagreement between blocks of time (sandwich estimator, White 1980), so correlated errors count for what
/// they are.
class InnovationRegression
{
 public:
  /// The first `nuisances` unknowns are always fitted, and never reported.
  InnovationRegression(std::vector<CalibrationUnknown> unknowns, std::size_t nuisances);

  void add(const SensitiveInnovation& innovation);
  /// The frame is complete: how `filter` would err by the unknowns.
  void endFrame(const BiasFreeFilter& filter);

  /// Forward selection: the most significant unknown is added until none is left, so that of two causes that explain
  /// the same innovations the better one is named. Empty with too few blocks.
  [[nodiscard]] std::vector<RegressedError> significantErrors() const;

 private:
  /// Normal equations of a stretch of time.
  struct Block
  {
    Eigen::MatrixXd information;
    Eigen::VectorXd score;

    Block& operator+=(const Block& other)
    {
      information += other.information;
      score += other.score;
      return *this;
    }
  };
  /// Values and standard deviations of some unknowns, fitted together.
  struct Fit
  {
    Eigen::VectorXd values, stds;
  };
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(unknowns_.size()); }
  [[nodiscard]] std::optional<Fit> fit(const std::vector<Eigen::Index>& chosen) const;
  [[nodiscard]] std::optional<Eigen::Index> mostSignificant(const std::vector<Eigen::Index>& chosen) const;

  std::vector<CalibrationUnknown> unknowns_;
  std::size_t nuisances_;
  TimeBlocks<Block> blocks_;
  Eigen::VectorXd effect_;  // by unknown: sum over frames of the squared error per squared unit, in standard deviations
  double frames_ = 0;
};
}  // namespace mrpt_ext
