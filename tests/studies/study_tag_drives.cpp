#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <opencv2/imgproc.hpp>

#include "filter_scenario.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/evaluation/error_statistics.h"
#include "mrpt_ext/filter/kalman/measurement_linearization.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/likelihood/facing_likelihood.h"
#include "mrpt_ext/vision/tags/tag_measurement.h"
#include "posterior_bounds.h"
#include "study.h"
#include "tag_picture.h"

namespace mrpt_ext
{
namespace
{
constexpr double kLength = 8, kWidth = 6, kFrameInterval = 0.4, kStdCorner = 0.5;
constexpr int kFrames = 36;
constexpr double kTransient = 2;      // [s]
constexpr double kSmallestTag = 14;   // [px] that a detector finds
constexpr double kNotFound = -1;      // [s]
constexpr double kWrongPlace = 0.5;   // [m] and
constexpr double kWrongHeading = 15;  // [deg] at which an `ok` is wrong

/// What the camera reports of the tags in view.
struct TagSeries
{
  std::string name;
  bool facings = true;     ///< which way they face
  std::size_t most = 100;  ///< tags of a frame, the largest
};

PinholeCamera hallCamera()
{
  PinholeCamera camera = testing::wallCamera();
  camera.k1 = -0.21, camera.k2 = 0.06;
  return camera;
}

/// Four tags of 20 cm on each wall, facing inwards.
LandmarkTable hallOfTags(RandomStream& random)
{
  std::vector<Landmark> tags;
  for (int i = 0; i < 16; ++i)
  {
    const double along = (i / 4 + 0.2 + 0.6 * random.uniform()) / 4, height = 0.8 + 0.6 * random.uniform();
    const double x = i % 2 == 0 ? kLength * along : i % 4 == 1 ? 0 : kLength;
    const double y = i % 2 == 1 ? kWidth * along : i % 4 == 0 ? 0 : kWidth;
    const double yaw = i % 2 == 0 ? (y > 0 ? -kPi / 2 : kPi / 2) : (x > 0 ? kPi : 0);
    tags.push_back({.id = i, .position = {x, y, height}, .category = "tag", .yaw = yaw});
  }
  return LandmarkTable(tags);
}

/// An oval, from anywhere on it, either way.
Pose2 poseAt(int frame, double phase, double sense, double radius)
{
  const double a = phase + sense * 0.17 * frame, b = 0.6 * radius;
  const double heading = std::atan2(sense * b * std::cos(a), -sense * radius * std::sin(a));
  return {kLength / 2 + radius * std::cos(a), kWidth / 2 + b * std::sin(a), heading};
}

/// The tag as the camera sees it, its corners shaken; nothing when it is not wholly in the image, or too small.
std::optional<Detection> seenTag(const Landmark& tag, const Pose2& camera_pose, double camera_height,
                                 const PinholeCamera& camera, RandomStream& random, double& size)
{
  const double bearing = predictBearing(camera_pose, tag.position.head<2>());
  const testing::PlacedTag placed{.range = predictRange(camera_pose, tag.position.head<2>()),
                                  .bearing = bearing,
                                  .above = tag.position.z() - camera_height,
                                  .turned = wrap(*tag.yaw - camera_pose.phi - bearing - kPi)};
  if (placed.range < 0.6 || std::abs(bearing) > 0.62 || std::abs(placed.turned) > degToRad(80)) return std::nullopt;
  TagCorners corners = placed.corners(camera);
  std::vector<cv::Point2f> outline;
  for (Eigen::Vector2d& corner : corners)
  {
    if (corner.x() < 8 || corner.y() < 8 || corner.x() > 631 || corner.y() > 471) return std::nullopt;
    outline.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()));
    const double u = random.gaussian(), v = random.gaussian();
    corner += kStdCorner * Eigen::Vector2d(u, v);
  }
  size = std::sqrt(cv::contourArea(outline));
  if (size < kSmallestTag) return std::nullopt;
  const auto measured = measureTag(corners, placed.edge, camera, {.std_corner = kStdCorner});
  if (!measured || measured->residual > 25) return std::nullopt;
  return Detection{.id = tag.id,
                   .bearing = measured->bearing,
                   .range = measured->range,
                   .std_bearing = measured->std_bearing,
                   .std_range = measured->std_range,
                   .facing = measured->facing};
}

Reading readingAt(double time, const Pose2& robot, const LandmarkTable& map, const TagSeries& series,
                  RandomStream& random)
{
  const PinholeCamera camera = hallCamera();
  Reading reading{.time = time, .sensor = "tags", .T_robot_sensor = {0.12, 0, 0}, .sensor_height = 0.45};
  reading.horizontal_range = true;
  std::vector<std::pair<double, Detection>> seen;
  for (const Landmark& tag : map.all())
  {
    double size = 0;
    if (auto detection = seenTag(tag, compose(robot, reading.T_robot_sensor), 0.45, camera, random, size))
      seen.emplace_back(-size, std::move(*detection));
  }
  std::stable_sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < std::min(seen.size(), series.most); ++i)
  {
    reading.detections.push_back(seen[i].second);
    if (!series.facings) reading.detections.back().facing.reset();
  }
  return reading;
}

FilterScenario drive(std::uint64_t seed, const TagSeries& series)
{
  RandomStream random(seed, 31);
  FilterScenario scenario;
  scenario.map = hallOfTags(random);
  const std::string ini = std::string(MRPT_EXT_SOURCE_DIR) + "/ini/landmark-localization/tags.ini";
  scenario.config = localizationConfig(Settings::load(ini, localizationKeys(), {}), scenario.map);
  const double phase = kTwoPi * random.uniform(), sense = random.uniform() < 0.5 ? -1 : 1,
               radius = 1.5 + 1.2 * random.uniform();
  std::vector<Record> records;
  Pose2 odometry;
  for (int k = 0; k < kFrames; ++k)
  {
    const double time = 100 + kFrameInterval * k;
    const Pose2 robot = poseAt(k, phase, sense, radius);
    if (k > 0)
    {
      const Pose2 step = between(scenario.truth.back().pose, robot);
      const OdometryMotion motion{step, step.position().norm(), std::abs(step.phi), kFrameInterval};
      const Matrix3d factor = incrementCovariance(scenario.config.filter.motion, motion).llt().matrixL();
      const double a = random.gaussian(), b = random.gaussian(), c = random.gaussian();
      odometry = compose(odometry, added(step, factor * Vector3d(a, b, c)));
    }
    scenario.truth.push_back({time, robot, true});
    records.emplace_back(OdometryRecord{time, odometry});
    Reading reading = readingAt(time, robot, scenario.map, series, random);
    if (!reading.detections.empty()) records.emplace_back(std::move(reading));
  }
  scenario.sequence = testing::buildFrames(records, scenario.map, scenario.config.frames);
  return scenario;
}

Matrix3d informationOf(const Frame& frame, const LandmarkTable& map, const Pose2& truth)
{
  Matrix3d information = Matrix3d::Zero();
  const KalmanState state = startingState({truth, Matrix3d::Zero()}, {});
  const auto add = [&](const KalmanRow& row) { information += row.jacobian.transpose() * row.jacobian / row.variance; };
  for (const Reading& reading : frame.readings)
    for (const Detection& d : reading.detections)
    {
      const DetectionRows rows = linearise(d, reading, map[*map.indexOf(d.id)], state.mean, {});
      for (int r = 0; r < rows.count; ++r) add(rows.rows[static_cast<std::size_t>(r)]);
      const auto headings = headingFromFacing(d, reading, map);
      if (!headings) continue;
      const auto& [one, other] = headings->attitudes;  // that of the truth is taken for known
      const auto away = [&](const Facing::Attitude& a) { return std::abs(wrap(a.yaw - truth.phi)) / a.std; };
      const Facing::Attitude& own = other.weight > 0 && away(other) < away(one) ? other : one;
      add(lineariseHeading(own.yaw, own.std, state.mean));
    }
  return information;
}

std::vector<Matrix3d> boundOf(const FilterScenario& scenario, const std::vector<FilterSample>& samples)
{
  std::vector<BoundStep> steps;
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    BoundStep step;
    step.increment = k > 0 ? between(samples[k - 1].truth, samples[k].truth) : Pose2{};
    step.odometry_covariance = incrementCovariance(scenario.config.filter.motion, samples[k].frame->motion);
    step.measurement_information = informationOf(*samples[k].frame, scenario.map, samples[k].truth);
    steps.push_back(step);
  }
  const Matrix3d prior = Vector3d(square(kLength), square(kWidth), square(kTwoPi)).asDiagonal() * (1.0 / 12);
  return testing::posteriorBounds(samples.front().truth, prior, steps);
}

struct DriveSums
{
  double squared = 0, bound = 0, nees = 0, heading_nees = 0, count = 0;
  std::vector<double> first_ok, first_heading, third_heading;  // [s], [deg] absolute
  int unique_at_first = 0, drives = 0, never = 0, ok = 0, wrong = 0;
};

void addDrive(const FilterScenario& scenario, std::uint64_t seed, DriveSums& sums)
{
  const std::vector<FilterSample> samples = runFilter(scenario, seed);
  if (samples.empty()) return;
  const std::vector<Matrix3d> bounds = boundOf(scenario, samples);
  double first_ok = kNotFound;
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    const FilterSample& sample = samples[k];
    const double heading_error = radToDeg(std::abs(sample.error.z()));
    if (k == 0) sums.first_heading.push_back(heading_error);
    if (k == 0)
      sums.unique_at_first +=
          sample.best().weight >= 0.9 && std::sqrt(sample.best().pose.covariance(2, 2)) < degToRad(kWrongHeading) ? 1
                                                                                                                  : 0;
    if (k == 2) sums.third_heading.push_back(heading_error);
    const bool ok = sample.step.verdict == Verdict::ok;
    if (ok && first_ok == kNotFound) first_ok = sample.time - samples.front().time;
    sums.ok += ok ? 1 : 0;
    sums.wrong += ok && (sample.distance() > kWrongPlace || heading_error > kWrongHeading) ? 1 : 0;
    if (sample.time - samples.front().time < kTransient) continue;
    sums.squared += square(sample.distance());
    sums.bound += bounds[k](0, 0) + bounds[k](1, 1);
    sums.nees += sample.positionNees();
    sums.heading_nees += square(sample.error.z()) / sample.best().pose.covariance(2, 2);
    ++sums.count;
  }
  ++sums.drives;
  if (first_ok == kNotFound)
    ++sums.never;
  else
    sums.first_ok.push_back(first_ok);
}

double quantileOf(std::vector<double> values, double share)
{
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

double rootMeanSquare(const std::vector<double>& values)
{
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, values.size())));
}

void run(std::ostream& out)
{
  const int runs = studyRuns(100);
  out << "Drives of " << kFrames << " frames along ovals in a hall of " << kLength << " x " << kWidth
      << " m with 16 tags of 20 cm, corners shaken by " << kStdCorner << " px, measured by the fit of the front end; "
      << "start unknown. RMSE and bound from " << kTransient << " s on; the bound counts directions where the filter "
      << "is given them. NEES of the position (2 is right) and of the heading (1). Wrong: `ok` off by " << kWrongPlace
      << " m or " << kWrongHeading
      << " deg.\n\n| tags of a frame | drives | one precise mode at the first | heading error "
      << "there, median, RMS [deg] | at the third, RMS | first `ok`, median, 90 % [s] | never | RMSE [mm] | bound [mm] "
      << "| RMSE / bound | NEES | of the heading | ok | wrong "
         "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const TagSeries& series :
       {TagSeries{"all, without directions", false}, TagSeries{"all, with directions", true},
        TagSeries{"the largest, without directions", false, 1}, TagSeries{"the largest, with directions", true, 1}})
  {
    DriveSums sums;
    for (int k = 0; k < runs; ++k)
    {
      const std::uint64_t seed = studySeed(k);
      addDrive(drive(seed, series), seed, sums);
    }
    const double rmse = std::sqrt(sums.squared / sums.count), bound = std::sqrt(sums.bound / sums.count);
    out << "| " << series.name << " | " << sums.drives << " | " << sums.unique_at_first << std::fixed
        << std::setprecision(1) << " | " << quantileOf(sums.first_heading, 0.5) << ", "
        << rootMeanSquare(sums.first_heading) << " | " << rootMeanSquare(sums.third_heading) << " | "
        << quantileOf(sums.first_ok, 0.5) << ", " << quantileOf(sums.first_ok, 0.9) << " | " << sums.never << " | "
        << 1e3 * rmse << " | " << 1e3 * bound << " | " << std::setprecision(2) << rmse / bound << " | "
        << sums.nees / sums.count << " | " << sums.heading_nees / sums.count << " | " << sums.ok << " | " << sums.wrong
        << " |\n"
        << std::flush;
  }
}

const RegisterStudy kStudy("tag_drives",
                           "How soon is the pose known from fiducial tags, and how near is it to the bound, with and "
                           "without the directions that they face?",
                           run);
}  // namespace
}  // namespace mrpt_ext
