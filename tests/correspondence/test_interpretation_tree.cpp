#include "mrpt_ext/correspondence/interpretation_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mrpt_ext/solvers/bearing_pose_ml.h"
#include "random_scene.h"

namespace mrpt_ext
{
namespace
{
using Assignments = std::set<std::vector<int>>;

struct Sighting
{
  Scene scene;
  std::vector<UnidentifiedBearing> bearings;
  std::vector<int> truth;  ///< -1: false bearing
};

/// `seen` of the landmarks in random order, then false bearings at random places.
Sighting look(RandomStream& random, int landmark_count, int seen, int false_count, double noise)
{
  Sighting s;
  s.scene = randomScene(random, landmark_count);
  std::vector<int> rest;
  for (int i = 0; i < landmark_count; ++i) rest.push_back(i);
  for (int k = 0; k < seen; ++k)
  {
    const auto pick = rest.begin() + static_cast<long>(random.below(rest.size()));
    const double b = predictBearing(s.scene.robot, s.scene.landmarks[static_cast<std::size_t>(*pick)]);
    s.bearings.push_back({wrap(b + noise * random.gaussian()), {}});
    s.truth.push_back(*pick);
    rest.erase(pick);
  }
  for (int k = 0; k < false_count; ++k)
  {
    const auto at = static_cast<long>(random.below(s.bearings.size() + 1));
    s.bearings.insert(s.bearings.begin() + at, {random.uniform(-kPi, kPi), {}});
    s.truth.insert(s.truth.begin() + at, -1);
  }
  return s;
}

Assignments assignments(const Interpretations& result)
{
  Assignments all;
  for (const Interpretation& s : result.solutions) all.insert(s.assignment);
  return all;
}

/// The definition, by trying every ordered assignment of all bearings; `doubtful` collects those near a threshold.
struct BruteForce
{
  const Sighting& s;
  const InterpretationOptions& options;
  Assignments found, doubtful;
  std::vector<int> assignment;

  void run()
  {
    if (assignment.size() == s.bearings.size()) return judge();
    for (int l = 0; l < static_cast<int>(s.scene.landmarks.size()); ++l)
    {
      if (std::find(assignment.begin(), assignment.end(), l) != assignment.end()) continue;
      assignment.push_back(l);
      run();
      assignment.pop_back();
    }
  }

  void judge()
  {
    std::vector<KnownBearing> known;
    for (std::size_t i = 0; i < assignment.size(); ++i)
      known.push_back({s.scene.landmarks[static_cast<std::size_t>(assignment[i])], s.bearings[i].bearing, 1});
    const PoseMl ml = solveBearingPoseMl(known);
    if (ml.status != SolveStatus::ok) return;
    double worst = 0;
    for (const double r : ml.residuals) worst = std::max(worst, std::abs(r));
    const Vector2d p = ml.pose.mean.position();
    const double inside = std::min({p.x(), p.y(), 10 - p.x(), 10 - p.y()});
    if (std::abs(inside) < 1e-3 || std::abs(worst - options.max_residual) < 0.01 * options.max_residual)
      doubtful.insert(assignment);
    else if (inside > 0 && worst < options.max_residual)
      found.insert(assignment);
  }
};

InterpretationOptions optionsFor(double sigma, double margin = 0)
{
  InterpretationOptions options;
  options.max_residual = 3.3 * sigma;
  options.area = MapArea{{-margin, -margin}, {10 + margin, 10 + margin}};
  return options;
}

/// Share of trials whose solutions agree with the truth wherever it names a landmark.
double recall(int seen, int false_count, double sigma, InterpretationGate gate, std::uint64_t seed, int trials)
{
  RandomStream random(seed);
  int hits = 0;
  for (int trial = 0; trial < trials; ++trial)
  {
    const Sighting s = look(random, 12, seen, false_count, sigma);
    InterpretationOptions options = optionsFor(sigma, 1);
    options.gate = gate;
    options.max_unmatched = false_count;
    const Interpretations result = interpretBearings(s.scene.landmarks, s.bearings, options);
    EXPECT_TRUE(result.finished);
    const auto agrees = [&](const Interpretation& found)
    {
      for (std::size_t i = 0; i < s.truth.size(); ++i)
        if (s.truth[i] >= 0 && found.assignment[i] != s.truth[i]) return false;
      return true;
    };
    hits += std::any_of(result.solutions.begin(), result.solutions.end(), agrees) ? 1 : 0;
  }
  return static_cast<double>(hits) / trials;
}

Sighting exactSighting()
{
  Sighting s;
  s.scene = {{{1, 1}, {9, 2}, {8, 9}, {2, 7}, {5, 9.5}, {0.5, 4}}, {4, 3, 0.5}};
  for (const int l : {3, 0, 4, 1, 2})
  {
    s.bearings.push_back({predictBearing(s.scene.robot, s.scene.landmarks[static_cast<std::size_t>(l)]), {}});
    s.truth.push_back(l);
  }
  return s;
}
}  // namespace

TEST(InterpretationTree, ExactBearingsNameThePoseAndTheLandmarks)
{
  const Sighting s = exactSighting();
  const Interpretations result = interpretBearings(s.scene.landmarks, s.bearings, optionsFor(0.001));
  ASSERT_EQ(result.status, SolveStatus::ok);
  ASSERT_EQ(result.solutions.size(), 1u);
  EXPECT_EQ(result.solutions[0].assignment, s.truth);
  EXPECT_LT((result.solutions[0].pose.mean.vector() - s.scene.robot.vector()).norm(), 1e-9);
  EXPECT_GT(result.solutions[0].pose.covariance(0, 0), 0);
  EXPECT_EQ(result.tested_by_depth.size(), 3u);
  EXPECT_EQ(result.valid_by_depth.back(), 1u);
}

TEST(InterpretationTree, ASquareRoomHasFourPosesOfEqualRank)
{
  const std::vector<Vector2d> corners = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  std::vector<UnidentifiedBearing> bearings;
  for (const Vector2d& l : corners) bearings.push_back({predictBearing({3, 4, 1}, l), {}});
  const Interpretations result = interpretBearings(corners, bearings, optionsFor(0.001));
  ASSERT_EQ(result.solutions.size(), 4u);
  EXPECT_NEAR(result.solutions[0].log_likelihood, result.solutions[3].log_likelihood, 1e-6);
}

TEST(InterpretationTree, CategoriesLeaveOneOfTheFour)
{
  const std::vector<Vector2d> corners = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  std::vector<UnidentifiedBearing> bearings;
  for (const Vector2d& l : corners) bearings.push_back({predictBearing({3, 4, 1}, l), {}});
  bearings[1].candidates = {1};
  const Interpretations result = interpretBearings(corners, bearings, optionsFor(0.001));
  ASSERT_EQ(result.solutions.size(), 1u);
  EXPECT_EQ(result.solutions[0].assignment, (std::vector<int>{0, 1, 2, 3}));
}

TEST(InterpretationTree, AFalseBearingIsLeftOutWhenAllowed)
{
  Sighting s = exactSighting();
  s.bearings.insert(s.bearings.begin() + 1, {0.123, {}});
  s.truth.insert(s.truth.begin() + 1, -1);
  InterpretationOptions options = optionsFor(0.001);
  EXPECT_EQ(interpretBearings(s.scene.landmarks, s.bearings, options).status, SolveStatus::none);
  options.max_unmatched = 1;
  const Interpretations result = interpretBearings(s.scene.landmarks, s.bearings, options);
  ASSERT_EQ(result.solutions.size(), 1u);
  EXPECT_EQ(result.solutions[0].assignment, s.truth);
  EXPECT_EQ(result.solutions[0].matched, 5);
}

TEST(InterpretationTree, PartsOfASolutionAreNotListed)
{
  const Sighting s = exactSighting();
  InterpretationOptions options = optionsFor(0.001);
  options.max_unmatched = 1;
  const Interpretations result = interpretBearings(s.scene.landmarks, s.bearings, options);
  ASSERT_FALSE(result.solutions.empty());
  EXPECT_EQ(result.solutions[0].assignment, s.truth);
  for (std::size_t i = 1; i < result.solutions.size(); ++i)
    EXPECT_LT(result.solutions[i].matched, 5) << "other solutions may only be weaker";
}

TEST(InterpretationTree, RangeLimitRulesOutFarPoses)
{
  const Sighting s = exactSighting();
  InterpretationOptions options = optionsFor(0.001);
  options.max_range = 7.3;  // the farthest seen landmark is at sqrt(4^2 + 6^2) = 7.2 m
  EXPECT_EQ(interpretBearings(s.scene.landmarks, s.bearings, options).solutions.size(), 1u);
  options.max_range = 7.1;
  EXPECT_EQ(interpretBearings(s.scene.landmarks, s.bearings, options).status, SolveStatus::none);
}

TEST(InterpretationTree, ThreeBearingsOnlyOnRequest)
{
  Sighting s = exactSighting();
  s.bearings.resize(3);
  InterpretationOptions options = optionsFor(0.001);
  EXPECT_EQ(interpretBearings(s.scene.landmarks, s.bearings, options).status, SolveStatus::too_few);
  options.allow_three = true;
  const Interpretations result = interpretBearings(s.scene.landmarks, s.bearings, options);
  EXPECT_EQ(assignments(result).count({3, 0, 4}), 1u);
  EXPECT_GT(result.solutions.size(), 1u) << "nothing verifies a triple";
}

TEST(InterpretationTree, GivingUpIsReported)
{
  const Sighting s = exactSighting();
  InterpretationOptions options = optionsFor(0.001);
  options.max_tested = 5;
  EXPECT_FALSE(interpretBearings(s.scene.landmarks, s.bearings, options).finished);
}

TEST(InterpretationTree, BadInputIsRefused)
{
  Sighting s = exactSighting();
  s.bearings[2].candidates = {6};
  EXPECT_EQ(interpretBearings(s.scene.landmarks, s.bearings, optionsFor(0.001)).status, SolveStatus::bad_input);
  s = exactSighting();
  EXPECT_EQ(interpretBearings(s.scene.landmarks, s.bearings, optionsFor(-1)).status, SolveStatus::bad_input);
}

TEST(InterpretationTree, EqualsTryingEveryAssignment)
{
  RandomStream random(31);
  int solutions = 0;
  for (int trial = 0; trial < 60; ++trial)
  {
    const double sigma = degToRad(trial % 2 ? 0.5 : 0.1);
    const Sighting s = look(random, 6 + trial % 2, 4 + trial % 2, 0, sigma);
    const InterpretationOptions options = optionsFor(sigma);
    BruteForce brute{s, options, {}, {}, {}};
    brute.run();
    Assignments found = assignments(interpretBearings(s.scene.landmarks, s.bearings, options));
    for (const std::vector<int>& d : brute.doubtful) found.erase(d);
    EXPECT_EQ(found, brute.found) << "trial " << trial;
    solutions += static_cast<int>(found.size());
  }
  EXPECT_GT(solutions, 60);
}

TEST(InterpretationTree, TurningAndMovingTheWorldChangesNothing)
{
  RandomStream random(32);
  for (int trial = 0; trial < 40; ++trial)
  {
    const Sighting s = look(random, 9, 5, 0, degToRad(0.2));
    InterpretationOptions options = optionsFor(degToRad(0.2));
    options.area.reset();
    options.max_range = 15;
    const Pose2 turn{random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-3, 3)};
    std::vector<Vector2d> moved;
    for (const Vector2d& l : s.scene.landmarks) moved.push_back(transform(turn, l));
    const Interpretations here = interpretBearings(s.scene.landmarks, s.bearings, options);
    const Interpretations there = interpretBearings(moved, s.bearings, options);
    ASSERT_EQ(assignments(here), assignments(there)) << "trial " << trial;
    for (const Interpretation& a : here.solutions)
      for (const Interpretation& b : there.solutions)
        if (a.assignment == b.assignment)
        {
          EXPECT_LT((compose(turn, a.pose.mean).position() - b.pose.mean.position()).norm(), 1e-5);
        }
  }
}

TEST(InterpretationTree, DoesNotLoseTheTruth)
{
  for (const int seen : {4, 5, 6, 7})
    for (const double sigma : {degToRad(0.05), degToRad(0.2), degToRad(0.5)})
      EXPECT_GE(recall(seen, 0, sigma, InterpretationGate::worst_case, 33, 150), 0.98)
          << seen << " bearings, " << sigma;
}

TEST(InterpretationTree, CovarianceGateHasTheRecallOfItsSigmas)
{
  for (const int seen : {4, 5, 7})
    EXPECT_GE(recall(seen, 0, degToRad(0.2), InterpretationGate::covariance, 34, 400), 0.97) << seen << " bearings";
}

TEST(InterpretationTree, DoesNotLoseTheTruthToAFalseBearing)
{
  for (const int seen : {4, 5, 6})
    EXPECT_GE(recall(seen, 1, degToRad(0.2), InterpretationGate::worst_case, 35, 100), 0.98) << seen << " bearings";
}

TEST(InterpretationTree, ThePapersRuleLosesTheTruthOften)
{
  RandomStream random(36);
  int hits = 0;
  for (int trial = 0; trial < 100; ++trial)
  {
    const Sighting s = look(random, 12, 7, 0, degToRad(0.2));
    InterpretationOptions options = optionsFor(degToRad(0.2));
    options.rule = InterpretationRule::paper;
    hits += static_cast<int>(assignments(interpretBearings(s.scene.landmarks, s.bearings, options)).count(s.truth));
  }
  EXPECT_GT(hits, 25);
  EXPECT_LT(hits, 65);  // expected: 0.43 to 0.45
}
}  // namespace mrpt_ext
