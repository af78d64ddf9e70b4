#include "tree_experiment.h"

#include "error_at_bound.h"
#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "mrpt_ext/solvers/bearing_pose_ml.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "paper_settings.h"
#include "tree_counts.h"

namespace mrpt_ext::papers
{
namespace
{
/// The first `observations` bearings of a scene.
AnonymousScene firstOf(AnonymousScene scene, int observations)
{
  scene.bearings.resize(static_cast<std::size_t>(observations));
  scene.truth.resize(static_cast<std::size_t>(observations));
  return scene;
}

void add(TreeRuleCounts& counts, const TreeCounts& tree, const std::vector<int>& truth, int trials)
{
  counts.examined.add(tree.examined);
  counts.solutions.add(static_cast<double>(tree.assignments.size()));
  counts.truth_found += static_cast<double>(tree.assignments.count(truth)) / trials;
}

/// Pose errors with the names given; left out where robot and landmarks are so near one circle that no pose exists.
void addErrors(TreeResult& result, const AnonymousScene& s, double std_bearing, RandomStream& random)
{
  std::vector<KnownBearing> known;
  std::vector<PoseMeasurement> measurements;
  for (std::size_t i = 0; i < s.bearings.size(); ++i)
  {
    const Vector2d& landmark = s.scene.landmarks[static_cast<std::size_t>(s.truth[i])];
    known.push_back({landmark, s.bearings[i].bearing, std_bearing});
    measurements.push_back({PoseMeasurement::Kind::bearing, landmark, s.bearings[i].bearing, std_bearing, {}});
  }
  const BearingPoseLinear linear = solveBearingPoseLinear(known);
  const PoseMl ml = solveBearingPoseMl(known);
  const auto bound = covarianceFromInformation(poseInformation(measurements, s.scene.robot));
  if (linear.status != SolveStatus::ok || ml.status != SolveStatus::ok || !bound) return;
  result.closed_form_error.add((linear.pose.position() - s.scene.robot.position()).norm());
  result.ml_error.add((ml.pose.mean.position() - s.scene.robot.position()).norm());
  result.bound_error.add(errorAtBound(bound->topLeftCorner<2, 2>(), random));
}

/// Share of the maps with two solutions at five bearings and one at six and at seven; 0 where these were not tried.
double shareOfTwoThenOne(const std::vector<TreeResult>& results, TreeRuleCounts TreeResult::*rule)
{
  const std::pair<int, double> wanted[] = {{5, 2}, {6, 1}, {7, 1}};
  std::vector<int> fits;
  for (const TreeResult& result : results)
    for (const auto& [observations, solutions] : wanted)
    {
      if (result.observations != observations) continue;
      const auto& counts = (result.*rule).solutions.values();
      fits.resize(counts.size());
      for (std::size_t map = 0; map < counts.size(); ++map) fits[map] += counts[map] == solutions ? 1 : 0;
    }
  return fits.empty() ? 0
                      : static_cast<double>(std::count(fits.begin(), fits.end(), 3)) / static_cast<double>(fits.size());
}
}  // namespace

TreeExperiment runTreeExperiment(const Settings& settings)
{
  const int trials = trialsOf(settings), landmarks = static_cast<int>(settings.integer("Tree", "landmarks"));
  const double gate = settings.radians("Tree", "gate_deg"), std_bearing = settings.radians("Tree", "std_bearing_deg");
  TreeExperiment experiment;
  for (const double observations : settings.numbers("Tree", "observations"))
  {
    TreeResult result;
    result.observations = static_cast<int>(observations);
    result.total_paths = totalPaths(landmarks, result.observations);
    experiment.results.push_back(result);
  }
  RandomStream random(seedOf(settings)), bound_random(seedOf(settings), 1);
  for (int trial = 0; trial < trials; ++trial)
  {
    const AnonymousScene all = observeAnonymously(random, landmarks, landmarks, 0, std_bearing);
    for (TreeResult& result : experiment.results)
    {
      const AnonymousScene s = firstOf(all, result.observations);
      add(result.paper, countTree(s, TreeRule::paper, gate), s.truth, trials);
      add(result.ours, countTree(s, TreeRule::ours, gate), s.truth, trials);
      addErrors(result, s, std_bearing, bound_random);
    }
  }
  experiment.two_then_one_paper = shareOfTwoThenOne(experiment.results, &TreeResult::paper);
  experiment.two_then_one_ours = shareOfTwoThenOne(experiment.results, &TreeResult::ours);
  return experiment;
}
}  // namespace mrpt_ext::papers
