#include <gtest/gtest.h>

#include <algorithm>

#include "global_search_scene.h"
#include "mrpt_ext/correspondence/bearings/inlier_refinement.h"
#include "mrpt_ext/correspondence/bearings/triple_hypotheses.h"
#include "mrpt_ext/correspondence/scan_bearing.h"
#include "test_length.h"

namespace mrpt_ext::test_true_triples
{
namespace
{
constexpr double kGate = 3.3;

/// What becomes of triples of bearings that are not false.
struct Fate
{
  int triples = 0, at_truth = 0;
};

/// The cheapest ten of a view, as a search would try them.
void follow(const LandmarkIndex& index, const SceneScan& view, Fate& fate)
{
  const std::vector<ScanBearing> bearings = gatherBearings({&view.scan, 1});
  const double range = *view.scan.model.max_range;
  const PotentiallyVisibleSets lists(index, range, 0.02 * range);
  const DirectionTable table(bearings, kGate);
  SearchDensity density;
  density.landmarks_allowed.assign(bearings.size(), static_cast<double>(index.size()));
  density.max_range = {range};
  density.area = (index.high() - index.low()).prod();
  density.chance = 0.1;
  std::vector<DetectionTriple> triples = tripleCandidates(bearings, density);
  std::erase_if(triples,
                [&](const DetectionTriple& t)
                {
                  return std::any_of(t.detection.begin(), t.detection.end(),
                                     [&](int r) { return view.truth[static_cast<std::size_t>(r)] < 0; });
                });
  std::sort(triples.begin(), triples.end(),
            [](const DetectionTriple& a, const DetectionTriple& b) { return a.cost < b.cost; });
  if (triples.size() > 10) triples.resize(10);
  const NeighbourGrid neighbours(index, kAnyCategory);
  for (const DetectionTriple& triple : triples)
  {
    BoundingScan seen{&table, &lists, Pose2{}, 0};
    for (const int r : triple.detection) seen.used |= 1U << r;
    TripleHypotheses hypotheses;
    hypotheses.map = &index;
    hypotheses.bearings = bearings;
    hypotheses.triple = triple;
    hypotheses.neighbours = {&neighbours, &neighbours};
    hypotheses.scans = {seen};
    hypotheses.max_range = range;
    hypotheses.gate = kGate;
    WorkBudget unlimited;
    hypotheses.budget = &unlimited;
    ProposalStore store(4, 500'000);
    hypotheses.run(store);
    GatedLandmarks scratch;
    const std::vector<PoseProposal> proposals = store.takeSorted();
    fate.at_truth += std::any_of(proposals.begin(), proposals.end(),
                                 [&](const PoseProposal& p)
                                 {
                                   const RefinedPose tight =
                                       refineOnInliers(p.sensor, hypotheses.scans, kGate, 4, scratch);
                                   return isAtTruth(tight.sensor.mean, view.robot);
                                 });
    ++fate.triples;
  }
}

/// A schedule of f + 1 disjoint triples finds the truth only if true triples lead there.
TEST(TrueTriples, LeadToTheTruth)
{
  SearchSceneOptions options;
  options.landmarks = 80;
  Fate fate;
  const auto scenes = static_cast<std::uint64_t>(testing::runsOfTest(60));
  for (std::uint64_t scene = 0; scene < scenes; ++scene)
  {
    RandomStream random(77, scene);
    const SceneMap map = randomMap(options, random);
    const LandmarkIndex index = map.index();
    follow(index, observeSomewhere(map, index, options, random), fate);
  }
  EXPECT_EQ(fate.triples, static_cast<int>(10 * scenes));
  EXPECT_GE(fate.at_truth, 0.92 * fate.triples);
}
}  // namespace
}  // namespace mrpt_ext::test_true_triples
