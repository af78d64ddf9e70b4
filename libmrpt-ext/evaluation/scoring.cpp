#include "mrpt_ext/evaluation/scoring.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/evaluation/dead_reckoning.h"

namespace mrpt_ext
{
namespace
{
using Points = std::vector<TrackPoint>;

/// First estimate after `time`.
Points::const_iterator firstAfter(const Points& points, double time)
{
  return std::upper_bound(points.begin(), points.end(), time,
                          [](double wanted, const TrackPoint& point) { return wanted < point.time; });
}

std::optional<TimedPose> truthAt(const RunContext& context, double time)
{
  return interpolate(context.truth, time, context.truth_is_sparse ? 0.0 : kMaxTruthGap);
}

const TrackPoint* nearestEstimate(const Points& points, double stamp)
{
  const TrackPoint* nearest = nullptr;
  for (auto point = firstAfter(points, std::nextafter(stamp - kSparseTruthWindow, -HUGE_VAL)); point != points.end();
       ++point)
  {
    if (point->time > stamp + kSparseTruthWindow) break;
    if (!nearest || std::abs(point->time - stamp) <= std::abs(nearest->time - stamp)) nearest = &*point;
  }
  return nearest;
}

std::optional<JudgedEstimate> judgeNearSparseStamp(const Points& points, const RunContext& context,
                                                   const Trajectory& odometry, double stamp)
{
  const TrackPoint* nearest = nearestEstimate(points, stamp);
  const auto truth = truthAt(context, stamp);
  if (!nearest || !truth) return std::nullopt;
  return JudgedEstimate{stamp, carry(*nearest, odometry, stamp), *truth};
}

std::optional<JudgedEstimate> judgeLastOfSecond(const Points& points, const RunContext& context, double stamp)
{
  const auto after = firstAfter(points, stamp);
  if (after == points.begin() || (after - 1)->time <= stamp - 1.0) return std::nullopt;
  const auto truth = truthAt(context, (after - 1)->time);
  if (!truth) return std::nullopt;
  return JudgedEstimate{stamp, *(after - 1), *truth};
}
}  // namespace

std::vector<double> scoringStamps(const RunContext& context)
{
  const double start = context.start_time, end = context.start_time + context.duration_s;
  std::vector<double> stamps;
  if (context.truth_is_sparse)
  {
    for (const TimedPose& truth : context.truth)
      if (truth.time >= start && truth.time <= end) stamps.push_back(truth.time);
    return stamps;
  }
  for (double stamp = std::ceil(start); stamp <= end; stamp += 1.0)
    if (truthAt(context, stamp)) stamps.push_back(stamp);
  return stamps;
}

std::vector<JudgedEstimate> judge(const MethodTrack& track, const RunContext& context, const Trajectory& odometry)
{
  if (!track.continuous) return judgeAtOwnTimes(track, context, odometry);
  std::vector<JudgedEstimate> judged;
  for (const double stamp : scoringStamps(context))
  {
    const auto after = firstAfter(track.points, stamp);
    if (after == track.points.begin()) continue;
    judged.push_back({stamp, carry(*(after - 1), odometry, stamp), *truthAt(context, stamp)});
  }
  return judged;
}

std::vector<JudgedEstimate> judgeAtOwnTimes(const MethodTrack& track, const RunContext& context,
                                            const Trajectory& odometry)
{
  std::vector<JudgedEstimate> judged;
  for (const double stamp : scoringStamps(context))
  {
    const auto entry = context.truth_is_sparse ? judgeNearSparseStamp(track.points, context, odometry, stamp)
                                               : judgeLastOfSecond(track.points, context, stamp);
    if (entry) judged.push_back(*entry);
  }
  return judged;
}

std::vector<ErrorSample> errorsOf(const std::vector<JudgedEstimate>& judged)
{
  std::vector<ErrorSample> errors;
  errors.reserve(judged.size());
  for (const JudgedEstimate& entry : judged)
  {
    const Pose2 &estimate = entry.estimate.pose.mean, &truth = entry.truth.pose;
    ErrorSample sample{entry.stamp, entry.estimate.time, (estimate.position() - truth.position()).norm(), {}};
    if (entry.estimate.heading_known && entry.truth.heading_known)
      sample.heading_deg = radToDeg(std::abs(wrap(estimate.phi - truth.phi)));
    errors.push_back(sample);
  }
  return errors;
}
}  // namespace mrpt_ext
