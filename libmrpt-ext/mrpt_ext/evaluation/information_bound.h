#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext
{
/// Lower bound of the covariance of an unbiased estimator (Cramer-Rao).
struct InformationBound
{
  Eigen::MatrixXd covariance;
  double position_rms = 0;  ///< sqrt(C_xx + C_yy), the limit of the position RMSE
};

/// Rank of an information matrix, determined after scaling its diagonal to one, so that units do not matter.
[[nodiscard]] int informationRank(const Eigen::MatrixXd& information);

/// Inverse of the information over (x, y) or (x, y, phi); nothing when it is singular.
[[nodiscard]] std::optional<InformationBound> informationBound(const Eigen::MatrixXd& information);
}  // namespace mrpt_ext
