#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "movis_measurements.h"
#include "movis_run.h"
#include "mrpt_ext/solvers/object_position.h"
#include "mrpt_ext/solvers/origin_correction.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/pose_ml.h"
#include "scratch_folder.h"

// From rendered images of the three omnidirectional cameras to azimuths (ini/images2rawlog/movis.ini) and poses
// (ini/landmark-localization/movis.ini, movis-frames.ini); the truth comes with the images.
namespace mrpt_ext::test_movis_run
{
namespace
{
namespace fs = std::filesystem;
using testing::kOwnScene;
using testing::measure;
using testing::Measured;
using testing::MovisScene;
using testing::MovisSights;
using testing::ScratchFolder;

constexpr int kOriginFrame = 10;  // of the shared scenes: point K, the origin

/// How the azimuths compare with observations.csv. `yaw` holds what M1, M2, M3 are turned by [deg].
struct AzimuthScore
{
  int unblocked = 0, found = 0, gross = 0;
  double squares = 0;
  [[nodiscard]] double foundShare() const { return static_cast<double>(found) / unblocked; }
  [[nodiscard]] double rms() const { return std::sqrt(squares / found); }
};

const testing::MovisSight* sightOf(const MovisSights& sights, int frame, const std::string& label, int camera)
{
  const auto by_label = sights.find(frame);
  if (by_label == sights.end() || by_label->second.count(label) == 0) return nullptr;
  for (const auto& sight : by_label->second.at(label))
    if (sight.camera == camera) return &sight;
  return nullptr;
}

AzimuthScore scoreOf(const fs::path& scene, const MovisSights& sights, const std::array<double, 3>& yaw = {})
{
  constexpr double kHiddenByBody = 0.05;  // share of an object from which on its middle is no longer seen
  const TextTable table(scene / "observations.csv", {});
  const auto number = [&](std::size_t row, const char* name) { return table.number(row, table.column(name)); };
  AzimuthScore score;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    if (number(row, "blocked_by_own_mirror") + number(row, "blocked_by_robot") > 0) continue;
    if (number(row, "hidden_by_body") > kHiddenByBody) continue;
    ++score.unblocked;
    const int camera = table.integer(row, table.column("camera"));
    const auto* sight =
        sightOf(sights, table.integer(row, table.column("frame")), table.text(row, table.column("object")), camera);
    if (!sight) continue;
    const double slant = movisCamera(camera, 1)->slantFromTheta(
        degToRad(number(row, "theta_deg") - yaw[static_cast<std::size_t>(camera - 1)]));
    const double error = radToDeg(wrap(sight->ray.angle - forwardBearingFromSlant(slant)));
    ++score.found;
    if (std::abs(error) > 0.5) ++score.gross;
    score.squares += error * error;
  }
  return score;
}

double meanOf(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Distances of the triangulated ball from its true position, in the robot's frame [m].
std::vector<double> ballErrors(const MovisScene& scene, const MovisSights& sights)
{
  std::vector<double> errors;
  for (const auto& [frame, by_label] : sights)
    if (by_label.count("ball") > 0)
      if (const auto seen = testing::bestMeeting(by_label.at("ball")))
        errors.push_back((*seen - scene.frames.at(frame).ball_in_robot).norm());
  return errors;
}

std::vector<PoseMeasurement> poleBearings(const MovisScene& scene, const MovisSights::mapped_type& by_label)
{
  std::vector<PoseMeasurement> measurements;
  for (const auto& [label, x] : {std::pair{"p", -scene.field.half_width}, std::pair{"q", scene.field.half_width}})
    if (by_label.count(label) > 0)
      for (const auto& sight : by_label.at(label))
        measurements.push_back({PoseMeasurement::Kind::bearing,
                                {x, scene.field.depth},
                                sight.ray.angle,
                                sight.ray.std_angle,
                                {sight.ray.origin.x(), sight.ray.origin.y(), 0}});
  return measurements;
}

/// Position errors of the most likely poses with known heading [m].
std::vector<double> poseErrorsWithHeading(const MovisScene& scene, const MovisSights& sights)
{
  std::vector<double> errors;
  for (const auto& [frame, by_label] : sights)
  {
    const Pose2 truth = scene.frames.at(frame).robot;
    auto measurements = poleBearings(scene, by_label);
    measurements.push_back({PoseMeasurement::Kind::heading, {0, 0}, truth.phi, degToRad(0.001), {}});
    const PoseMl pose = refinePose(measurements, truth);
    if (pose.status == SolveStatus::ok) errors.push_back((pose.pose.mean.position() - truth.position()).norm());
  }
  return errors;
}

/// Median and mean position error of the poses from single frames, by the program.
nlohmann::json posesOfFrames(const Measured& measured, const fs::path& folder)
{
  const auto run = testing::localized(folder, "movis-frames", measured.files.arguments());
  return testing::summaryOf(run);
}

/// The limit of the root mean square position error at azimuths with the standard deviation `std` [rad].
double boundAt(const MovisScene& scene, const MovisSights& sights, double std)
{
  double sum = 0;
  for (const auto& [frame, by_label] : sights)
  {
    auto measurements = poleBearings(scene, by_label);
    for (PoseMeasurement& m : measurements) m.std = std;
    const auto covariance = covarianceFromInformation(poseInformation(measurements, scene.frames.at(frame).robot));
    if (covariance) sum += (*covariance)(0, 0) + (*covariance)(1, 1);
  }
  return std::sqrt(sum / static_cast<double>(sights.size()));
}

// The paper's method: poles triangulated, eq 3-7 for the pose, eq 9-10 for the ball, with or without eq 8.
struct PaperErrors
{
  double pose = 0, ball = 0;  ///< means [m], ball in the field
};

std::optional<Vector2d> inMovis(const MovisSights::mapped_type& by_label, const std::string& label)
{
  if (by_label.count(label) == 0) return std::nullopt;
  const auto point = testing::bestMeeting(by_label.at(label));
  if (!point) return std::nullopt;
  return movisFromRobot(*point);
}

PaperErrors paperErrors(const MovisScene& scene, const MovisSights& sights, const OriginCorrection& correction)
{
  std::vector<double> poses, balls;
  for (const auto& [frame, by_label] : sights)
  {
    const auto p = inMovis(by_label, "p"), q = inMovis(by_label, "q"), ball = inMovis(by_label, "ball");
    if (!p || !q || !ball) continue;
    const TwoPolePose solved =
        solveTwoPolePose(correctLeftPole(correction, *p), correctRightPole(correction, *q), scene.field);
    if (solved.status != SolveStatus::ok) continue;
    const Pose2 robot = robotPose(solved);
    poses.push_back((robot.position() - scene.frames.at(frame).robot.position()).norm());
    const GaussianPoint in_field = objectPosition({robot, Matrix3d::Zero()}, {robotFromMovis(*ball), {}});
    balls.push_back((in_field.mean - scene.ball).norm());
  }
  return {meanOf(poses), meanOf(balls)};
}

OriginCorrection correctionAtOrigin(const MovisScene& scene, const MovisSights& sights)
{
  const auto& at_origin = sights.at(kOriginFrame);
  return calibrateAtOrigin(*inMovis(at_origin, "p"), *inMovis(at_origin, "q"), scene.field);
}
}  // namespace

TEST(MovisRun, OwnImagesGiveAzimuths)
{
  const ScratchFolder folder;
  const Measured measured = measure(kOwnScene, folder.path());
  const MovisScene scene(kOwnScene);
  // The cameras of this drive are turned by these angles.
  const AzimuthScore score =
      scoreOf(kOwnScene, testing::readMovisSights(measured.csv, scene.mount_radius), {0.5, -0.4, 0.3});
  EXPECT_GE(score.foundShare(), 0.99);
  EXPECT_EQ(score.gross, 0);
  EXPECT_LE(score.rms(), 0.06);
}

TEST(MovisRun, TheFilterFindsTheAnglesOfTheCamerasOnADrive)
{
  const ScratchFolder folder;
  const Measured measured = measure(kOwnScene, folder.path());
  for (const std::string seed : {"1", "2", "3"})
  {
    const auto run =
        testing::localized(folder.path(), "movis", testing::joined(measured.files.arguments(), {"--seed", seed}));
    const auto filter = testing::summaryOf(run).at("methods").at("particle_filter");
    EXPECT_LE(filter.at("position_error_m").at("median"), 0.05) << seed;
    EXPECT_LE(filter.at("heading_error_deg").at("median"), 0.6) << seed;
    EXPECT_EQ(testing::summaryOf(run).at("verdict"), "ok") << seed;
    const TextTable objects(run / "objects.csv", {});
    EXPECT_GT(objects.size(), 15u);
    EXPECT_EQ(objects.text(0, objects.column("label")), "ball");
    // Once the angles are known, the ball in the field is where calibrated cameras would see it.
    const Vector2d ball = MovisScene(kOwnScene).ball;
    std::vector<double> errors;
    for (std::size_t row = objects.size() / 2; row < objects.size(); ++row)
      errors.push_back(
          (Vector2d(objects.number(row, objects.column("x")), objects.number(row, objects.column("y"))) - ball).norm());
    EXPECT_LE(meanOf(errors), 0.02) << seed;
  }
}

TEST(MovisRun, ACalibrationFrameStraightensTheCameras)
{
  const ScratchFolder folder;
  const Measured turned = measure(kOwnScene, folder.path());
  const double before = posesOfFrames(turned, folder.path())
                            .at("methods")
                            .at("bearing_maximum_likelihood")
                            .at("position_error_m")
                            .at("mean");
  const Measured straight = measure(kOwnScene, folder.path(), {"--set", "Movis.calibration_frame=6"});
  EXPECT_NE(straight.outcome.out.find("M2: turned by -0.3"), std::string::npos) << straight.outcome.out;
  EXPECT_EQ(straight.outcome.out.find("deviation 0.000"), std::string::npos) << straight.outcome.out;
  const double after = posesOfFrames(straight, folder.path())
                           .at("methods")
                           .at("bearing_maximum_likelihood")
                           .at("position_error_m")
                           .at("mean");
  EXPECT_GT(before, 0.1);
  EXPECT_LT(after, 0.03);
}

TEST(MovisRun, ACalibrationThatDoesNotFitIsRefused)
{
  const ScratchFolder folder;
  // Poles that stand elsewhere, as when something else is taken for them.
  const auto outcome = testing::runImages({testing::shipped("images2rawlog", "movis").string(), "-i",
                                           kOwnScene.string(), "-o", (folder.path() / "log.rawlog").string(), "--set",
                                           "Movis.calibration_frame=6", "--set", "Movis.field_half_width_m=2"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.find("turned by"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("M1: not calibrated, its sightings of poles differ by up to"), std::string::npos)
      << outcome.err;
}

TEST(MovisRun, SharedImagesGiveAzimuthsBallAndPoses)
{
  const auto folder_of_scene = testing::sharedScene("samples/B_paper");
  if (!folder_of_scene) GTEST_SKIP() << "the shared scenes are absent";
  const ScratchFolder folder;
  const Measured measured = measure(*folder_of_scene, folder.path());
  const MovisScene scene(*folder_of_scene);
  const MovisSights sights = testing::readMovisSights(measured.csv, scene.mount_radius);
  const AzimuthScore score = scoreOf(*folder_of_scene, sights);
  EXPECT_GE(score.foundShare(), 0.99);
  EXPECT_LE(score.rms(), 0.06);
  const auto balls = ballErrors(scene, sights);
  EXPECT_EQ(balls.size(), 13u);
  EXPECT_LE(meanOf(balls), 0.012);
  const auto poses = poseErrorsWithHeading(scene, sights);
  EXPECT_EQ(poses.size(), 13u);
  EXPECT_LE(meanOf(poses), 0.010);
  const auto method = posesOfFrames(measured, folder.path()).at("methods").at("bearing_maximum_likelihood");
  EXPECT_EQ(method.at("availability"), 1.0);
  EXPECT_LE(method.at("position_error_m").at("rmse"), 1.1 * boundAt(scene, sights, degToRad(score.rms())));
  std::printf("azimuth rms %.4f deg, found %.1f %%, ball %.2f cm, pose with heading %.2f cm, without %.2f cm\n",
              score.rms(), 100 * score.foundShare(), 100 * meanOf(balls), 100 * meanOf(poses),
              100 * method.at("position_error_m").at("rmse").get<double>());
}

TEST(MovisRun, TurnedCamerasRawCorrectedAtTheOriginAndCalibrated)
{
  const auto folder_of_scene = testing::sharedScene("samples/B_paper_yawerr");
  if (!folder_of_scene) GTEST_SKIP() << "the shared scenes are absent";
  const ScratchFolder folder;
  const MovisScene scene(*folder_of_scene);
  const auto sightsOf = [&](const testing::Arguments& more)
  { return testing::readMovisSights(measure(*folder_of_scene, folder.path(), more).csv, scene.mount_radius); };
  const MovisSights raw = sightsOf({});
  const MovisSights straight = sightsOf({"--set", "Movis.calibration_frame=" + std::to_string(kOriginFrame)});
  const PaperErrors errors[] = {paperErrors(scene, raw, {}), paperErrors(scene, raw, correctionAtOrigin(scene, raw)),
                                paperErrors(scene, straight, {})};
  const double balls[] = {meanOf(ballErrors(scene, raw)), meanOf(ballErrors(scene, straight))};
  std::printf(
      "raw, eq 8, calibrated: pose %.1f %.1f %.1f cm, ball in the field %.1f %.1f %.1f cm; ball from the robot "
      "%.1f, calibrated %.2f cm\n",
      100 * errors[0].pose, 100 * errors[1].pose, 100 * errors[2].pose, 100 * errors[0].ball, 100 * errors[1].ball,
      100 * errors[2].ball, 100 * balls[0], 100 * balls[1]);
  EXPECT_LE(balls[1], 0.015);
  EXPECT_LT(errors[1].pose, errors[0].pose);
  EXPECT_LT(errors[2].pose, errors[1].pose);
}
}  // namespace mrpt_ext::test_movis_run
