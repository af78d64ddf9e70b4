#include "mrpt_ext/hypotheses/propose_poses.h"

#include <algorithm>

#include "mrpt_ext/hypotheses/pose_proposals.h"
#include "mrpt_ext/hypotheses/propose_from_association.h"
#include "mrpt_ext/hypotheses/propose_from_window.h"
#include "mrpt_ext/hypotheses/window_readings.h"
#include "mrpt_ext/likelihood/compass_likelihood.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"
#include "mrpt_ext/likelihood/scoring_work.h"
#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMergeDistance = 0.1;  // [m]
constexpr double kMergeAngle = degToRad(3.0);
constexpr double kShareOfReading = 0.5;  // of the work, for a single reading; the window gets the rest
constexpr std::size_t kRingPoints = 36;  // hypotheses that sample a ring of unknown heading

void append(HypothesisSet& all, HypothesisSet more)
{
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// The reading with most anonymous detections; of several, the newest.
std::span<const Reading> fullestReading(std::span<const Reading> readings)
{
  const auto count = [](const Reading& reading)
  {
    return std::count_if(reading.detections.begin(), reading.detections.end(),
                         [](const Detection& d) { return d.id == kNoId; });
  };
  std::size_t fullest = 0;
  for (std::size_t r = 1; r < readings.size(); ++r)
    if (count(readings[r]) >= count(readings[fullest])) fullest = r;
  return readings.subspan(fullest, readings.empty() ? 0 : 1);
}

/// Refines a pose from a minimal subset on all identified detections, with a loss that is robust against outliers.
void refine(PoseHypothesis& hypothesis, std::span<const PoseMeasurement> rows)
{
  if (!hypothesis.heading_known || rows.size() < 3) return;
  const PoseMl fit = refinePose(rows, hypothesis.pose.mean, Loss::cauchy);
  if (fit.status == SolveStatus::ok && fit.converged) hypothesis.pose = fit.pose;
}

/// Log-likelihood of all measurements of the frame, for all hypotheses at once.
void score(HypothesisSet& hypotheses, const Frame& frame, const LandmarkTable& map)
{
  if (hypotheses.empty()) return;
  const auto [low, high] = map.boundingBox();
  PoseColumns columns((low + high) / 2);
  for (const PoseHypothesis& hypothesis : hypotheses) columns.add(hypothesis.pose.mean);
  const PoseBatch poses = columns.batch();
  std::vector<float> log_score(hypotheses.size(), 0.0F);
  const std::optional<Frame> affordable = affordableToScore(frame, map, poses);
  for (const Reading& reading : scoredReadings(affordable ? *affordable : frame))
    addLogLikelihood(reading, map, {}, poses, log_score);
  if (frame.compass) addCompassLogLikelihood(*frame.compass, poses, log_score);
  for (std::size_t i = 0; i < hypotheses.size(); ++i) hypotheses[i].log_score = double{log_score[i]};
}
}  // namespace

HypothesisSet proposePoses(const Frame& frame, const LandmarkTable& map, const GlobalPoseSearch& search,
                           const ProposalOptions& options)
{
  WorkBudget own = search.budget();
  PoseSearchOptions limits = options.limits;
  if (limits.budget == nullptr) limits.budget = &own;
  const std::vector<LandmarkMeasurement> identified = identifiedMeasurements(frame.readings, map);
  HypothesisSet all = proposeFromPointPairs(identified);
  append(all, proposeFromBearings(identified));
  if (all.empty()) append(all, proposeFromRanges(identified));
  append(all, proposeFromFacing(identified));
  const std::vector<PoseMeasurement> rows = poseMeasurements(identified);
  for (PoseHypothesis& hypothesis : all) refine(hypothesis, rows);
  if (all.empty()) append(all, proposeFromRing(identified, kRingPoints));
  append(all, proposeFromRunningFixes(frame, map, kRingPoints));

  if (isWindow(frame.readings))
  {
    append(all, proposeFromWindowLandmarks(frame.readings, map, frame.compass, kRingPoints));
    // The local map of a window may fail where a single scan suffices.
    WorkBudget first(*limits.budget, kShareOfReading);
    PoseSearchOptions of_reading = limits;
    of_reading.budget = &first;
    append(all,
           proposeFromAssociation(fullestReading(frame.readings), map, search, options.region, of_reading).hypotheses);
  }
  append(all, proposeFromAssociation(frame.readings, map, search, options.region, limits).hypotheses);
  append(all, proposeFromThreeBearings(frame.readings, map, search, options.region, limits));

  std::erase_if(all, [&](const PoseHypothesis& h) { return !options.region.contains(h.pose.mean); });
  score(all, frame, map);
  rankByScore(all);
  mergeDuplicates(all, kMergeDistance, kMergeAngle);
  if (all.size() > options.max_hypotheses) all.resize(options.max_hypotheses);
  rankByScore(all);
  return all;
}
}  // namespace mrpt_ext
