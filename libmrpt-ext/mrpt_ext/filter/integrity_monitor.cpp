#include "mrpt_ext/filter/integrity_monitor.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mrpt_ext/geometry/bounded_frame.h"
#include "mrpt_ext/geometry/identified.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMajority = 0.5;        // of the weight
constexpr double kChiSquareGate = 16.3;  // of a pose, 99.9 %

bool isPrecise(const KalmanState& state, const VerdictOptions& options)
{
  return isUnimodal({{{state.gaussianPose(), 1}}, {}}, options);
}
}  // namespace

IntegrityMonitor::IntegrityMonitor(const RecoveryOptions& recovery, const VerdictOptions& verdict,
                                   const MotionModel& motion, const BiasModel& biases, const LandmarkTable& map)
    : options_(verdict),
      motion_(motion),
      biases_(biases),
      map_(map),
      fast_ratio_(InlierRatioMonitor::fast(recovery)),
      slow_ratio_(InlierRatioMonitor::slow(recovery)),
      immediate_ratio_(InlierRatioMonitor::immediate(recovery)),
      sensor_ratios_(recovery),
      pose_test_(motion, map)
{
}

void IntegrityMonitor::start(const Frame& measurements, const ParticleSet& samples, const PoseRegion& region)
{
  pose_test_.start(scoredReadings(measurements), map_, samples);
  start_region_ = region;
  at_start_ = rivals_due_ = true;
}

void IntegrityMonitor::startVerified(const Frame& frame, const std::optional<GaussianPose>& start)
{
  if (start) start_ = startingState(*start, biases_);
  at_start_ = rivals_due_ = true;
  pose_test_.skip(frame);
  pose_test_.accept();
  for (InlierRatioMonitor* ratio : {&fast_ratio_, &slow_ratio_, &immediate_ratio_}) ratio->trust();
}

bool IntegrityMonitor::endsGap(const Frame& frame) const
{
  if (!tested_mode_ || pose_test_.logOdds() < 0 || !hasIdentified(frame)) return false;
  const KalmanState predicted = predict(*tested_mode_, biases_, motion_, frame.motion);
  VerdictOptions heading_only = options_;
  heading_only.max_std_xy = std::numeric_limits<double>::infinity();
  return (pose_test_.isGap(frame.motion) || !isPrecise(predicted, options_)) && isPrecise(predicted, heading_only);
}

void IntegrityMonitor::test(const Frame& frame, const ParticleSet& predicted, bool counts)
{
  gap_ends_ = counts && endsGap(frame);
  if (gap_ends_) pose_test_.endGap(frame.motion);
  support_.move(frame.motion.duration);
  // Identified landmarks cannot be taken for one another.
  const std::optional<KalmanState>& mode = tested_mode_ ? tested_mode_ : verified_mode_;
  if (mode && hasAnonymous(frame) && !hasIdentified(frame))
    if (const auto spell = support_.spell(predict(*mode, biases_, motion_, frame.motion).gaussianPose().covariance))
      pose_test_.suspectSlip(*spell);
  if (counts)
    pose_test_.update(frame, map_, predicted);
  else
    pose_test_.skip(frame);
}

void IntegrityMonitor::doubt() { pose_test_.doubt(); }

bool IntegrityMonitor::hasLeft(const Mode& best, bool identified) const
{
  if (!gap_ends_ && !isPrecise(*tested_mode_, options_)) return true;
  const Vector2d away = best.pose.mean.position() - tested_mode_->mean.head<2>();
  const Vector3d off(away.x(), away.y(), wrap(best.pose.mean.phi - tested_mode_->mean.z()));
  const bool far = away.norm() > options_.max_std_xy || std::abs(off.z()) > options_.max_std_phi;
  const double nees = off.dot(tested_mode_->gaussianPose().covariance.ldlt().solve(off));
  return far && !(identified && nees <= kChiSquareGate) && best.weight > kMajority;
}

void IntegrityMonitor::followKnown(const ModeSet& modes, const Frame& frame)
{
  predictModes(frame.motion);
  if (!isUnimodal(modes, options_)) return;
  const GaussianPose& pose = modes.modes.front().pose;
  if (start_) changeRivals(pose, frame);
  rememberVerified(startingState(pose, biases_));
}

void IntegrityMonitor::predictModes(const OdometryMotion& motion)
{
  if (std::exchange(at_start_, false)) return;
  for (std::optional<KalmanState>* mode : {&tested_mode_, &verified_mode_, &start_})
    if (*mode) *mode = predict(**mode, biases_, motion_, motion);
  since_start_.move(motion_, motion);
}

void IntegrityMonitor::changeRivals(const GaussianPose& now, const Frame& frame)
{
  if (!rivals_due_ || detectionCount(frame) == 0) return;
  // Where all landmarks are identified, the mode was chosen by what its image does not show.
  if (hasAnonymous(frame))
  {
    SymmetricRivals& rivals = pose_test_.rivals();
    if (start_)
      rivals.startAt(start_->gaussianPose(), now.mean);
    else
      rivals.changeMode(verified_mode_ ? std::optional(verified_mode_->gaussianPose()) : std::nullopt, now.mean);
    if (start_region_) rivals.leaveOutOf(*start_region_, now, since_start_);
  }
  start_.reset();
  rivals_due_ = false;
}

void IntegrityMonitor::rememberVerified(const KalmanState& mode)
{
  if (!pose_test_.verified() || !pose_test_.slipRefuted()) return;
  verified_mode_ = mode;
  start_region_.reset();
  pose_test_.rivals().rememberVerified();
}

bool IntegrityMonitor::followMode(const ModeSet& modes, const Frame& frame)
{
  if (modes.modes.empty()) return false;
  const Mode& best = modes.modes.front();
  const bool unimodal = isUnimodal(modes, options_);
  predictModes(frame.motion);
  if (tested_mode_ && detectionCount(frame) == 0) return false;
  const bool restart = tested_mode_ ? hasLeft(best, hasIdentified(frame)) : !unimodal;
  if (restart)
  {
    tested_mode_.reset();
    pose_test_.reset();
    rivals_due_ = true;
  }
  if (!unimodal) return restart;
  changeRivals(best.pose, frame);
  tested_mode_ = startingState(best.pose, biases_);
  rememberVerified(*tested_mode_);
  return restart;
}

void IntegrityMonitor::update(const InlierReport& report, const ModeSet& stated)
{
  double inliers = 0, expected = 0, expected_by_sensor = 0;
  std::size_t detections = 0;
  for (const SensorInliers& reading : report)
  {
    const auto count = static_cast<double>(std::max<std::size_t>(1, reading.detections));
    sensor_ratios_.observe(reading.sensor, reading.inliers / count, reading.expected / count, reading.detections);
    inliers += reading.inliers;
    expected += reading.expected;
    expected_by_sensor += reading.expected_by_sensor;
    detections += reading.detections;
  }
  if (!stated.modes.empty()) support_.observe(inliers, detections, stated.modes.front().pose.covariance);
  if (detections == 0) return;
  const auto count = static_cast<double>(detections);
  fast_ratio_.observe(inliers / count, expected / count, detections);
  slow_ratio_.observe(inliers / count, expected_by_sensor / count, detections);
  immediate_ratio_.observe(inliers / count, expected_by_sensor / count, detections);
}

VerdictWithReason IntegrityMonitor::verdict(const ModeSet& modes, double effective) const
{
  const bool falling = immediate_ratio_.suspicious() || fast_ratio_.suspicious();
  const double ratio = falling ? std::min(immediate_ratio_.average(), fast_ratio_.average()) : slow_ratio_.average();
  VerdictEvidence evidence{ratio, fast_ratio_.lost(), effective, pose_test_.logOddsAgainstChance(), verified()};
  if (const auto rival = pose_test_.rival(); rival && !modes.modes.empty())
  {
    evidence.rival = compose(*rival, modes.modes.front().pose.mean);
    evidence.log_odds = logOdds();
  }
  evidence.contradicted = contradicted_;
  evidence.supported = support_.supported() && pose_test_.slipRefuted();
  return judge(modes, evidence, options_);
}
}  // namespace mrpt_ext
