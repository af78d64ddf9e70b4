#include <gtest/gtest.h>

#include <algorithm>

#include "global_search_scene.h"
#include "mrpt_ext/correspondence/bearings/inlier_refinement.h"
#include "mrpt_ext/correspondence/bearings/triple_hypotheses.h"
#include "mrpt_ext/correspondence/scan_bearing.h"

namespace mrpt_ext
{
namespace
{
constexpr double kGate = 3.3;

/// What becomes of triples of readings that are not false.
struct Fate
{
  int triples = 0, at_truth = 0;
};

/// The cheapest ten of a view, as a search would try them.
void follow(const LandmarkIndex& index, const LostView& view, Fate& fate)
{
  const std::vector<ScanBearing> readings = gatherBearings({&view.place, 1});
  const double range = *view.place.model.max_range;
  const PotentiallyVisibleSets lists(index, range, 0.02 * range);
  const ReadingTable table(readings, kGate);
  SearchDensity density;
  density.landmarks_allowed.assign(readings.size(), static_cast<double>(index.size()));
  density.max_range = {range};
  density.area = (index.high() - index.low()).prod();
  density.chance = 0.1;
  std::vector<ReadingTriple> triples = tripleCandidates(readings, density);
  std::erase_if(triples,
                [&](const ReadingTriple& t)
                {
                  return std::any_of(t.reading.begin(), t.reading.end(),
                                     [&](int r) { return view.truth[static_cast<std::size_t>(r)] < 0; });
                });
  std::sort(triples.begin(), triples.end(),
            [](const ReadingTriple& a, const ReadingTriple& b) { return a.cost < b.cost; });
  if (triples.size() > 10) triples.resize(10);
  const NeighbourGrid neighbours(index, kAnyCategory);
  for (const ReadingTriple& triple : triples)
  {
    BoundingScan seen{&table, &lists, Pose2{}, 0};
    for (const int r : triple.reading) seen.used |= 1U << r;
    TripleRound round;
    round.map = &index;
    round.readings = readings;
    round.triple = triple;
    round.neighbours = {&neighbours, &neighbours};
    round.views = {seen};
    round.max_range = range;
    round.gate = kGate;
    round.max_tested = 1'000'000'000;
    ProposalStore store(4, 500'000);
    round.run(store);
    GatedLandmarks scratch;
    const std::vector<PoseProposal> proposals = store.takeSorted();
    fate.at_truth += std::any_of(proposals.begin(), proposals.end(),
                                 [&](const PoseProposal& p)
                                 {
                                   const RefinedPose tight = refineOnInliers(p.sensor, round.views, kGate, 4, scratch);
                                   return isAtTruth(tight.sensor.mean, view.robot);
                                 });
    ++fate.triples;
  }
}

/// A cover of f + 1 disjoint triples finds the truth only if true triples lead there.
TEST(TrueTriples, LeadToTheTruth)
{
  LostSceneOptions options;
  options.landmarks = 80;
  Fate fate;
  for (std::uint64_t scene = 0; scene < 60; ++scene)
  {
    RandomStream random(77, scene);
    const LostMap map = strewLandmarks(options, random);
    const LandmarkIndex index = map.index();
    follow(index, lookAroundSomewhere(map, index, options, random), fate);
  }
  EXPECT_EQ(fate.triples, 600);
  EXPECT_GE(fate.at_truth, 0.92 * fate.triples);
}
}  // namespace
}  // namespace mrpt_ext
