#include "mrpt_ext/filter/kalman_bank.h"

#include <gtest/gtest.h>

#include "simulated_run.h"

namespace mrpt_ext::test_kalman_bank
{
namespace
{
Matrix3d diagonal(double xy, double phi) { return Vector3d(xy * xy, xy * xy, phi * phi).asDiagonal(); }

KalmanBankOptions optionsFor(const SimulatedRobot& robot, std::size_t hypotheses)
{
  return {.max_hypotheses = hypotheses, .motion = motionModelOf(robot)};
}

PoseHypothesis proposalAt(const Pose2& pose, double log_score)
{
  return {.pose = {pose, diagonal(0.1, 0.03)}, .log_score = log_score};
}

/// A robot that drives in a circle, and its simulated frames.
class RoundTrip
{
 public:
  RoundTrip(const SimulatedRobot& robot, std::uint64_t run)
      : robot_(robot), random_(37, run), map(randomMap(10, 10, random_))
  {
  }

  Frame next()
  {
    const Pose2 increment = step_ > 0 ? roundTripStep(step_) : Pose2{};
    ++step_;
    truth = compose(truth, increment);
    return simulatedFrame(robot_, map, truth, increment, random_);
  }

 private:
  SimulatedRobot robot_;
  RandomStream random_;
  int step_ = 0;

 public:
  LandmarkTable map;
  Pose2 truth{8, 5, kPi / 2};
};
}  // namespace

TEST(KalmanBank, IsLostWithoutProposals)
{
  RoundTrip trip({}, 1);
  KalmanBank bank(optionsFor({}, 10), trip.map);
  const KalmanStep step = bank.process(trip.next(), noProposals);
  EXPECT_TRUE(step.modes.modes.empty());
  EXPECT_EQ(step.verdict, Verdict::lost);
}

TEST(KalmanBank, IsAmbiguousUntilTheEvidenceDecidesBetweenTwoHypotheses)
{
  for (std::uint64_t run = 0; run < 10; ++run)
  {
    const SimulatedRobot robot{.clutter = 0.05};
    RoundTrip trip(robot, run);
    KalmanBank bank(optionsFor(robot, 10), trip.map);
    const Frame first = trip.next();
    const Pose2 wrong{2, 3, 1};
    const auto propose = [&] { return Proposal({proposalAt(wrong, 0), proposalAt(trip.truth, 0)}); };
    KalmanStep step = bank.process(first, propose);
    EXPECT_EQ(step.modes.modes.size(), 2u);
    EXPECT_EQ(step.verdict, Verdict::ambiguous);
    for (int k = 0; k < 20; ++k) step = bank.process(trip.next(), propose);
    EXPECT_LT(distance(step.modes.modes.front().pose.mean, trip.truth), 0.3);
    EXPECT_GT(step.modes.modes.front().weight, 0.99);
    EXPECT_EQ(step.verdict, Verdict::ok) << step.reason;
  }
}

TEST(KalmanBank, ManyHypothesesThatFitAllDetectionsAreAmbiguousNotLost)
{
  // One landmark seen with range and bearing: the robot is anywhere on a ring.
  const LandmarkTable map({{.id = 1, .position = {0, 0, 0}}});
  const SimulatedRobot robot{.measures_range = true, .detections = 1, .clutter = 0.05};
  RandomStream random(43);
  const Pose2 truth{3, 0, kPi};
  KalmanBank bank(optionsFor(robot, 50), map);
  const auto propose = [&]
  {
    HypothesisSet ring;
    for (int k = 0; k < 20; ++k) ring.push_back(proposalAt(compose({0, 0, k * kTwoPi / 20}, truth), 0));
    return Proposal(ring);
  };
  KalmanStep step;
  for (int k = 0; k < 10; ++k) step = bank.process(simulatedFrame(robot, map, truth, {}, random), propose);
  EXPECT_GT(step.modes.modes.size(), 10u);
  EXPECT_LT(step.modes.modes.front().weight, 0.1);
  EXPECT_EQ(step.verdict, Verdict::ambiguous) << step.reason;
}

// Ranges alone give a position without heading.
TEST(KalmanBank, AProposalWithUnknownHeadingBecomesOneFilterPerSector)
{
  RoundTrip trip({}, 4);
  const auto proposal = [&] {
    return HypothesisSet{{.pose = {{trip.truth.x, trip.truth.y, 0}, diagonal(0.1, 0)}, .heading_known = false}};
  };
  KalmanBank bank(optionsFor({}, 50), trip.map);
  KalmanStep step = bank.process({}, proposal);
  std::vector<double> share(12);
  for (const Mode& mode : step.modes.modes)
    share[static_cast<std::size_t>((mode.pose.mean.phi + kPi) / kTwoPi * 12) % 12] += mode.weight;
  for (const double weight : share) EXPECT_NEAR(weight, 1.0 / 12, 0.04);
  EXPECT_EQ(step.verdict, Verdict::ambiguous);
  for (int k = 0; k < 5; ++k) step = bank.process(trip.next(), noProposals);
  EXPECT_LT(std::abs(wrap(step.modes.modes.front().pose.mean.phi - trip.truth.phi)), degToRad(5));
  EXPECT_GT(step.modes.modes.front().weight, 0.9);
}

TEST(KalmanBank, MergesDuplicateHypothesesAndAddsTheirWeights)
{
  RoundTrip trip({}, 3);
  KalmanBank bank(optionsFor({}, 10), trip.map);
  const Pose2 aside = compose(trip.truth, {0.25, 0, 0});
  const auto propose = [&] { return Proposal({proposalAt(trip.truth, 0), proposalAt(aside, 0)}); };
  KalmanStep step = bank.process(trip.next(), propose);
  for (int k = 0; k < 10; ++k) step = bank.process(trip.next(), propose);
  EXPECT_EQ(step.modes.modes.size(), 1u);
  EXPECT_NEAR(step.modes.modes.front().weight, 1, 1e-9);
}

TEST(KalmanBank, HypothesesInASymmetricMapKeepEqualWeights)
{
  // Anonymous landmarks at the corners of a rectangle: after half a turn about its centre, the map is the same.
  const LandmarkTable map(
      {{.position = {-3, -2, 0}}, {.position = {3, -2, 0}}, {.position = {3, 2, 0}}, {.position = {-3, 2, 0}}});
  const SimulatedRobot robot{.measures_range = true, .identified = false, .detections = 4, .clutter = 0.02};
  KalmanBank bank(optionsFor(robot, 10), map);
  RandomStream random(41);
  Pose2 truth{1, 0.5, 0.3};
  const auto propose = [&] { return Proposal({proposalAt(truth, 0), proposalAt(compose({0, 0, kPi}, truth), 0)}); };
  KalmanStep step;
  for (int k = 0; k < 100; ++k)
  {
    const Pose2 increment = k > 0 ? Pose2{0.02, 0, 0.02} : Pose2{};
    truth = compose(truth, increment);
    step = bank.process(simulatedFrame(robot, map, truth, increment, random), propose);
    ASSERT_EQ(step.modes.modes.size(), 2u);
    EXPECT_NEAR(step.modes.modes.front().weight, 0.5, 1e-3);
    EXPECT_EQ(step.verdict, Verdict::ambiguous);
  }
}

TEST(KalmanBank, RecoversFromAKidnapping)
{
  for (const std::size_t hypotheses : {std::size_t{1}, std::size_t{20}})
  {
    const SimulatedRobot robot{.clutter = 0.05};
    RoundTrip trip(robot, 5);
    KalmanBankOptions options = optionsFor(robot, hypotheses);
    options.start = GaussianPose{trip.truth, diagonal(0.1, 0.03)};
    KalmanBank bank(options, trip.map);
    const auto propose = [&] { return Proposal({proposalAt(trip.truth, 0), proposalAt({1, 1, 1}, -1)}); };
    KalmanStep step;
    for (int k = 0; k < 20; ++k) step = bank.process(trip.next(), propose);
    EXPECT_EQ(step.verdict, Verdict::ok) << step.reason;
    trip.truth = {3, 6, -1};
    bool restarted = false, detected = false;
    for (int k = 0; k < 30; ++k)
    {
      step = bank.process(trip.next(), propose);
      restarted = restarted || step.restarted;
      detected = detected || step.verdict != Verdict::ok;
    }
    EXPECT_TRUE(restarted);
    EXPECT_TRUE(detected);
    EXPECT_LT(distance(step.modes.modes.front().pose.mean, trip.truth), 0.3);
    EXPECT_EQ(step.verdict, Verdict::ok) << step.reason;
  }
}

TEST(KalmanBank, ASingleFilterWaitsForADominantProposalOrAFullWindow)
{
  RoundTrip trip({}, 7);
  KalmanBank bank(optionsFor({}, 1), trip.map);
  bool complete = false;
  const auto propose = [&]
  {
    Proposal proposal({proposalAt(trip.truth, 0.5), proposalAt({2, 3, 1}, 0)});
    proposal.complete = complete;
    return proposal;
  };
  EXPECT_TRUE(bank.process(trip.next(), propose).modes.modes.empty());
  complete = true;
  const KalmanStep step = bank.process(trip.next(), propose);
  ASSERT_EQ(step.modes.modes.size(), 1u);
  EXPECT_LT(distance(step.modes.modes.front().pose.mean, trip.truth), 0.5);
  EXPECT_NE(step.verdict, Verdict::ok) << "too few detections so far";
}
}  // namespace mrpt_ext::test_kalman_bank
