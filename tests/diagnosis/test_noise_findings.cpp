#include "mrpt_ext/diagnosis/noise_findings.h"

#include <gtest/gtest.h>

#include "recorded_drive.h"

namespace mrpt_ext::test_noise_findings
{
namespace
{
/// The finding on bearings whose noise is `factor` times the declared one; `uneven`: in the second half twice that;
/// `by_reading`: the declared one is not quite the same for all.
CalibrationFinding bearingNoise(double factor, bool uneven = false, bool by_reading = false)
{
  testing::DrivePlan plan;
  plan.ranges = false;
  plan.duration = 240;
  RandomStream random(4);
  CalibrationData data{.problem = testing::recordedDrive(plan, random), .sensors = {"eye"}, .identified = {true}};
  for (CalibrationReading& r : data.problem.readings)
    r.std /= factor * (uneven && r.pose > data.problem.poses.size() / 2 ? 2 : 1);
  if (by_reading) data.problem.readings.front().std *= 1.01;
  const CalibrationResult errors = calibrate(data.problem, {{CalibrationParameter::distance_scale}});
  EXPECT_EQ(errors.status, SolveStatus::ok);
  for (const CalibrationFinding& finding : noiseFindings(errors, data, {}))
    if (finding.line.key == "std_bearing_deg") return finding;
  throw std::logic_error("no such finding");
}
}  // namespace

TEST(NoiseFindings, NoiseBeyondThreeDeviationsDiffers)
{
  const CalibrationFinding finding = bearingNoise(1.3);
  EXPECT_TRUE(finding.differs) << finding.estimate << " +- " << finding.std;
  EXPECT_NEAR(finding.estimate, 0.7, 4 * finding.std);
  EXPECT_NEAR(finding.configured, 0.7 / 1.3, 1e-6);
}

TEST(NoiseFindings, NoiseAsDeclaredIsConsistent)
{
  const CalibrationFinding finding = bearingNoise(1);
  EXPECT_FALSE(finding.differs) << finding.estimate << " +- " << finding.std;
  EXPECT_LT(finding.std, 0.05 * finding.estimate);
}

TEST(NoiseFindings, NoLineReplacesDeviationsThatAreDeclaredReadingByReading)
{
  const CalibrationFinding finding = bearingNoise(1.3, false, true);
  EXPECT_FALSE(finding.differs);
  EXPECT_EQ(finding.remark.substr(0, 2), "1.");
  EXPECT_TRUE(bearingNoise(1, false, true).remark.empty());
}

TEST(NoiseFindings, NoiseThatChangesIsLessCertain) { EXPECT_GT(bearingNoise(1, true).std, 2 * bearingNoise(1).std); }
}  // namespace mrpt_ext::test_noise_findings
