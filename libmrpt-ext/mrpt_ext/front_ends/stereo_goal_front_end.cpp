#include "mrpt_ext/front_ends/stereo_goal_front_end.h"

#include <cmath>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/front_ends/images_keys.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSignificant = 3;    ///< standard deviations by which a constant must differ from what is stated
constexpr double kLeastRows = 0.7;    ///< [px] and by as many rows of the image
constexpr double kLeastFeet = 1.2;    ///< [px] likewise of feet, which are found to a row
constexpr double kLeastShare = 0.03;  ///< or by this share of a goal's width

StereoCamera readCameraModel(const Settings& settings, const CameraFile& camera)
{
  const CameraNumbers numbers(settings, kStereoGoalSection, camera);
  const auto number = [&](const char* key, const char* name) { return numbers.required(key, name); };
  StereoCamera model;
  model.size = {static_cast<int>(number("image_width", "width")), static_cast<int>(number("image_height", "height"))};
  model.fx = number("focal_u_px", "fx"), model.fy = number("focal_v_px", "fy");
  model.cx = number("centre_u_px", "cx"), model.cy = number("centre_v_px", "cy");
  model.baseline = number("baseline_m", "baseline");
  model.height = number("camera_height_m", "height_m");
  model.pitch = degToRad(number("pitch_deg", "pitch_deg"));
  for (const double size : {model.fx, model.fy, model.baseline, model.height})
    if (!(size > 0)) throw dataError("camera.json: expected fx, fy, baseline and height_m above 0");
  model.whole_pixels = settings.choice(kStereoGoalSection, "disparity") == "whole_pixels";
  return model;
}

GoalColour readColour(const Settings& settings, const std::string& name)
{
  const auto share = [&](const char* channel)
  { return static_cast<float>(settings.number(kStereoGoalSection, name + "_" + channel)); };
  return GoalColour({share("blue"), share("green"), share("red")});
}

StereoGoalSettings readStereoModel(const Settings& settings, const CameraFile& camera)
{
  const auto number = [&](const char* key) { return settings.number(kStereoGoalSection, key); };
  StereoGoalSettings model;
  model.camera = readCameraModel(settings, camera);
  const std::string features = settings.choice(kStereoGoalSection, "features");
  model.with_corners = features != "lines", model.with_lines = features != "corners";
  GoalCornerSettings& corners = model.corners;
  corners.colours = {readColour(settings, "yellow"), readColour(settings, "blue")};
  corners.scan_step = static_cast<int>(settings.integer(kStereoGoalSection, "scan_step"));
  corners.goal_height = number("goal_height_m"), corners.height_tolerance = number("goal_height_tolerance");
  corners.goal_depth = number("goal_depth_m");
  corners.min_range = number("min_range_m"), corners.max_range = number("max_range_m");
  if (!(corners.min_range < corners.max_range))
    throw settings.errorAt(kStereoGoalSection, "min_range_m", "expected less than max_range_m");
  corners.min_rows = static_cast<int>(settings.integer(kStereoGoalSection, "min_rows"));
  corners.std_column = number("std_column_px"), corners.std_disparity = number("std_disparity_px");
  model.markings = {number("line_width_m"),      number("line_max_range_m"), number("line_contrast"),
                    number("line_significance"), number("wall_contrast"),    number("wall_height_m"),
                    number("std_line_px")};
  return model;
}

/// Of the .ini, else of camera.json; nothing where neither has it.
std::optional<double> statedGoalWidth(const Settings& settings, const CameraFile& camera)
{
  const auto own = settings.optionalNumber(kStereoGoalSection, "goal_width_m");
  return own ? own : camera.fieldNumber("goal_width");
}

MeasurementRow rowOf(const std::string& label, const Detection& detection, double u_left, double u_right)
{
  MeasurementRow row("stereo", label, detection);
  row.u_left = u_left, row.u_right = u_right;
  return row;
}

Detection detectionOf(const StereoMeasurement& measured)
{
  Detection detection;
  detection.bearing = measured.bearing, detection.std_bearing = measured.std_bearing;
  detection.range = measured.range, detection.std_range = measured.std_range;
  return detection;
}

std::string numberText(double value, double std, int decimals)
{
  return fixedText(value, decimals) + " (standard deviation " + fixedText(std, decimals) + ")";
}

/// A line per constant that differs from what is stated, with the value to set.
std::vector<std::string> differences(const CornerConstants& constants, const StereoCamera& camera,
                                     const std::optional<double>& goal_width)
{
  std::vector<std::string> lines;
  const auto differs = [](double by, const CornerConstant& constant, double least)
  { return std::abs(by) > std::max(kSignificant * constant.std(), least); };
  const auto feet = [&](const CornerConstant& constant)
  { return "stereo: the feet of " + std::to_string(constant.count) + " goal corners are where "; };
  if (const auto& rows = constants.right; rows && differs(rows->value, *rows, kLeastRows))
    lines.push_back("stereo: the right images show goal corners " + numberText(rows->value, rows->std(), 2) +
                    " rows lower than the left ones, expected rectified images");
  if (const auto& width = constants.goal_width;
      width && goal_width && differs(width->value - *goal_width, *width, kLeastShare * *goal_width))
    lines.push_back("stereo: goals seem " + numberText(width->value, width->std(), 3) +
                    " m wide, stated: " + fixedText(*goal_width, 3) + "; baseline_m would be " +
                    fixedText(camera.baseline * *goal_width / width->value, 4));
  if (!lines.empty()) return lines;  // what else differs may follow from it
  if (const auto& pitch = constants.pitch;
      pitch && constants.stated && std::abs(constants.stated->value) > kLeastFeet && differs(pitch->value, *pitch, 0))
    lines.push_back(feet(*pitch) + "pitch_deg would be " +
                    numberText(radToDeg(camera.pitch + pitch->value), radToDeg(pitch->std()), 2) +
                    ", stated: " + fixedText(radToDeg(camera.pitch), 2));
  if (const auto& height = constants.height; height && constants.stated &&
                                             std::abs(constants.stated->value) > kLeastFeet &&
                                             differs(height->value, *height, 0))
    lines.push_back(feet(*height) + "camera_height_m would be " +
                    numberText(camera.height + height->value, height->std(), 4) +
                    ", stated: " + fixedText(camera.height, 4));
  return lines;
}
}  // namespace

StereoGoalFrontEnd::StereoGoalFrontEnd(const Settings& settings, const CameraFile& camera)
    : model_(readStereoModel(settings, camera)),
      goal_width_(statedGoalWidth(settings, camera)),
      agreement_frames_(
          model_.with_corners ? static_cast<std::size_t>(settings.integer(kStereoGoalSection, "agreement_frames")) : 0),
      T_robot_sensor_{CameraNumbers(settings, kStereoGoalSection, camera).required("sensor_x_m", "forward"),
                      CameraNumbers(settings, kStereoGoalSection, camera)
                          .optional("sensor_y_m", "left")
                          .value_or(0.5 * model_.camera.baseline),
                      0},
      label_(settings.text(kStereoGoalSection, "sensor_label")),
      line_label_(settings.text(kStereoGoalSection, "line_label"))
{
  const auto id = [&](const char* key) { return static_cast<int>(settings.integer(kStereoGoalSection, key)); };
  names_ = {{{"yellow_l", id("yellow_l_id")},
             {"yellow_r", id("yellow_r_id")},
             {"blue_l", id("blue_l_id")},
             {"blue_r", id("blue_r_id")}}};
}

const StereoGoalFrontEnd::CornerName& StereoGoalFrontEnd::nameOf(const GoalCorner& corner) const
{
  return names_[static_cast<std::size_t>(2 * corner.colour + (corner.side > 0 ? 0 : 1))];
}

CalibrationNotes StereoGoalFrontEnd::selfCalibrate(const std::vector<ImageFrame>& frames)
{
  StereoGoalSettings only_corners = model_;
  only_corners.with_lines = false;
  std::vector<std::vector<CornerEvidence>> evidence;
  for (const ImageFrame& frame : frames)
  {
    const FrameImage *const left = frame.find("left"), *const right = frame.find("right");
    if (!left || !right) continue;
    auto& here = evidence.emplace_back();
    for (const GoalCorner& corner : viewStereoGoal(left->pixels, right->pixels, only_corners).corners)
      here.push_back(evidenceOf(corner, left->pixels, right->pixels, model_.camera));
  }
  constants_ = constantsOf(evidence);
  return {{}, differences(constants_, model_.camera, goal_width_)};
}

std::size_t StereoGoalFrontEnd::dropContradicted(StereoGoalView& view, const cv::Mat& left, const cv::Mat& right) const
{
  std::vector<CornerEvidence> evidence;
  for (const GoalCorner& corner : view.corners) evidence.push_back(evidenceOf(corner, left, right, model_.camera));
  const std::vector<bool> agrees = agreeingCorners(evidence, constants_);
  std::vector<GoalCorner> kept;
  for (std::size_t i = 0; i < agrees.size(); ++i)
    if (agrees[i]) kept.push_back(view.corners[i]);
  view.corners = std::move(kept);
  return agrees.size() - view.corners.size();
}

FrameMeasurements StereoGoalFrontEnd::measure(const ImageFrame& frame, bool with_drawings) const
{
  FrameMeasurements result;
  const FrameImage *const left = frame.find("left"), *const right = frame.find("right");
  if (!left || !right)
  {
    result.problems.push_back("frame " + std::to_string(frame.number) + ": no " + (left ? "right" : "left") + " image");
    return result;
  }
  StereoGoalView view = viewStereoGoal(left->pixels, right->pixels, model_);
  result.contradicted = dropContradicted(view, left->pixels, right->pixels);
  if (with_drawings) result.drawings.push_back({left->name, drawStereoGoal(left->pixels, view, model_)});
  if (!left->problem.empty() || !right->problem.empty())
    for (const FrameImage* image : {left, right})
    {
      if (!image->problem.empty())
        result.problems.push_back(frame.nameOf(*left) + ": " + image->role + " " + image->problem);
    }
  else if (!view.problem.empty())
    result.problems.push_back(frame.nameOf(*left) + ": " + view.problem);

  Reading corners;
  corners.time = frame.time;
  corners.sensor = label_;
  corners.T_robot_sensor = T_robot_sensor_;
  corners.horizontal_range = true;
  corners.model.field_of_view = 2 * std::atan(0.5 * model_.camera.size.width / model_.camera.fx);
  corners.model.has_field_of_view = true;
  Reading lines = corners;
  lines.sensor = line_label_;
  for (const GoalCorner& corner : view.corners)
  {
    corners.detections.push_back(detectionOf(corner.measured));
    corners.detections.back().id = nameOf(corner).id;
    result.rows.push_back(rowOf(nameOf(corner).label, corners.detections.back(), corner.u_left, corner.u_right));
  }
  for (const LineLandmark& landmark : view.landmarks)
  {
    lines.detections.push_back(detectionOf(landmark.measured));
    lines.detections.back().category = mrpt_ext::nameOf(landmark.kind);
    result.rows.push_back(
        rowOf(lines.detections.back().category, lines.detections.back(), landmark.left.x, landmark.right.x));
  }
  for (Reading* reading : {&corners, &lines})
    if (!reading->detections.empty()) result.readings.push_back(std::move(*reading));
  return result;
}
}  // namespace mrpt_ext
