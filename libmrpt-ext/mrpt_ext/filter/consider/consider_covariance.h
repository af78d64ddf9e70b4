#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/filter/consider/excess_noise.h"
#include "mrpt_ext/filter/consider/persistent_errors.h"
#include "mrpt_ext/filter/consider/systematic_errors.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// What errors that last add to the covariance that a filter states, which takes all errors for white: those of single
/// landmarks (PersistentErrors), and those of sensors and odometry (SystematicErrors); and how much more than stated
/// odometry errs from motion to motion (ExcessNoise). All comes from the innovations, of which white ones that are as
/// large as stated add nothing, but for the lever arms and delays that are assumed until motion tells them, and for
/// what is not known of the sensors' axes, which no motion tells.
///
/// It follows a filter of any kind from outside, as the Kalman filter that would have stated the same.
class ConsiderCovariance
{
 public:
  /// `start`: the pose before the first frame, where it is given; otherwise the first estimate is found from readings,
  /// and shares their errors.
  ConsiderCovariance(MotionModel motion, BiasModel biases, const LandmarkTable& map,
                     const std::optional<GaussianPose>& start);

  /// The filter has taken this frame and states `now`: nothing while it has more than one mode. `verified`: it
  /// passed the pose test; until then nothing is learned about the noise of odometry. Filters without a test say so.
  void follow(std::optional<KalmanState> now, const Frame& frame, bool verified);
  /// The frame that the filter is to take: its motion with what its noise exceeds the stated one by.
  [[nodiscard]] Frame withExcess(Frame frame) const;
  /// The estimate is another one, with an error of its own. What is known of the sensors stays.
  void restart();

  /// To be added to the stated covariance of the pose; positive semidefinite.
  [[nodiscard]] Matrix3d added() const { return added_; }
  /// "errors that last: standard deviation 0.024 m instead of 0.012 m", "lever_arm_std_m, delay_std_s: standard
  /// deviation ..." where that is mostly assumed, "yaw_std_deg: standard deviation 2.1 deg instead of 0.4 deg",
  /// "odometry errs 2.1 times as much as stated"; empty where each adds less than a half.
  [[nodiscard]] std::string finding(const Matrix3d& stated) const;

 private:
  void update(const LinearStep& step);
  void state();
  [[nodiscard]] LinearStep linearise(const KalmanState& before, const Frame& frame);
  void addRows(const Reading& reading, LinearStep& step);
  [[nodiscard]] std::size_t indexOf(const std::string& sensor);

  MotionModel motion_;
  BiasModel biases_;
  LandmarkTable map_;
  double default_max_range_;
  std::vector<std::string> sensors_;
  std::vector<SensorStds> sensor_stds_;  // of each
  PersistentErrors persistent_;
  SystematicErrors systematic_;
  ExcessNoise noise_;
  std::optional<KalmanState> stated_;  // after the last frame
  Matrix3d added_ = Matrix3d::Zero();
  Matrix3d assumed_ = Matrix3d::Zero();  // of that, by lever arms and delays
  double yaw_std_ = 0;                   // [rad] of that, of the axes of the sensors
};
}  // namespace mrpt_ext
