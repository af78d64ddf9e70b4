#include "mrpt_ext/front_ends/conic_mirror_front_end.h"

#include <cmath>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/front_ends/images_keys.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/vision/mirror_calibration.h"

namespace mrpt_ext
{
namespace
{
constexpr double kUsualRadius = 0.7;  ///< of the parts of an edge that count most, share of the rim's

/// All four numbers or none: without them the mirror's axis is taken for the camera's.
std::optional<MirrorAxis> axisFrom(const CameraNumbers& numbers)
{
  const auto u = numbers.optional("principal_u_px", "cx"), v = numbers.optional("principal_v_px", "cy");
  const auto cone = numbers.optional("cone_half_angle_deg", "cone_half_angle_deg");
  const auto rim = numbers.optional("rim_angle_deg", "rim_phi_deg");
  if (!u || !v || !cone || !rim) return std::nullopt;
  if (!(*rim > 0 && *rim < *cone && *cone < 90))
    throw dataError("camera.json: expected 0 < rim_phi_deg < cone_half_angle_deg < 90");
  const auto tilt = [&](const char* key, const char* name)
  { return degToRad(numbers.optional(key, name).value_or(0)); };
  return MirrorAxis{
      {*u, *v},
      degToRad(*cone),
      degToRad(*rim),
      {tilt("camera_tilt_u_deg", "camera_tilt_u_deg"), tilt("camera_tilt_v_deg", "camera_tilt_v_deg")},
      {tilt("vertical_tilt_u_deg", "vertical_tilt_u_deg"), tilt("vertical_tilt_v_deg", "vertical_tilt_v_deg")}};
}

ConicMirrorSettings readConicModel(const Settings& settings, const CameraFile& camera)
{
  const CameraNumbers of_camera(settings, kConicMirrorSection, camera);
  const auto number = [&](const char* key) { return settings.number(kConicMirrorSection, key); };
  ConicMirrorSettings model;
  model.image_size = {static_cast<int>(of_camera.optional("image_width", "width").value_or(0)),
                      static_cast<int>(of_camera.optional("image_height", "height").value_or(0))};
  model.mount_yaw = degToRad(of_camera.optional("mount_yaw_deg", "mount_yaw_deg").value_or(0));
  model.axis = axisFrom(of_camera);
  model.outline = {number("rim_radius_min"), number("rim_radius_max"),    number("rim_aspect_min"),
                   number("rim_aspect_max"), number("rim_visible_share"), number("rim_contrast")};
  model.grid = {static_cast<int>(settings.integer(kConicMirrorSection, "azimuths")),
                static_cast<int>(settings.integer(kConicMirrorSection, "radii")), number("ring_inner"),
                number("ring_outer")};
  if (!(model.grid.inner < model.grid.outer))
    throw settings.errorAt(kConicMirrorSection, "ring_inner", "expected less than ring_outer");
  model.edges.smoothing = settings.radians(kConicMirrorSection, "edge_smoothing_deg");
  model.edges.min_length = number("edge_length");
  model.edges.min_significance = number("edge_significance");
  model.edges.min_contrast = number("edge_contrast");
  model.edges.max_width = settings.radians(kConicMirrorSection, "edge_width_deg");
  model.edges.blur = number("edge_blur_px");
  model.edges.min_prominence = number("edge_prominence");
  model.edges.std_floor = settings.radians(kConicMirrorSection, "std_floor_deg");
  return model;
}
std::map<std::string, double> numbersOf(const MirrorAxis& axis)
{
  return {{"cx", axis.principal_point.x},
          {"cy", axis.principal_point.y},
          {"cone_half_angle_deg", radToDeg(axis.cone_half_angle)},
          {"rim_phi_deg", radToDeg(axis.rim_angle)},
          {"camera_tilt_u_deg", radToDeg(axis.camera_tilt.x)},
          {"camera_tilt_v_deg", radToDeg(axis.camera_tilt.y)},
          {"vertical_tilt_u_deg", radToDeg(axis.vertical_tilt.x)},
          {"vertical_tilt_v_deg", radToDeg(axis.vertical_tilt.y)}};
}

/// "mirror: principal point 320.1 240.3 px, camera tilted by ... deg, ...".
std::string textOf(const MirrorAlignment& alignment)
{
  const auto tilt = [](const cv::Point2d& tilted)
  { return fixedText(radToDeg(tilted.x), 2) + " " + fixedText(radToDeg(tilted.y), 2) + " deg"; };
  const MirrorAxis& axis = alignment.axis;
  return "mirror: principal point " + fixedText(axis.principal_point.x, 1) + " " +
         fixedText(axis.principal_point.y, 1) + " px, camera tilted by " + tilt(axis.camera_tilt) + ", vertical by " +
         tilt(axis.vertical_tilt) + "; edges were bent by " + fixedText(radToDeg(alignment.bend_before), 3) +
         " deg, now by " + fixedText(radToDeg(alignment.bend_after), 3) + " deg (" + std::to_string(alignment.edges) +
         " edges)";
}
}  // namespace

ConicMirrorFrontEnd::ConicMirrorFrontEnd(const Settings& settings, const CameraFile& camera)
    : model_(readConicModel(settings, camera)),
      calibration_frames_(static_cast<std::size_t>(settings.integer(kConicMirrorSection, "self_calibration_frames"))),
      T_robot_sensor_{settings.number(kConicMirrorSection, "sensor_x_m"),
                      settings.number(kConicMirrorSection, "sensor_y_m"), 0},
      label_(settings.text(kConicMirrorSection, "sensor_label"))
{
}

CalibrationNotes ConicMirrorFrontEnd::selfCalibrate(const std::vector<ImageFrame>& frames)
{
  std::vector<cv::Mat> images;
  for (const ImageFrame& frame : frames)
    if (const FrameImage* const image = frame.find("image"); image && !image->pixels.empty())
      images.push_back(image->pixels);
  model_.usual_rim = usualRimOf(images, model_);
  const auto alignment = calibrateMirror(images, model_);
  if (!alignment || !alignment->isBetter()) return {};
  model_.axis = alignment->axis;
  model_.edges.std_floor = std::hypot(model_.edges.std_floor, alignment->stdAzimuth(kUsualRadius));
  calibrated_ = numbersOf(alignment->axis);
  return {{textOf(*alignment)}, {}};
}

FrameMeasurements ConicMirrorFrontEnd::measure(const ImageFrame& frame, bool with_drawings) const
{
  FrameMeasurements result;
  const FrameImage* const image = frame.find("image");
  if (!image)
  {
    result.problems.push_back("frame " + std::to_string(frame.number) + ": no image of the mirror");
    return result;
  }
  const ConicMirrorView view = viewConicMirror(image->pixels, model_);
  const double yaw = model_.mount_yaw + image->T_robot_camera.phi;
  if (with_drawings) result.drawings.push_back({image->name, drawConicMirror(image->pixels, view, yaw)});
  if (view.contradicts) result.contradicted = 1;
  if (const std::string problem = image->complaint(view.problem); !problem.empty())
  {
    result.problems.push_back(frame.nameOf(*image) + ": " + problem);
    return result;
  }
  Reading reading;
  reading.time = frame.time;
  reading.sensor = label_;
  reading.T_robot_sensor = compose(T_robot_sensor_, Pose2{image->T_robot_camera.x, image->T_robot_camera.y, 0});
  for (const RadialEdge& edge : view.edges)
  {
    Detection detection;
    detection.bearing = wrap(edge.azimuth + yaw);
    detection.std_bearing = edge.std_azimuth;
    reading.detections.push_back(detection);
    result.rows.emplace_back(label_, "edge", detection);
  }
  result.readings.push_back(std::move(reading));
  return result;
}
}  // namespace mrpt_ext
