#include "mrpt_ext/pipeline/tracking_bound.h"

#include <algorithm>

#include "mrpt_ext/evaluation/posterior_bound.h"
#include "mrpt_ext/evaluation/scoring.h"
#include "mrpt_ext/filter/kalman_rows.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr double kFalseBeyond = 5;  // standard deviations

bool isFalse(const DetectionRows& rows)
{
  return std::any_of(rows.rows.begin(), rows.rows.begin() + rows.count,
                     [](const KalmanRow& row) { return square(row.residual) > square(kFalseBeyond) * row.variance; });
}

void addInformation(Matrix3d& information, const KalmanRow& row)
{
  information += row.jacobian.transpose() * row.jacobian / row.variance;
}

Matrix3d informationOf(const Frame& frame, const LandmarkTable& map, const Pose2& truth)
{
  const KalmanState state = startingState({truth, Matrix3d::Zero()}, {});
  Matrix3d information = Matrix3d::Zero();
  for (const Reading& reading : scoredReadings(frame))
    for (const Detection& detection : reading.detections)
    {
      const auto landmark = map.indexOf(detection.id);
      if (!landmark) continue;
      const DetectionRows rows = linearise(detection, reading, map[*landmark], state.mean, {});
      if (isFalse(rows)) continue;
      for (int r = 0; r < rows.count; ++r) addInformation(information, rows.rows[static_cast<std::size_t>(r)]);
    }
  if (frame.compass)
    addInformation(information, lineariseHeading(frame.compass->heading, frame.compass->std_heading, state.mean));
  return information;
}

Matrix3d priorCovariance(const ParticleFilterOptions& filter)
{
  if (filter.initial_mode == InitialMode::gaussian) return filter.initial_pose.covariance;
  const Vector2d extent = filter.region.extent();
  return Vector3d(square(extent.x()), square(extent.y()), square(filter.region.turn())).asDiagonal() * (1.0 / 12);
}

bool hasNamelessDetection(const std::vector<Frame>& frames)
{
  return std::any_of(frames.begin(), frames.end(),
                     [](const Frame& frame)
                     {
                       return std::any_of(frame.readings.begin(), frame.readings.end(),
                                          [](const Reading& reading)
                                          {
                                            return std::any_of(reading.detections.begin(), reading.detections.end(),
                                                               [](const Detection& d) { return d.id == kNoId; });
                                          });
                     });
}

/// A moment at which something is measured, or at which methods are scored.
struct Moment
{
  double time = 0;
  const Frame* frame = nullptr;  // null: a scoring stamp
};

std::vector<Moment> momentsOf(const LocalizationInput& input)
{
  std::vector<Moment> moments;
  for (const Frame& frame : input.sequence.frames) moments.push_back({frame.time, &frame});
  for (const double stamp : scoringStamps(input.context))
    if (stamp >= moments.front().time) moments.push_back({stamp, nullptr});
  std::stable_sort(moments.begin(), moments.end(), [](const Moment& a, const Moment& b) { return a.time < b.time; });
  return moments;
}
}  // namespace

TrackingBound trackingBound(const LocalizationInput& input)
{
  if (input.sequence.frames.empty() || input.context.truth.empty()) return {{}, "there is no truth"};
  if (input.context.truth_is_sparse) return {{}, "the truth is sparse"};
  if (hasNamelessDetection(input.sequence.frames)) return {{}, "detections have no names, the true ones are not known"};
  const std::vector<Moment> moments = momentsOf(input);
  std::vector<BoundStep> steps;
  std::optional<Pose2> start, before;
  double time_before = 0;
  for (const Moment& moment : moments)
  {
    const auto truth = interpolate(input.context.truth, moment.time, kMaxTruthGap);
    if (!truth || !truth->heading_known) return {{}, "the truth has no pose or no heading for some frames"};
    BoundStep step;
    if (before)
    {
      OdometryMotion motion = input.sequence.odometry.between(time_before, moment.time);
      motion.increment = between(*before, truth->pose);
      step.increment = motion.increment;
      step.odometry_covariance = incrementCovariance(input.config.filter.motion, motion);
    }
    else
      start = truth->pose;
    if (moment.frame) step.measurement_information = informationOf(*moment.frame, input.context.map, truth->pose);
    steps.push_back(step);
    before = truth->pose;
    time_before = moment.time;
  }
  const auto bounds = posteriorBound(*start, priorCovariance(input.config.filter), steps);
  TrackingBound result;
  for (std::size_t k = 0; k < moments.size(); ++k)
    if (!moments[k].frame)
      result.stamps.push_back({moments[k].time, bounds[k](0, 0) + bounds[k](1, 1), bounds[k](2, 2)});
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
