#include "mrpt_ext/experiment/tracking_bound.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "mrpt_ext/evaluation/posterior_bound.h"
#include "mrpt_ext/evaluation/scoring.h"
#include "mrpt_ext/filter/kalman/measurement_linearization.h"
#include "mrpt_ext/likelihood/facing_likelihood.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr double kOutlierGate = 5;  // standard deviations
constexpr double kMostOutliers = 0.5;

/// Detections of landmarks of the map, and those that do not fit the true pose.
struct FitToTruth
{
  double detections = 0, outliers = 0;
};

bool isOutlier(const DetectionRows& rows)
{
  return std::any_of(rows.rows.begin(), rows.rows.begin() + rows.count,
                     [](const KalmanRow& row) { return square(row.residual) > square(kOutlierGate) * row.variance; });
}

void addInformation(Matrix3d& information, const KalmanRow& row)
{
  information += row.jacobian.transpose() * row.jacobian / row.variance;
}

/// The direction of a landmark as if the attitude that is nearest to the truth were the only one, which no estimator
/// knows better.
void addFacing(Matrix3d& information, const Detection& detection, const Reading& reading, const LandmarkTable& map,
               const KalmanState& truth)
{
  const auto headings = headingFromFacing(detection, reading, map);
  if (!headings) return;
  std::optional<KalmanRow> nearest;
  for (const Facing::Attitude& heading : headings->attitudes)
  {
    if (!(heading.weight > 0)) continue;
    const KalmanRow row = lineariseHeading(heading.yaw, heading.std, truth.mean);
    if (!nearest || square(row.residual) / row.variance < square(nearest->residual) / nearest->variance) nearest = row;
  }
  if (nearest && square(nearest->residual) <= square(kOutlierGate) * nearest->variance)
    addInformation(information, *nearest);
}

Matrix3d informationOf(const Frame& frame, const LandmarkTable& map, const Pose2& truth, FitToTruth& fit)
{
  const KalmanState state = startingState({truth, Matrix3d::Zero()}, {});
  Matrix3d information = Matrix3d::Zero();
  for (const Reading& reading : scoredReadings(frame))
    for (const Detection& detection : reading.detections)
    {
      const auto landmark = map.indexOf(detection.id);
      if (!landmark) continue;
      const DetectionRows rows = linearise(detection, reading, map[*landmark], state.mean, {});
      ++fit.detections;
      if (isOutlier(rows))
      {
        ++fit.outliers;
        continue;
      }
      for (int r = 0; r < rows.count; ++r) addInformation(information, rows.rows[static_cast<std::size_t>(r)]);
      addFacing(information, detection, reading, map, state);
    }
  if (frame.compass)
    addInformation(information, lineariseHeading(frame.compass->heading, frame.compass->std_heading, state.mean));
  return information;
}

Matrix3d priorCovariance(const ParticleFilterOptions& filter)
{
  if (filter.initial_mode == InitialMode::gaussian) return filter.initial_pose.covariance;
  const Vector2d extent = filter.region.extent();
  return Vector3d(square(extent.x()), square(extent.y()), square(filter.region.headingExtent())).asDiagonal() *
         (1.0 / 12);
}

/// The recursion of the bound along the true poses.
class BoundAlongTruth
{
 public:
  BoundAlongTruth(const RunContext& context, const ParticleFilterOptions& filter, const OdometryPath& odometry)
      : context_(context), filter_(filter), odometry_(odometry)
  {
  }

  /// At the time of a frame, or at a scoring stamp (no frame); nothing when there is no true pose with heading then.
  std::optional<Matrix3d> advance(double time, const Frame* frame)
  {
    const auto truth = interpolate(context_.truth, time, kMaxTruthGap);
    if (!truth || !truth->heading_known) return std::nullopt;
    BoundStep step;
    if (!bound_)
      bound_.emplace(truth->pose, priorCovariance(filter_));
    else
    {
      OdometryMotion motion = odometry_.between(time_before_, time);
      motion.increment = between(before_, truth->pose);
      step.increment = motion.increment;
      step.odometry_covariance = incrementCovariance(filter_.motion, motion);
    }
    if (frame) step.measurement_information = informationOf(*frame, context_.map, truth->pose, fit_);
    before_ = truth->pose;
    time_before_ = time;
    return bound_->advance(step);
  }

  [[nodiscard]] const FitToTruth& fit() const { return fit_; }

 private:
  const RunContext& context_;
  const ParticleFilterOptions& filter_;
  const OdometryPath& odometry_;
  std::optional<BoundRecursion> bound_;
  Pose2 before_;
  double time_before_ = 0;
  FitToTruth fit_;
};

/// The bound at the stamps that lie between the frames; at one time the frame comes first. False where the truth ends.
bool addStamps(TrackingBound& result, BoundAlongTruth& bound, std::vector<double>::const_iterator& stamp,
               const std::vector<double>::const_iterator& end, double before)
{
  for (; stamp != end && *stamp < before; ++stamp)
  {
    const auto P = bound.advance(*stamp, nullptr);
    if (!P) return false;
    result.stamps.push_back({*stamp, (*P)(0, 0) + (*P)(1, 1), (*P)(2, 2)});
  }
  return true;
}
}  // namespace

TrackingBound trackingBound(const RunContext& context, const ParticleFilterOptions& filter,
                            const OdometryPath& odometry, const FrameStream& frames)
{
  std::optional<Frame> frame = frames();
  if (!frame || context.truth.empty()) return {{}, "there is no truth"};
  if (context.truth_is_sparse) return {{}, "the truth is sparse"};
  TrackingBound result;
  BoundAlongTruth bound(context, filter, odometry);
  const std::vector<double> stamps = scoringStamps(context);
  auto stamp = std::lower_bound(stamps.begin(), stamps.end(), frame->time);
  bool known = true;
  for (; frame; frame = frames())
  {
    if (hasAnonymous(*frame)) return {};  // their true landmarks are not known
    known = known && addStamps(result, bound, stamp, stamps.end(), frame->time) &&
            bound.advance(frame->time, &*frame).has_value();
  }
  known = known && addStamps(result, bound, stamp, stamps.end(), std::numeric_limits<double>::infinity());
  if (!known) return {{}, "the truth has no pose or no heading for some frames"};
  if (bound.fit().outliers > kMostOutliers * bound.fit().detections)
    return {{}, "most detections do not fit the true poses"};
  return result;
}

LimitScore limitFrom(const TrackingBound& bound, double from)
{
  LimitScore limit{.why_none = bound.why_none};
  double position = 0, heading = 0, count = 0;
  for (const TrackingBound::Stamp& stamp : bound.stamps)
  {
    if (stamp.time < from) continue;
    position += stamp.position_variance;
    heading += stamp.heading_variance;
    ++count;
  }
  if (count == 0) return limit;
  limit.position_rmse_m = std::sqrt(position / count);
  limit.heading_rmse_deg = radToDeg(std::sqrt(heading / count));
  return limit;
}
}  // namespace mrpt_ext
