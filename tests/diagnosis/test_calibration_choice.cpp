#include "mrpt_ext/diagnosis/calibration_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "mrpt_ext/diagnosis/adopted_findings.h"
#include "recorded_choice.h"

namespace mrpt_ext::test_calibration_choice
{
namespace
{
using testing::DrivePlan;
using testing::has;
using testing::recorded;
using Kind = CalibrationParameter;

/// Ranges by radio, for four minutes.
DrivePlan radios()
{
  DrivePlan plan;
  plan.bearings = false;
  plan.duration = 240;
  return plan;
}

std::vector<CalibrationUnknown> unknownsOf(const DrivePlan& plan)
{
  std::vector<CalibrationUnknown> unknowns{
      {Kind::distance_scale}, {Kind::delay}, {Kind::range_offset}, {Kind::range_scale}};
  for (std::size_t i = 0; i < plan.landmarks.size(); ++i) unknowns.push_back({Kind::landmark_offset, 0, i});
  return unknowns;
}

std::vector<CalibrationUnknown> withPlaces(const DrivePlan& plan)
{
  std::vector<CalibrationUnknown> unknowns = unknownsOf(plan);
  for (std::size_t i = 0; i < plan.landmarks.size(); ++i)
    for (const Kind kind : {Kind::landmark_x, Kind::landmark_y}) unknowns.push_back({kind, 0, i});
  return unknowns;
}
}  // namespace

TEST(CalibrationChoice, AConstantOfEveryLandmarkIsNotTakenForACommonOne)
{
  for (int seed = 1; seed <= 3; ++seed)
  {
    DrivePlan plan = radios();
    plan.landmark_offsets = {0.08, -0.06, 0.05, -0.07, 0.02};
    const CalibrationData data = recorded(plan, seed);
    const LocalizationConfig config;
    const CalibrationChoice choice = chooseCalibration(data, unknownsOf(plan), config);
    EXPECT_TRUE(has(choice, Kind::landmark_offset));
    EXPECT_FALSE(has(choice, Kind::range_offset));
    EXPECT_FALSE(has(choice, Kind::range_scale));
    EXPECT_FALSE(has(choice, Kind::distance_scale));
    EXPECT_GT(choice.calibrated, choice.configured);

    const std::vector<CalibrationFinding> adopted = adoptedFindings(choice, data, config);
    const auto line =
        std::find_if(adopted.begin(), adopted.end(),
                     [](const CalibrationFinding& finding) { return finding.line.key == "landmark_bias_range_m"; });
    ASSERT_NE(line, adopted.end());
    EXPECT_EQ(line->line.section, "Sensor_uwb");
    EXPECT_EQ(line->line.value.substr(0, 4), "10:0");
    EXPECT_NE(line->line.value.find(" 11:-0"), std::string::npos) << line->line.value;
    EXPECT_NEAR(line->estimate, 0.06, 0.015);
  }
}

TEST(CalibrationChoice, AnOffsetThatAllLandmarksShareIsAdoptedAsOne)
{
  DrivePlan plan = radios();
  plan.range_offset = 0.3;
  const CalibrationData data = recorded(plan, 1);
  const CalibrationChoice choice = chooseCalibration(data, unknownsOf(plan), {});
  EXPECT_TRUE(has(choice, Kind::range_offset));
  EXPECT_FALSE(has(choice, Kind::landmark_offset));
  EXPECT_EQ(choice.beside.size(), plan.landmarks.size());
  const std::vector<CalibrationFinding> adopted = adoptedFindings(choice, data, {});
  const auto line = std::find_if(adopted.begin(), adopted.end(),
                                 [](const CalibrationFinding& finding) { return finding.line.key == "bias_range_m"; });
  ASSERT_NE(line, adopted.end());
  EXPECT_NEAR(line->estimate, 0.3, 0.03);
  EXPECT_TRUE(std::none_of(adopted.begin(), adopted.end(),
                           [](const CalibrationFinding& finding)
                           { return finding.line.key == "landmark_bias_range_m"; }));
}

// Few ranges to four radios around a room hardly tell an offset from a scale.
TEST(CalibrationChoice, OfOffsetAndScaleOneMayStayAlone)
{
  for (const double offset : {0.0, 0.1})
  {
    DrivePlan plan = radios();
    plan.duration = 30;
    plan.speed = 0.16;
    plan.std_range = 0.4;
    plan.landmarks = {{-6, -5}, {6, -5}, {6, 5}, {-6, 5}};
    plan.range_offset = offset;
    int one = 0, both = 0;
    for (int seed = 1; seed <= 6; ++seed)
    {
      const CalibrationChoice choice = chooseCalibration(recorded(plan, seed), unknownsOf(plan), {});
      const bool has_offset = has(choice, Kind::range_offset), has_scale = has(choice, Kind::range_scale);
      one += has_offset != has_scale;
      both += has_offset && has_scale;
    }
    EXPECT_EQ(one > 0, offset > 0) << offset;
    EXPECT_LE(both, offset > 0 ? 5 : 0) << offset;
  }
}

TEST(CalibrationChoice, OfAMapOnlyTheLandmarkThatStandsElsewhereIsMoved)
{
  for (const double angle : {0.3, 1.6, 2.9})
    for (const double size : {0.0, 0.4})
    {
      const Vector2d shift = size * Vector2d(std::cos(angle), std::sin(angle));
      DrivePlan plan = radios();
      plan.landmark_offsets = {0, 0.3, 0, 0, 0};
      CalibrationData data = recorded(plan, 4);
      for (CalibrationReading& r : data.problem.readings)
        if (r.landmark_number == 3) r.landmark -= shift;
      const CalibrationChoice choice = chooseCalibration(data, withPlaces(plan), {});
      EXPECT_FALSE(has(choice, Kind::range_scale)) << angle;
      EXPECT_FALSE(has(choice, Kind::distance_scale)) << angle;
      for (const CalibrationUnknown& unknown : choice.errors)
        EXPECT_TRUE(!isOfMap(unknown.parameter) || unknown.landmark == 3) << angle;
      EXPECT_EQ(has(choice, Kind::landmark_x), size > 0) << angle;
      for (const CalibrationFinding& finding : adoptedFindings(choice, data, {}))
      {
        const bool along_x = finding.line.key == "landmark_shift_x_m";
        if (!along_x && finding.line.key != "landmark_shift_y_m") continue;
        EXPECT_EQ(finding.line.section, "LocalizationExperiment");
        ASSERT_EQ(finding.line.value.substr(0, 3), "13:");
        EXPECT_NEAR(std::stod(finding.line.value.substr(3)), along_x ? shift.x() : shift.y(), 3 * finding.std);
        EXPECT_LT(finding.std, 0.1);
      }
    }
}

TEST(CalibrationChoice, NoiseOfASensorIsNotHiddenByADefaultOfOdometry)
{
  DrivePlan plan = radios();
  plan.bearings = true;
  plan.ranges = false;
  CalibrationData data = recorded(plan, 1);
  for (CalibrationReading& r : data.problem.readings) r.std /= 1.5;
  for (TrajectoryPose& pose : data.problem.poses)
    if (pose.since_previous)
      for (Matrix3d& covariance : *pose.since_previous) covariance *= square(4.0);
  LocalizationConfig config;
  const std::vector<CalibrationUnknown> unknowns{{Kind::distance_scale}, {Kind::delay}};
  const CalibrationChoice stated = chooseCalibration(data, unknowns, config);
  EXPECT_TRUE(stated.empty() || (!stated.noise.odometry[position_noise] && !stated.noise.odometry[heading_noise]));
  config.odometry_noise_stated = false;
  const CalibrationChoice choice = chooseCalibration(data, unknowns, config);
  ASSERT_FALSE(choice.empty());
  EXPECT_TRUE(choice.noise.bearings[0]);
  EXPECT_TRUE(choice.noise.odometry[position_noise]);
  EXPECT_TRUE(choice.noise.odometry[heading_noise]);
  EXPECT_GT(choice.calibrated, choice.configured);
}

TEST(CalibrationChoice, ADefaultOfOdometryThatIsTooLargeIsLowered)
{
  DrivePlan plan = radios();
  plan.bearings = true;
  CalibrationData data = recorded(plan, 1);
  for (TrajectoryPose& pose : data.problem.poses)
    if (pose.since_previous)
      for (Matrix3d& covariance : *pose.since_previous) covariance *= square(3.0);
  LocalizationConfig config;
  const std::vector<CalibrationUnknown> unknowns{{Kind::distance_scale}, {Kind::delay}};
  EXPECT_TRUE(chooseCalibration(data, unknowns, config).empty()) << "stated noise stands for slips, too";
  config.odometry_noise_stated = false;
  const CalibrationChoice choice = chooseCalibration(data, unknowns, config);
  EXPECT_TRUE(choice.noise.odometry[position_noise]);
  EXPECT_TRUE(choice.noise.odometry[heading_noise]);
  EXPECT_FALSE(choice.noise.bearings[0]);
  for (const CalibrationFinding& finding : adoptedFindings(choice, data, config))
    EXPECT_NEAR(finding.estimate, finding.configured / 3, 0.2 * finding.configured / 3) << finding.what;
}

TEST(CalibrationChoice, NoiseThatNobodyStatedIsLoweredUnlessErrorsLast)
{
  DrivePlan plan = radios();
  plan.outliers = 0;
  plan.std_distance_per_root_s = plan.std_turn_per_root_s = 0.002;
  for (const bool lasts : {false, true})
  {
    CalibrationData data = recorded(plan, 1);
    RandomStream random(2, 3);
    std::vector<double> lasting(plan.landmarks.size(), 0);  // [m] by landmark
    for (CalibrationReading& r : data.problem.readings)
    {
      double& error = lasting[r.landmark_number];
      error += 0.2 * (plan.std_range * random.gaussian() - error);
      if (lasts) r.value += 2 * error;
      r.std *= 2;
    }
    EXPECT_EQ(chooseCalibration(data, {{Kind::distance_scale}}, {}).noise.ranges[0], !lasts);
  }
}

TEST(CalibrationChoice, ATrajectoryThatFollowsTheReadingsDoesNotTellTheirNoise)
{
  DrivePlan plan = radios();
  plan.landmarks_seen = 2;
  plan.std_range = 0.025;
  for (const double outliers : {0.0, 0.2})
    for (const double odometry : {0.02, 0.2})
    {
      plan.outliers = outliers;
      plan.std_distance_per_root_s = plan.std_turn_per_root_s = odometry;
      CalibrationData data = recorded(plan, 1);
      for (CalibrationReading& r : data.problem.readings) r.std *= 2;
      EXPECT_EQ(chooseCalibration(data, {{Kind::distance_scale}}, {}).noise.ranges[0], odometry < 0.1) << outliers;
    }
}

TEST(CalibrationChoice, ThePlaceOfASensorIsAdoptedWithItsRangeOffset)
{
  DrivePlan plan = radios();
  plan.bearings = true;
  plan.landmarks_seen = 5;
  plan.field_of_view = degToRad(70.0);
  plan.range_offset = 0.2;
  for (const double forward : {0.3, 0.06, 0.0})
  {
    plan.lever_arm = {forward, 0};
    const CalibrationData data = recorded(plan, 1);
    const std::vector<CalibrationUnknown> unknowns{
        {Kind::range_offset}, {Kind::range_scale}, {Kind::lever_arm_x}, {Kind::lever_arm_y}};
    const CalibrationChoice choice = chooseCalibration(data, unknowns, {});
    EXPECT_TRUE(has(choice, Kind::range_offset));
    const std::vector<CalibrationFinding> adopted = adoptedFindings(choice, data, {});
    const auto place =
        std::find_if(adopted.begin(), adopted.end(),
                     [](const CalibrationFinding& finding) { return finding.line.key == "lever_arm_x_m"; });
    ASSERT_EQ(place != adopted.end(), forward > 0);
    if (forward > 0)
    {
      EXPECT_NEAR(place->estimate, forward, 4 * place->std);
      EXPECT_EQ(adopted.back().line.key, "lever_arm_std_m");
      EXPECT_NEAR(adopted.back().estimate, std::min(place->estimate / std::sqrt(2.0), 0.05), 1e-9);
    }
  }
}

TEST(CalibrationChoice, ErrorsOfACameraThatCoverForEachOtherAreAdoptedTogether)
{
  DrivePlan plan = testing::cameraDrive();
  plan.range_offset = 0.05;
  plan.range_scale = 0.02;
  CalibrationData data = recorded(plan, 5);
  data.problem = testing::asRanges(std::move(data.problem));
  const std::vector<CalibrationUnknown> unknowns{{Kind::lever_arm_x},   {Kind::lever_arm_y},  {Kind::bearing_offset},
                                                 {Kind::bearing_scale}, {Kind::range_offset}, {Kind::range_scale},
                                                 {Kind::range_axis}};
  const std::vector<CalibrationFinding> adopted = adoptedFindings(chooseCalibration(data, unknowns, {}), data, {});
  std::map<std::string, CalibrationFinding> found;
  for (const CalibrationFinding& finding : adopted) found[finding.line.key] = finding;
  EXPECT_EQ(found.count("lever_arm_x_m") + found.count("lever_arm_y_m"), 0U);
  for (const auto& [key, truth] : std::map<std::string, double>{
           {"scale_bearing", 1.04}, {"bias_range_m", 0.05}, {"scale_range", 1.02}, {"range_axis_deg", -2.3}})
  {
    ASSERT_EQ(found.count(key), 1U) << key;
    EXPECT_NEAR(found[key].estimate, truth, 4 * found[key].std) << key;
  }
}

struct TurnedCamera
{
  double offset_deg = 2;
  bool is_alone = true;  // else another one looks where it is said to
  bool compass = false;
  Vector2d stated_place{0, 0}, lever_arm{0, 0};
};

std::vector<CalibrationFinding> adoptedWith(const TurnedCamera& camera)
{
  DrivePlan plan;
  plan.duration = 240;
  plan.bearing_offset = degToRad(camera.offset_deg);
  plan.lever_arm = camera.stated_place + camera.lever_arm;
  CalibrationData data = recorded(plan, 1);
  data.sensors = {"camera", "other"};
  data.identified = {true, true};
  data.problem.sensors = 2;
  data.compass = camera.compass;
  for (CalibrationReading& r : data.problem.readings)
  {
    r.T_robot_sensor = {camera.stated_place.x() + 1e-15, camera.stated_place.y(), 0};  // odometry moves it by rounding
    if (r.sensor = camera.is_alone ? 0 : r.pose % 2; r.sensor > 0 && !r.is_range)
      r.value = wrap(r.value - plan.bearing_offset);
  }
  std::vector<CalibrationUnknown> unknowns{{Kind::bearing_offset, 0}, {Kind::bearing_offset, 1}};
  if (!camera.lever_arm.isZero()) unknowns = {{Kind::bearing_offset}, {Kind::lever_arm_x}, {Kind::lever_arm_y}};
  LocalizationConfig config;
  config.frames.odometry.yaw = degToRad(1.0);
  config.frames.sensors["camera"].bias_bearing = degToRad(-2.0);
  config.frames.sensors["camera"].scale_bearing = 2;
  return adoptedFindings(chooseCalibration(data, unknowns, config), data, config);
}

std::vector<std::string> linesOf(const std::vector<CalibrationFinding>& findings)
{
  std::vector<std::string> lines;
  for (const CalibrationFinding& finding : findings) lines.push_back(finding.line.section + '.' + finding.line.key);
  return lines;
}

TEST(CalibrationChoice, AnOffsetOfBearingsTurnsOdometryWhereTheSensorIsTheRobot)
{
  const std::vector<CalibrationFinding> adopted = adoptedWith({});
  ASSERT_EQ(linesOf(adopted), (std::vector<std::string>{"MotionModel.odometry_yaw_deg", "Sensor_camera.yaw_std_deg"}));
  EXPECT_NEAR(adopted[0].estimate, 1 + 2, 4 * adopted[0].std);
  EXPECT_NEAR(adopted[1].estimate, (adopted[0].estimate - 1) / std::sqrt(2.0), 1e-9);
}

TEST(CalibrationChoice, ARobotWithAxesOfItsOwnHasATurnedSensor)
{
  const std::vector<std::string> lines{"Sensor_camera.bias_bearing_deg", "Sensor_camera.yaw_std_deg"};
  for (const TurnedCamera& camera :
       {TurnedCamera{.is_alone = false}, {.compass = true}, {.stated_place = {0.4, 0}}, {.offset_deg = 30}})
  {
    const std::vector<CalibrationFinding> adopted = adoptedWith(camera);
    ASSERT_EQ(linesOf(adopted), lines);
    EXPECT_NEAR(adopted[0].estimate, -2 + 2 * camera.offset_deg, 4 * adopted[0].std);
    EXPECT_NEAR(adopted[1].estimate, std::min((adopted[0].estimate + 2) / std::sqrt(2.0), 5.0), 1e-9);
  }
}

TEST(CalibrationChoice, ALeverArmThatIsFoundIsOfARobotWithAxesOfItsOwn)
{
  const std::vector<CalibrationFinding> adopted = adoptedWith({.lever_arm = {0.4, -0.2}});
  ASSERT_EQ(adopted.size(), 5U);
  EXPECT_EQ(adopted[0].line.key, "bias_bearing_deg");
  EXPECT_NEAR(adopted[1].estimate, 0.4, 4 * adopted[1].std);
  EXPECT_NEAR(adopted[2].estimate, -0.2, 4 * adopted[2].std);
}

TEST(CalibrationChoice, NothingIsAdoptedWhereNothingIsWrong)
{
  const DrivePlan plan = radios();
  const CalibrationChoice choice = chooseCalibration(recorded(plan, 2), unknownsOf(plan), {});
  EXPECT_TRUE(choice.errors.empty());
}
}  // namespace mrpt_ext::test_calibration_choice
