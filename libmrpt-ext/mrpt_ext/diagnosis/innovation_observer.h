#pragma once

#include <map>
#include <string>

#include "mrpt_ext/diagnosis/delay_hypotheses.h"
#include "mrpt_ext/diagnosis/innovation_regression.h"
#include "mrpt_ext/diagnosis/innovation_statistics.h"
#include "mrpt_ext/diagnosis/link_noise.h"
#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
/// What the innovations of one sensor look like.
struct SensorInnovations
{
  InnovationStatistics bearings, ranges;
  OutlierStatistics detections;
  double clutter_probability = 0;  ///< as declared
};

/// The systematic errors that a log could have: those that the filter estimates beside the pose first, `nuisances` of
/// them.
struct PossibleErrors
{
  std::vector<CalibrationUnknown> unknowns;
  std::size_t nuisances = 0;
};
[[nodiscard]] PossibleErrors possibleErrors(const LocalizationInput& input);

/// Follows the particle filter's best mode with a Kalman filter of its own, frame by frame, and collects the
/// innovations. Where the best mode leaves it, it starts again. Cheap: the comparisons with the map are bounded per
/// frame.
class InnovationObserver
{
 public:
  /// `input` must outlive it.
  explicit InnovationObserver(const LocalizationInput& input);

  /// `step`: what the filter made of the frame.
  void add(const Frame& frame, const FilterStep& step);

  /// Nothing without odometry.
  [[nodiscard]] std::optional<DelayFinding> delay() const;
  [[nodiscard]] std::vector<RegressedError> errors() const { return regression_.significantErrors(); }
  [[nodiscard]] const std::map<std::string, SensorInnovations>& sensors() const { return sensors_; }

 private:
  InnovationObserver(const LocalizationInput& input, PossibleErrors possible);
  [[nodiscard]] bool follows(const FilterStep& step) const;
  void add(const Reading& reading, std::size_t stride);
  /// Updates with what the detection measured of a landmark; true for an outlier.
  [[nodiscard]] bool observe(const Detection& detection, const Reading& reading, std::size_t landmark);
  [[nodiscard]] bool take(const MatchedMeasurement& matched, const std::string& sensor, bool heading_known);
  /// Sensitivities of a measurement to the unknowns; `predicted` [rad] or [m].
  [[nodiscard]] Eigen::RowVectorXd sensitivity(const std::string& sensor, bool is_range, double predicted) const;
  [[nodiscard]] OdometryMotion smoothMotion(const Frame& frame) const;

  const LocalizationInput& input_;
  std::vector<CalibrationUnknown> unknowns_;
  BiasFreeFilter filter_;
  LinkNoise noise_;
  std::optional<DelayHypotheses> delays_;
  InnovationRegression regression_;
  std::map<std::string, SensorInnovations> sensors_;
  bool running_ = false, warm_ = false;
  double started_ = 0;  // [s]
};
}  // namespace mrpt_ext
