#pragma once

#include "mrpt_ext/calibration/self_calibration.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/diagnosis/calibration_data.h"

namespace mrpt_ext
{
/// Which noise is other than the configured one by what was `found` in the part of a recording before pose number
/// `end`.
class NoiseCandidates
{
 public:
  NoiseCandidates(const CalibrationData& data, const LocalizationConfig& config, const CalibrationResult& found,
                  std::size_t end)
      : data_(data), config_(config), found_(found), end_(end)
  {
  }

  /// True where the standard deviation of the sensor's ranges, else of its bearings, may be another. A smaller one
  /// needs errors that are independent, a trajectory that tells them, and nobody who stated a larger one: the
  /// prediction of the next reading does not see errors that last, for which a configured deviation may stand.
  [[nodiscard]] bool isOther(std::size_t sensor, bool is_range) const;

  /// True where the noise of odometry may be another: less only where that of `config` is a default.
  [[nodiscard]] bool isOther(MotionNoise noise) const;

  /// Share of outliers, where it is more than configured; else 0.
  [[nodiscard]] double moreOutliers(std::size_t sensor) const;

  /// Deviations of odometry over the configured ones, beside the noise of a sensor that is `scatter` times what is
  /// stated: predictions that are too wide by a default that nobody stated would hide that it is more.
  [[nodiscard]] PerMotionNoise<double> odometryBeside(double scatter, const CalibrationResult& found) const;

 private:
  [[nodiscard]] bool isLess(MotionNoise noise, const CalibrationResult& found) const;
  [[nodiscard]] bool areCorrelated(std::size_t sensor, bool is_range) const;
  [[nodiscard]] const SensorConfig& configured(std::size_t sensor) const;

  const CalibrationData& data_;
  const LocalizationConfig& config_;
  const CalibrationResult& found_;
  std::size_t end_;
};
}  // namespace mrpt_ext
