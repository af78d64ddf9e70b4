#include "mrpt_ext/evaluation/scoring.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext
{
namespace
{
/// Reads the estimates of a trajectory once, for ascending stamps.
class EstimateWindow
{
 public:
  explicit EstimateWindow(const MethodTrajectory& trajectory)
      : next_(trajectory.points.begin()), end_(trajectory.points.end())
  {
  }

  /// The estimates from `from` to `to` [s], and the last one before them; neither may go back from call to call.
  const std::deque<PoseEstimate>& moveTo(double from, double to)
  {
    for (; next_ != end_ && next_->time <= to; ++next_)
    {
      dropBefore(from);
      window_.push_back(*next_);
    }
    dropBefore(from);
    return window_;
  }

 private:
  void dropBefore(double from)
  {
    while (window_.size() > 1 && window_[1].time < from) window_.pop_front();
  }

  DiskBackedSequence<PoseEstimate>::const_iterator next_, end_;
  std::deque<PoseEstimate> window_;
};

const PoseEstimate* nearestEstimate(EstimateWindow& estimates, double stamp)
{
  const double from = stamp - kSparseTruthWindow;
  const PoseEstimate* nearest = nullptr;
  for (const PoseEstimate& point : estimates.moveTo(from, stamp + kSparseTruthWindow))
    if (point.time >= from && (!nearest || std::abs(point.time - stamp) <= std::abs(nearest->time - stamp)))
      nearest = &point;
  return nearest;
}

std::optional<JudgedEstimate> judgeNearSparseStamp(EstimateWindow& estimates, const RunContext& context, double stamp)
{
  const PoseEstimate* nearest = nearestEstimate(estimates, stamp);
  const auto truth = truthAt(context, stamp);
  if (!nearest || !truth) return std::nullopt;
  return JudgedEstimate{stamp, propagate(*nearest, context.odometry, stamp), *truth};
}

std::optional<JudgedEstimate> judgeLastOfSecond(EstimateWindow& estimates, const RunContext& context, double stamp)
{
  const auto& window = estimates.moveTo(stamp, stamp);
  if (window.empty() || window.back().time <= stamp - 1.0) return std::nullopt;
  const auto truth = truthAt(context, window.back().time);
  if (!truth) return std::nullopt;
  return JudgedEstimate{stamp, window.back(), *truth};
}
}  // namespace

std::optional<TimedPose> truthAt(const RunContext& context, double time)
{
  return interpolate(context.truth, time, context.truth_is_sparse ? 0.0 : kMaxTruthGap);
}

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
  auto next = context.truth.begin();
  for (double stamp = std::ceil(start); stamp <= end; stamp += 1.0)
  {
    if (truthAt(context, stamp))
    {
      stamps.push_back(stamp);
      continue;
    }
    // A gap in the truth, which may be long, is skipped at once.
    next = std::find_if(next, context.truth.end(), [&](const TimedPose& pose) { return pose.time > stamp; });
    if (next == context.truth.end()) break;
    stamp = std::max(stamp, std::ceil(next->time) - 1);
  }
  return stamps;
}

std::vector<JudgedEstimate> judge(const MethodTrajectory& trajectory, const RunContext& context)
{
  if (!trajectory.continuous) return judgeAtOwnTimes(trajectory, context);
  std::vector<JudgedEstimate> judged;
  EstimateWindow estimates(trajectory);
  for (const double stamp : scoringStamps(context))
    if (const auto& window = estimates.moveTo(stamp, stamp); !window.empty())
      judged.push_back({stamp, propagate(window.back(), context.odometry, stamp), *truthAt(context, stamp)});
  return judged;
}

std::vector<JudgedEstimate> judgeAtOwnTimes(const MethodTrajectory& trajectory, const RunContext& context)
{
  std::vector<JudgedEstimate> judged;
  EstimateWindow estimates(trajectory);
  for (const double stamp : scoringStamps(context))
  {
    const auto entry = context.truth_is_sparse ? judgeNearSparseStamp(estimates, context, stamp)
                                               : judgeLastOfSecond(estimates, context, stamp);
    if (entry) judged.push_back(*entry);
  }
  return judged;
}

ErrorSample errorOf(const JudgedEstimate& entry)
{
  const Pose2 &estimate = entry.estimate.pose.mean, &truth = entry.truth.pose;
  ErrorSample sample{entry.stamp, entry.estimate.time, (estimate.position() - truth.position()).norm(), {}};
  if (entry.estimate.heading_known && entry.truth.heading_known)
    sample.heading_deg = radToDeg(std::abs(wrap(estimate.phi - truth.phi)));
  return sample;
}

std::vector<ErrorSample> errorsOf(const std::vector<JudgedEstimate>& judged)
{
  std::vector<ErrorSample> errors;
  errors.reserve(judged.size());
  for (const JudgedEstimate& entry : judged) errors.push_back(errorOf(entry));
  return errors;
}
}  // namespace mrpt_ext
