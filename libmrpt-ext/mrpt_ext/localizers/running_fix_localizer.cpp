#include "mrpt_ext/localizers/running_fix_localizer.h"

#include "mrpt_ext/geometry/concatenated_motion.h"
#include "mrpt_ext/hypotheses/landmark_measurement.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"
#include "mrpt_ext/localizers/closed_form_methods.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinDisplacementStds = 10;  // between the two ranges of a fix, in standard deviations of a range
constexpr double kMaxAge = 60;               // [s] of the first range
}  // namespace

Estimate RunningFixLocalizer::process(const Frame& frame)
{
  predict(frame.motion);
  updateHeading(frame);
  std::vector<RunningFixReading> fixes = frame.fixes;
  for (RunningFixReading& fix : fixesFromRanges(frame)) fixes.push_back(std::move(fix));
  if (fixes.empty()) return {};
  if (!heading_) return {.status = SolveStatus::degenerate};  // a ring

  ClosedFormResult result{.candidates = candidatesOf(fixes, frame)};
  result.status = result.candidates.empty() ? SolveStatus::none : SolveStatus::ok;
  Estimate estimate = estimateFrom(std::move(result), frame.time, options_.limits);
  if (estimate.point && options_.heading_source == HeadingSource::bearing) heading_ = headingOf(estimate.point->pose);
  return estimate;
}

void RunningFixLocalizer::predict(const OdometryMotion& measured)
{
  const OdometryMotion motion = nominalMotion(options_.motion, measured);
  for (auto& [id, ranges] : pending_)
  {
    for (PendingRange& range : ranges) range.since = concatenated(range.since, motion);
    while (!ranges.empty() && ranges.front().since.duration > kMaxAge) ranges.pop_front();
  }
  if (!heading_) return;
  heading_->heading = wrap(heading_->heading + motion.increment.phi);
  heading_->std_heading = std::hypot(heading_->std_heading, incrementStd(options_.motion, motion).z());
}

void RunningFixLocalizer::updateHeading(const Frame& frame)
{
  switch (options_.heading_source)
  {
    case HeadingSource::none:
      heading_.reset();
      break;
    case HeadingSource::filter:
      heading_ = filter_heading_ ? filter_heading_() : std::nullopt;
      break;
    case HeadingSource::compass:
      if (frame.compass) heading_ = HeadingPrior{frame.compass->heading, frame.compass->std_heading};
      break;
    case HeadingSource::bearing:
      if (const ClosedFormResult fit = twoLandmarkPose(frame, map_); fit.status == SolveStatus::ok)
        heading_ = headingOf(fit.candidates.front().pose);
      break;
  }
}

std::vector<RunningFixReading> RunningFixLocalizer::fixesFromRanges(const Frame& frame)
{
  std::vector<RunningFixReading> fixes;
  for (const LandmarkMeasurement& m : identifiedMeasurements(frame.readings, map_))
  {
    if (!m.range) continue;
    const int id = map_[*m.landmark].id;
    std::deque<PendingRange>& earlier = pending_[id];
    // The newest range far enough away: a short distance keeps the odometry error small.
    for (std::size_t left = earlier.size(); left > 0; --left)
    {
      const PendingRange& partner = earlier[left - 1];
      const double displacement = partner.since.increment.position().norm();
      if (displacement < kMinDisplacementStds * std::max(m.std_range, partner.std)) continue;
      // The robot pose from which the second sensor would have measured the first range.
      const Pose2 swap = compose(m.T_robot_sensor, inverse(partner.T_robot_sensor));
      const GaussianPose moved = compound({swap, Matrix3d::Zero()}, partner.since.increment,
                                          incrementCovariance(options_.motion, partner.since));
      fixes.push_back({.time = frame.time,
                       .first_time = partner.time,
                       .T_robot_sensor = m.T_robot_sensor,
                       .horizontal_range = true,
                       .id = id,
                       .first_range = partner.range,
                       .first_std = partner.std,
                       .second_range = *m.range,
                       .second_std = m.std_range,
                       .displacement = moved.mean,
                       .displacement_covariance = moved.covariance,
                       .second_bearing = m.bearing,
                       .second_bearing_std = m.std_bearing});
      break;
    }
    earlier.push_back({frame.time, *m.range, m.std_range, m.T_robot_sensor, {}});
  }
  return fixes;
}

HypothesisSet RunningFixLocalizer::candidatesOf(const std::vector<RunningFixReading>& fixes, const Frame& frame) const
{
  HypothesisSet candidates;
  for (RunningFixReading fix : fixes)
  {
    const auto known = map_.indexOf(fix.id);
    if (!known || !reduceToHorizontal(fix, map_[*known].position.z())) continue;
    for (const RunningFixPose& candidate : runningFixPoses(fix, map_[*known].position.head<2>(), *heading_).candidates)
    {
      if (!options_.region.contains(candidate.pose.mean)) continue;
      double score = frame.fixes.empty() ? 0 : candidate.log_score;
      for (const Reading& reading : frame.readings) score += logLikelihood(reading, map_, candidate.pose.mean);
      candidates.push_back({.pose = candidate.pose, .log_score = score, .source = "running_fix"});
    }
  }
  return candidates;
}
}  // namespace mrpt_ext
