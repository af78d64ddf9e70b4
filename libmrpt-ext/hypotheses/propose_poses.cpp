#include "mrpt_ext/hypotheses/propose_poses.h"

#include <algorithm>

#include "mrpt_ext/hypotheses/interpret_sightings.h"
#include "mrpt_ext/hypotheses/pose_proposals.h"
#include "mrpt_ext/likelihood/compass_likelihood.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"
#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMergeDistance = 0.1;  // [m]
constexpr double kMergeAngle = degToRad(3.0);

void append(HypothesisSet& all, HypothesisSet more)
{
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// Refines a pose from a minimal subset on everything that is identified, tolerating false readings.
void refine(PoseHypothesis& hypothesis, std::span<const PoseMeasurement> rows)
{
  if (!hypothesis.heading_known || rows.size() < 3) return;
  const PoseMl fit = refinePose(rows, hypothesis.pose.mean, {.loss = Loss::cauchy});
  if (fit.status == SolveStatus::ok && fit.converged) hypothesis.pose = fit.pose;
}

double logScore(const Frame& frame, const LandmarkTable& map, const Pose2& pose)
{
  double score = 0;
  for (const Reading& reading : frame.readings) score += logLikelihood(reading, map, pose);
  for (const RunningFixReading& fix : frame.fixes)
    for (const Reading& reading : asReadings(fix)) score += logLikelihood(reading, map, pose);
  if (frame.compass) addCompassLogLikelihood(*frame.compass, {{&pose.x, 1}, {&pose.y, 1}, {&pose.phi, 1}}, {&score, 1});
  return score;
}
}  // namespace

HypothesisSet proposePoses(const Frame& frame, const LandmarkTable& map, const ProposalOptions& options)
{
  const std::vector<LandmarkSighting> identified = identifiedSightings(frame.readings, map);
  HypothesisSet all = proposeFromPointPairs(identified);
  append(all, proposeFromBearings(identified));
  if (all.empty()) append(all, proposeFromRanges(identified));
  const std::vector<PoseMeasurement> rows = poseMeasurements(identified);
  for (PoseHypothesis& hypothesis : all) refine(hypothesis, rows);
  if (all.empty()) append(all, proposeFromRing(identified, options.ring_points));
  append(all, proposeFromRunningFixes(frame, map, options.ring_points));

  const std::vector<LandmarkSighting> unidentified = unidentifiedSightings(frame.readings, map);
  append(all, proposeFromAnonymousPoints(unidentified, map));
  append(all, interpretSightings(unidentified, map, options.region, true).hypotheses);

  std::erase_if(all, [&](const PoseHypothesis& h) { return !options.region.contains(h.pose.mean); });
  for (PoseHypothesis& hypothesis : all) hypothesis.log_score = logScore(frame, map, hypothesis.pose.mean);
  rankByScore(all);
  mergeDuplicates(all, kMergeDistance, kMergeAngle);
  if (all.size() > options.max_hypotheses) all.resize(options.max_hypotheses);
  rankByScore(all);
  return all;
}
}  // namespace mrpt_ext
