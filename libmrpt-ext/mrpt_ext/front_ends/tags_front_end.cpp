#include "mrpt_ext/front_ends/tags_front_end.h"

#include <cmath>
#include <limits>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/front_ends/images_keys.h"
#include "mrpt_ext/front_ends/tag_dictionary_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kFewestTags = 10;    ///< that tell how precise corners are
constexpr double kSignificance = 3;        ///< standard deviations by which they must disagree with what is stated
constexpr double kMedianResidual = 1.386;  ///< of chi-squared with two degrees of freedom
constexpr double kStdOfMedian = 1.44;      ///< relative, of one value

PinholeCamera readPinhole(const CameraNumbers& numbers)
{
  const auto zeroIfUnset = [&](const char* key, const char* name) { return numbers.optional(key, name).value_or(0); };
  PinholeCamera camera;
  camera.size = {static_cast<int>(zeroIfUnset("image_width", "width")),
                 static_cast<int>(zeroIfUnset("image_height", "height"))};
  camera.fx = numbers.size("focal_u_px", "fx"), camera.fy = numbers.size("focal_v_px", "fy");
  camera.cx = numbers.required("centre_u_px", "cx"), camera.cy = numbers.required("centre_v_px", "cy");
  camera.k1 = zeroIfUnset("distortion_k1", "k1"), camera.k2 = zeroIfUnset("distortion_k2", "k2");
  camera.k3 = zeroIfUnset("distortion_k3", "k3");
  camera.p1 = zeroIfUnset("distortion_p1", "p1"), camera.p2 = zeroIfUnset("distortion_p2", "p2");
  camera.pitch = degToRad(zeroIfUnset("pitch_deg", "pitch_deg"));
  camera.roll = degToRad(zeroIfUnset("roll_deg", "roll_deg"));
  return camera;
}

TagSettings readTagModel(const Settings& settings, const CameraFile& camera)
{
  const CameraNumbers numbers(settings, kTagsSection, camera);
  const auto number = [&](const char* key) { return settings.number(kTagsSection, key); };
  TagSettings model;
  model.camera = readPinhole(numbers);
  model.edge = numbers.size("tag_edge_m", "tag_edge_m");
  model.noise.std_corner = number("std_corner_px"), model.gate = number("gate");
  model.noise.std_upright = settings.radians(kTagsSection, "std_upright_deg");
  TagDetectorSettings& detector = model.detector;
  detector.family = settings.choice(kTagsSection, "family");
  if (settings.hasValue(kTagsSection, "dictionary_file"))
    detector.dictionary = readTagDictionary(settings.existingPath(kTagsSection, "dictionary_file"));
  else if (detector.family == kArucoOriginal)
    detector.dictionary = arucoOriginal();
  detector.decimation = number("decimation"), detector.min_margin = number("min_margin");
  detector.corrected_bits = static_cast<int>(settings.integer(kTagsSection, "corrected_bits"));
  detector.linear_camera = settings.flag(kTagsSection, "linear_camera");
  return model;
}

/// [px] how far the corners of these tags scatter about squares in any attitude; nothing of too few to tell, nor when
/// it is not more than stated.
std::optional<double> excessiveScatter(const std::vector<TagCorners>& tags, const TagSettings& stated)
{
  constexpr double kAnyAttitude = 1e3;
  std::vector<double> residuals;
  for (const TagCorners& corners : tags)
    if (const auto poses = posesOfTag(corners, stated.edge, stated.camera, {1, kAnyAttitude}); !poses.empty())
      residuals.push_back(poses.front().residual);
  if (residuals.size() < kFewestTags) return std::nullopt;
  const double significant = kSignificance * kStdOfMedian / std::sqrt(static_cast<double>(residuals.size()));
  const double scatter = std::sqrt(*median(residuals) / kMedianResidual);
  return scatter > stated.noise.std_corner * std::sqrt(1 + significant) ? std::optional(scatter) : std::nullopt;
}

Pose2 readMounting(const Settings& settings, const CameraFile& camera)
{
  const CameraNumbers numbers(settings, kTagsSection, camera);
  return {numbers.optional("sensor_x_m", "forward").value_or(0), numbers.optional("sensor_y_m", "left").value_or(0),
          wrap(degToRad(numbers.optional("mount_yaw_deg", "mount_yaw_deg").value_or(0)))};
}

Detection detectionOf(const SeenTag& tag)
{
  Detection detection;
  detection.id = tag.id;
  detection.bearing = tag.measured.bearing, detection.std_bearing = tag.measured.std_bearing;
  detection.range = tag.measured.range, detection.std_range = tag.measured.std_range;
  detection.facing = tag.measured.facing;
  return detection;
}
}  // namespace

TagsFrontEnd::TagsFrontEnd(const Settings& settings, const CameraFile& camera)
    : model_(readTagModel(settings, camera)),
      detector_(model_.detector),
      noise_frames_(static_cast<std::size_t>(settings.integer(kTagsSection, "corner_noise_frames"))),
      T_robot_sensor_(readMounting(settings, camera)),
      height_(CameraNumbers(settings, kTagsSection, camera).optional("camera_height_m", "height_m").value_or(0)),
      label_(settings.text(kTagsSection, "sensor_label"))
{
}

CalibrationNotes TagsFrontEnd::selfCalibrate(const std::vector<ImageFrame>& frames)
{
  TagSettings open = model_;
  open.gate = std::numeric_limits<double>::infinity();
  std::vector<TagCorners> tags;
  for (const ImageFrame& frame : frames)
    if (const FrameImage* const image = frame.find("image"); image && !image->pixels.empty())
      for (const SeenTag& tag : viewTags(image->pixels, detector_, open).tags) tags.push_back(tag.corners);
  const auto scatter = excessiveScatter(tags, model_);
  if (!scatter) return {};
  model_.noise.std_corner = *scatter;
  return {{"tags: corners scatter by " + fixedText(*scatter, 2) +
           " px about squares, more than std_corner_px states; taken instead"},
          {}};
}

FrameMeasurements TagsFrontEnd::measure(const ImageFrame& frame, bool with_drawings) const
{
  FrameMeasurements result;
  const FrameImage* const image = frame.find("image");
  if (!image)
  {
    result.problems.push_back("frame " + std::to_string(frame.number) + ": no image");
    return result;
  }
  const TagView view = viewTags(image->pixels, detector_, model_);
  if (with_drawings) result.drawings.push_back({image->name, drawTags(image->pixels, view)});
  if (!view.problem.empty()) result.problems.push_back(frame.nameOf(*image) + ": " + image->complaint(view.problem));
  for (const RefusedTag& tag : view.refused)
    result.problems.push_back(frame.nameOf(*image) + ": tag " + std::to_string(tag.id) + ": " + tag.why);

  Reading reading;
  reading.time = frame.time;
  reading.sensor = label_;
  reading.T_robot_sensor = T_robot_sensor_;
  reading.sensor_height = height_;
  reading.horizontal_range = true;
  for (const SeenTag& tag : view.tags)
  {
    reading.detections.push_back(detectionOf(tag));
    MeasurementRow row(label_, std::to_string(tag.id), reading.detections.back());
    row.azimuth = wrap(tag.measured.bearing + T_robot_sensor_.phi);
    if (row.facing) row.facing = turnedBack(*row.facing, -T_robot_sensor_.phi);
    result.rows.push_back(std::move(row));
  }
  if (!reading.detections.empty()) result.readings.push_back(std::move(reading));
  return result;
}
}  // namespace mrpt_ext
