#include "mrpt_ext/filter/integrity/filter_diagnostics.h"

#include <gtest/gtest.h>

#include "simulated_run.h"

namespace mrpt_ext::test_filter_diagnostics
{
TEST(FilterDiagnostics, OnlyTheFaultyBeaconIsReported)
{
  SimulatedRobot robot;
  robot.measures_range = true;
  robot.clutter = 0.02;
  robot.detections = 4;
  RandomStream random(51);
  const LandmarkTable map = randomMap(6, 10, random);
  ParticleFilterOptions options;
  options.region = {{0, 0}, {10, 10}};
  options.initial_mode = InitialMode::gaussian;
  options.initial_pose = {{8, 5, kPi / 2}, Vector3d(0.01, 0.01, 0.001).asDiagonal()};
  options.motion = motionModelOf(robot);
  options.particles = 500;
  ParticleFilter filter(options, map, 1, 0);
  Pose2 truth{8, 5, kPi / 2};
  FilterStep step;
  for (int k = 0; k < 120; ++k)
  {
    if (k > 0) truth = compose(truth, roundTripStep(k));
    Frame frame = simulatedFrame(robot, map, truth, k > 0 ? roundTripStep(k) : Pose2{}, random);
    for (Detection& detection : frame.readings[0].detections)
      if (detection.id == 3) detection.range = random.uniform(0, 12);
    step = filter.process(frame, {noProposals});
  }
  EXPECT_LT(distance(step.modes.modes.front().pose.mean, truth), 0.2);
  EXPECT_EQ(outlierLandmarks(filter.reliability().histories()), std::vector<std::size_t>{2});
  EXPECT_NE(step.reason.find("landmark 3: "), std::string::npos) << step.reason;
}

TEST(FilterDiagnostics, ALandmarkIsReportedWithSignificantlyMoreThan30PercentOutliers)
{
  const auto is_reported = [](double identified, double false_identified)
  { return !outlierLandmarks({{.identified = identified, .false_identified = false_identified}}).empty(); };
  EXPECT_TRUE(is_reported(1000, 350));
  EXPECT_FALSE(is_reported(1000, 250));
  EXPECT_FALSE(is_reported(20, 7)) << "chance, where a fifth is false";
  EXPECT_TRUE(is_reported(20, 12));
  EXPECT_FALSE(is_reported(3, 3));
  EXPECT_FALSE(is_reported(0, 0));
}

TEST(FilterDiagnostics, LandmarksAreReportedByTheirIds)
{
  const LandmarkTable map({{.id = 7, .position = {0, 0, 0}}, {.id = 8, .position = {1, 0, 0}}});
  const std::vector<LandmarkHistory> histories{{.identified = 100, .false_identified = 40.2},
                                               {.identified = 100, .false_identified = 10}};
  EXPECT_EQ(outlierText(map, histories), "landmark 7: 40 % of 100 detections are outliers");
}

TEST(FilterDiagnostics, AtMostFiveLandmarksAreNamed)
{
  std::vector<Landmark> landmarks;
  for (int id = 1; id <= 8; ++id) landmarks.push_back({.id = id, .position = {1.0 * id, 0, 0}});
  const std::string text = outlierText(LandmarkTable(std::move(landmarks)),
                                       std::vector<LandmarkHistory>(8, {.identified = 100, .false_identified = 90}));
  EXPECT_NE(text.find("landmark 5: "), std::string::npos) << text;
  EXPECT_EQ(text.find("landmark 6: "), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with(", and so for 3 more landmarks")) << text;
}

TEST(FilterDiagnostics, SystematicErrorsHaveTheirUnits)
{
  const BiasModel biases{{.kind = BiasKind::range_offset, .sensor = "uwb"}, {.kind = BiasKind::bearing_offset}};
  ParticleSet particles(Vector2d(0, 0), biases);
  for (const double sign : {-1.0, 1.0})
  {
    particles.add({0, 0, 0}, std::log(0.5));
    particles.bias[0].back() = static_cast<float>(0.2 + 0.05 * sign);
    particles.bias[1].back() = static_cast<float>(degToRad(3.0));
  }
  const std::vector<BiasEstimate> estimates = estimateBiases(particles);
  ASSERT_EQ(estimates.size(), 2U);
  EXPECT_NEAR(estimates[0].mean, 0.2, 1e-6);
  EXPECT_NEAR(estimates[0].std, 0.05, 1e-6);
  EXPECT_EQ(biasText(biases, estimates).substr(0, 43), "uwb range_offset 0.2000 m (std 0.0500), bea");
  EXPECT_TRUE(biasText({}, {}).empty());
  EXPECT_EQ(biasName(biases[0]), "uwb.range_offset_m");
  EXPECT_EQ(biasName(biases[1]), "bearing_offset_deg");
}
}  // namespace mrpt_ext::test_filter_diagnostics
