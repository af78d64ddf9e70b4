#pragma once

#include <deque>
#include <memory>

#include "mrpt_ext/filter/kalman_bank.h"
#include "mrpt_ext/hypotheses/propose_poses.h"
#include "mrpt_ext/localizers/localizer.h"

namespace mrpt_ext
{
/// Kalman filters behind the interface of localizers: extended_kalman_filter, iterated_kalman_filter and
/// kalman_filter_bank differ in their options only. The estimate is the hypothesis of largest weight; none while the
/// second weighs the same to within one per cent.
class KalmanLocalizer : public Localizer
{
 public:
  /// `region`: of possible poses; `seed_window` [s]: window of readings for initialization and recovery; `search`: of
  /// this map.
  KalmanLocalizer(std::string name, const KalmanBankOptions& options, const LandmarkTable& map,
                  const PoseRegion& region, double seed_window, std::shared_ptr<const GlobalPoseSearch> search)
      : name_(std::move(name)),
        map_(map),
        region_(region),
        search_(std::move(search)),
        bank_(options, map),
        motion_(options.motion),
        biases_(options.biases),
        heading_known_(options.heading_observable),
        seed_window_(seed_window)
  {
  }

  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] bool continuous() const override { return true; }
  Estimate process(const Frame& whole) override;
  [[nodiscard]] const KalmanBank& bank() const { return bank_; }
  [[nodiscard]] const KalmanStep& lastStep() const { return step_; }

 private:
  void buffer(const Frame& frame);
  [[nodiscard]] Proposal propose() const;

  std::string name_;
  LandmarkTable map_;
  PoseRegion region_;
  std::shared_ptr<const GlobalPoseSearch> search_;
  KalmanBank bank_;
  MotionModel motion_;
  BiasModel biases_;
  bool heading_known_;
  double seed_window_;
  std::deque<Frame> recent_;  // of the seed window, evaluated only when hypotheses are needed
  double first_time_ = 0;
  KalmanStep step_;
};
}  // namespace mrpt_ext
