#include "mrpt_ext/filter/particle_filter.h"

#include <gtest/gtest.h>

#include <functional>

#include "simulated_run.h"

namespace mrpt_ext::test_particle_filter
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {1, 1, 0}},
                          {.id = 2, .position = {9, 2, 0}},
                          {.id = 3, .position = {5, 9, 0}}});

ParticleFilterOptions smallOptions()
{
  ParticleFilterOptions options;
  options.region = {{0, 0}, {10, 10}};
  options.particles = 1500;
  options.initial_particles = 5000;
  options.motion = motionModelOf({});
  return options;
}

ParticleSet particlesAfter(const ParticleFilterOptions& options, std::uint64_t seed)
{
  SimulatedRobot robot;
  robot.identified = false;
  robot.clutter = 0.05;
  RandomStream random(41);
  ParticleFilter filter(options, kMap, seed, 0);
  Pose2 truth{3, 3, 0};
  for (int k = 0; k < 30; ++k)
  {
    truth = compose(truth, roundTripStep(k));
    filter.process(simulatedFrame(robot, kMap, truth, roundTripStep(k), random), {noProposals});
  }
  return filter.particles();
}

void expectIdentical(const ParticleSet& a, const ParticleSet& b)
{
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.phi, b.phi);
  EXPECT_EQ(a.log_weight, b.log_weight);
}

/// The robot goes straight through a map that half a turn about (5, 5) leaves as it is, and all detections are
/// anonymous.
FilterStep symmetricStep(ParticleFilter& filter, const LandmarkTable& map, Pose2& truth, int k, RandomStream& random)
{
  SimulatedRobot robot;
  robot.identified = false;
  robot.measures_range = true;
  robot.clutter = 0.02;
  robot.detections = map.size();
  robot.std_range = 0.2;
  robot.std_bearing = degToRad(3);
  truth = compose(truth, roundTripStep(k));
  // A solver that finds both poses inexactly, and prefers one of them without reason.
  const Matrix3d covariance = Vector3d(0.01, 0.01, 0.002).asDiagonal();
  const auto propose = [&]() -> HypothesisSet
  {
    return {{.pose = {{truth.x + 0.03, truth.y, truth.phi}, covariance}, .weight = 0.8},
            {.pose = {{10 - truth.x, 10 - truth.y - 0.03, wrap(truth.phi + kPi)}, covariance}, .weight = 0.2}};
  };
  return filter.process(simulatedFrame(robot, map, truth, roundTripStep(k), random), {propose});
}
}  // namespace

TEST(ParticleFilter, SameSeedSameParticlesOnAnyNumberOfThreads)
{
  ParticleFilterOptions options = smallOptions();
  const ParticleSet once = particlesAfter(options, 1);
  expectIdentical(once, particlesAfter(options, 1));
  options.threads = 2;
  expectIdentical(once, particlesAfter(options, 1));
  EXPECT_NE(once.x, particlesAfter(options, 2).x);
}

TEST(ParticleFilter, SymmetricModesStayEqualAndAmbiguous)
{
  const LandmarkTable map(
      {{.position = {1, 2, 0}}, {.position = {9, 8, 0}}, {.position = {3, 8, 0}}, {.position = {7, 2, 0}}});
  ParticleFilterOptions options = smallOptions();
  options.initial_particles = 20000;
  options.particles = 12000;  // what remains of the drift is sampling noise of the evidence of each mode
  ParticleFilter filter(options, map, 5, 0);
  RandomStream random(42);
  Pose2 truth{3, 4, 0.3};
  double smallest = 1;
  for (int k = 0; k < 200; ++k)
  {
    const FilterStep step = symmetricStep(filter, map, truth, k, random);
    ASSERT_EQ(step.verdict, Verdict::ambiguous) << k << " " << step.reason;
    if (k < 10) continue;
    ASSERT_GE(step.modes.modes.size(), 2u) << k;
    const Pose2 mirrored{10 - truth.x, 10 - truth.y, wrap(truth.phi + kPi)};
    for (std::size_t i = 0; i < 2; ++i)
    {
      const Mode& mode = step.modes.modes[i];
      EXPECT_LT(std::min(distance(mode.pose.mean, truth), distance(mode.pose.mean, mirrored)), 0.3) << k;
      smallest = std::min(smallest, mode.weight);
    }
  }
  RecordProperty("smallest_weight", std::to_string(smallest));
  EXPECT_GT(smallest, 0.3);
}

TEST(ParticleFilter, AModeThatIsNotVerifiedFollowsTheTurnsByAnonymousBearings)
{
  RandomStream random(43);
  const LandmarkTable map = randomMap(6, 10, random);
  ParticleFilterOptions options = smallOptions();
  options.motion.std_phi_per_deg = 1.5;
  ParticleFilter filter(options, map, 5, 0);
  SimulatedRobot robot;
  robot.identified = false;
  robot.detections = map.size();
  Pose2 truth{4, 4, 0};
  const auto propose = [&]() -> HypothesisSet {
    return {{.pose = {truth, Vector3d(0.01, 0.01, 0.001).asDiagonal()}, .weight = 1}};
  };
  for (int k = 0; k < 20; ++k)
  {
    const Pose2 turn{0, 0, k < 5 ? 0 : degToRad(4)};
    truth = compose(truth, turn);
    const FilterStep step = filter.process(simulatedFrame(robot, map, truth, turn, random), {propose});
    ASSERT_NE(step.verdict, Verdict::ok) << k;
    if (k < 5) continue;
    const GaussianPose& pose = step.modes.modes.front().pose;
    EXPECT_LT(std::sqrt(pose.covariance(2, 2)), degToRad(2)) << k << " " << step.reason;
    EXPECT_LT(std::abs(wrap(pose.mean.phi - truth.phi)), degToRad(3)) << k;
  }
}

TEST(ParticleFilter, TheRegionLimitsTheStartNotTheDrive)
{
  ParticleFilterOptions options = smallOptions();
  options.initial_mode = InitialMode::gaussian;
  options.initial_pose = {{10, 5, 0}, Vector3d(0.25, 0.25, 0.01).asDiagonal()};
  ParticleFilter filter(options, kMap, 1, 0);
  filter.process({}, {});
  double outside = 0;
  for (std::size_t i = 0; i < filter.particles().size(); ++i)
    outside += filter.particles().pose(i).x > 10 ? std::exp(double{filter.particles().log_weight[i]}) : 0.0;
  EXPECT_NEAR(outside, 0.5, 0.06);
}

TEST(ParticleFilter, AnEmptyMapOrAnEmptyFrameConstrainsNothing)
{
  for (const LandmarkTable& map : {LandmarkTable(), kMap})
  {
    ParticleFilter filter(smallOptions(), map, 1, 0);
    RandomStream random(43);
    for (int k = 0; k < 5; ++k)
    {
      const Frame frame = map.empty() ? simulatedFrame({}, kMap, {3, 3, 0}, {}, random) : Frame{};
      const FilterStep step = filter.process(frame, {});
      EXPECT_EQ(step.verdict, Verdict::ambiguous) << step.reason;
      EXPECT_EQ(step.particles, smallOptions().initial_particles);  // still global localization
      for (const float log_w : filter.particles().log_weight) ASSERT_TRUE(std::isfinite(log_w));
    }
  }
}

TEST(ParticleFilter, OneParticleAndARegionWithoutExtentAreNoError)
{
  ParticleFilterOptions options = smallOptions();
  options.region = {{3, 3}, {3, 3}, 0.0, 0.0};
  options.particles = options.initial_particles = 1;
  ParticleFilter filter(options, kMap, 1, 0);
  RandomStream random(44);
  for (int k = 0; k < 10; ++k)
  {
    const FilterStep step = filter.process(simulatedFrame({}, kMap, {3, 3, 0}, {}, random), {noProposals});
    EXPECT_EQ(step.particles, 1u);
    EXPECT_TRUE(isFinite(step.modes.modes.front().pose.mean));
    EXPECT_NEAR(step.modes.modes.front().weight, 1, 1e-6);
  }
}

TEST(ParticleFilter, ACompassTurnsTheParticles)
{
  ParticleFilter filter(smallOptions(), kMap, 1, 0);
  Frame frame;
  frame.compass = CompassRecord{.heading = 3.1, .std_heading = 0.2};
  FilterStep step;
  for (int k = 0; k < 5; ++k) step = filter.process(frame, {});
  EXPECT_NEAR(std::abs(wrap(step.modes.modes.front().pose.mean.phi - 3.1)), 0, 0.05);
  EXPECT_EQ(step.verdict, Verdict::ambiguous);
}

namespace
{
/// A map with a symmetry of half a turn, and a filter that is given the wrong one of two poses from the start.
/// `trajectory`: hypotheses from the trajectory, given the truth; empty: there are none.
FilterStep stepAtTheTwin(int frames, const std::function<HypothesisSet(const Pose2&)>& trajectory, Pose2& truth)
{
  const LandmarkTable map({{.id = 1, .position = {2, 2, 0}}, {.id = 2, .position = {8, 8, 0}}});
  const Matrix3d covariance = Vector3d(0.01, 0.01, 0.002).asDiagonal();
  ParticleFilter filter(smallOptions(), map, 1, 0);
  RandomStream random(7);
  truth = {5, 2, 0};
  FilterStep step;
  for (int k = 0; k < frames; ++k)
  {
    truth = compose(truth, roundTripStep(k));
    const Pose2 twin{10 - truth.x, 10 - truth.y, wrap(truth.phi + kPi)};
    const auto propose = [&]() -> HypothesisSet { return {{.pose = {twin, covariance}, .weight = 1}}; };
    HypothesisSources sources{propose};
    if (trajectory) sources.trajectory = [&] { return trajectory(truth); };
    const Frame frame = simulatedFrame({.measures_range = true, .identified = false, .clutter = 0.02}, map, truth,
                                       roundTripStep(k), random);
    step = filter.process(frame, sources);
  }
  return step;
}

HypothesisSet hypothesisAt(const Pose2& pose)
{
  return {{.pose = {pose, Vector3d(0.01, 0.01, 0.002).asDiagonal()}, .weight = 0.97}};
}

double weightAt(const FilterStep& step, const Pose2& pose)
{
  double sum = 0;
  for (const Mode& mode : step.modes.modes) sum += distance(mode.pose.mean, pose) < 1 ? mode.weight : 0;
  return sum;
}
}  // namespace

TEST(ParticleFilter, PostponesTheStartUntilOneModeIsLeftOrTheWindowIsFull)
{
  const LandmarkTable twofold({{.id = 1, .position = {2, 2, 0}}, {.id = 2, .position = {8, 8, 0}}});
  const auto particles_after = [](const LandmarkTable& map, bool identified, bool complete)
  {
    ParticleFilter filter(smallOptions(), map, 1, 0);
    RandomStream random(7);
    const Pose2 truth{5, 2, 0}, twin{5, 8, kPi};
    const auto propose = [&]
    {
      HypothesisSet both = hypothesisAt(truth);
      both.push_back(hypothesisAt(twin).front());
      Proposal proposal(both);
      proposal.complete = complete;
      return proposal;
    };
    const SimulatedRobot robot{.measures_range = true, .identified = identified};
    const FilterStep step = filter.process(simulatedFrame(robot, map, truth, {}, random), {propose});
    EXPECT_FALSE(step.modes.modes.empty());
    EXPECT_EQ(step.verdict, Verdict::ambiguous);
    EXPECT_EQ(step.particles, filter.particles().size());
    EXPECT_TRUE(step.modes.mode_of.empty());
    return filter.particles().size();
  };
  EXPECT_EQ(particles_after(twofold, false, false), 0u);
  EXPECT_GT(particles_after(twofold, false, true), 1000u);
  EXPECT_GT(particles_after(kMap, false, false), 1000u) << "one mode only";
  EXPECT_GT(particles_after(twofold, true, false), 1000u) << "identified detections do not wait";
}

TEST(ParticleFilter, TheTrajectoryMovesItToThePoseThatFitsAllMeasurements)
{
  Pose2 truth;
  EXPECT_LT(weightAt(stepAtTheTwin(6, {}, truth), truth), 0.01);
  EXPECT_GT(weightAt(stepAtTheTwin(6, hypothesisAt, truth), truth), 0.05);
}

TEST(ParticleFilter, IsNotOkWhereTheTrajectoryFitsAnotherPoseBetter)
{
  Pose2 truth;
  const FilterStep alone = stepAtTheTwin(60, {}, truth);  // it fits as well as the truth
  EXPECT_EQ(alone.verdict, Verdict::ambiguous);
  EXPECT_NE(alone.reason.find("the map looks alike"), std::string::npos) << alone.reason;
  EXPECT_LT(weightAt(alone, truth), 0.1);
  // The trajectory is searched when the twin is verified.
  const auto late = [calls = 0](const Pose2& pose) mutable
  { return ++calls > 1 ? hypothesisAt(pose) : HypothesisSet{}; };
  for (const int frames : {30, 45, 60})
  {
    const FilterStep step = stepAtTheTwin(frames, late, truth);
    EXPECT_TRUE(step.verdict == Verdict::ambiguous || weightAt(step, truth) > 0.5) << frames << ": " << step.reason;
  }
}

TEST(ParticleFilter, AKnownStartIsNotOverruledByATrajectorySearchThatDoesNotKnowIt)
{
  const LandmarkTable map({{.id = 1, .position = {2, 2, 0}}, {.id = 2, .position = {8, 8, 0}}});
  ParticleFilterOptions options = smallOptions();
  options.initial_mode = InitialMode::gaussian;
  options.initial_pose = {{5, 2, 0}, Vector3d(0.01, 0.01, 0.002).asDiagonal()};
  ParticleFilter filter(options, map, 1, 0);
  RandomStream random(7);
  Pose2 truth{5, 2, 0};
  FilterStep step;
  for (int k = 0; k < 60; ++k)
  {
    truth = compose(truth, roundTripStep(k));
    const auto twin = [&] { return hypothesisAt({10 - truth.x, 10 - truth.y, wrap(truth.phi + kPi)}); };
    const Frame frame = simulatedFrame({.measures_range = true, .identified = false, .clutter = 0.02}, map, truth,
                                       roundTripStep(k), random);
    step = filter.process(frame, {noProposals, twin});
    EXPECT_GT(weightAt(step, truth), 0.9) << k;
  }
  EXPECT_EQ(step.verdict, Verdict::ok) << step.reason;
}
}  // namespace mrpt_ext::test_particle_filter
