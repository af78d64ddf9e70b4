#include "mrpt_ext/front_ends/movis_front_end.h"

#include <array>
#include <cmath>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/front_ends/images_keys.h"
#include "mrpt_ext/front_ends/movis_settings.h"
#include "mrpt_ext/solvers/camera_yaw_calibration.h"
#include "mrpt_ext/solvers/movis_frame.h"
#include "mrpt_ext/solvers/sight_agreement.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStdPlaces = degToRad(0.1);  ///< of a bearing, by errors of the robot's and the poles' places
constexpr double kMounting = degToRad(3);     ///< cameras that are turned by more contradict each other
constexpr std::array kLabels{"M1", "M2", "M3"};
constexpr std::array kObjects{"p", "q", "ball"};

std::vector<int> wholeNumbers(const Settings& settings, const char* key)
{
  std::vector<int> result;
  if (!settings.hasValue(kMovisSection, key)) return result;
  for (const double number : settings.numbers(kMovisSection, key))
  {
    if (number != std::floor(number)) throw settings.errorAt(kMovisSection, key, "expected whole numbers");
    result.push_back(static_cast<int>(number));
  }
  return result;
}

/// "M1: turned by 0.412 deg, standard deviation 0.020 deg".
std::string yawText(const std::string& label, const CameraYaw& yaw, double std, std::size_t sightings)
{
  const std::string left_out = std::to_string(sightings - yaw.used) + " of " + std::to_string(sightings);
  return label + ": turned by " + fixedText(radToDeg(-yaw.offset), 3) + " deg, standard deviation " +
         fixedText(radToDeg(std), 3) + " deg" +
         (yaw.used < sightings ? ", " + left_out + " sightings of poles left out, which do not agree" : "");
}

/// Why a camera stays as it is.
std::string refusalText(const std::string& label, const CameraYaw& yaw, std::size_t sightings)
{
  const std::string not_calibrated = label + ": not calibrated, ";
  if (sightings == 0) return not_calibrated + "no pole was seen in the calibration frames";
  if (sightings == 1)
    return not_calibrated +
           "a single sighting of a pole cannot be checked, expected two or more in the frames of "
           "calibration_frame";
  return not_calibrated + "its sightings of poles differ by up to " + fixedText(radToDeg(yaw.spread), 1) +
         " deg, expected them to agree: something else was taken for a pole, or the pose is wrong";
}
}  // namespace

MovisFrontEnd::MovisFrontEnd(const Settings& settings, const CameraFile& camera)
    : pole_ids_(wholeNumbers(settings, "pole_ids")), calibration_frames_(wholeNumbers(settings, "calibration_frame"))
{
  if (pole_ids_.size() != 2 || pole_ids_[0] == pole_ids_[1] || std::min(pole_ids_[0], pole_ids_[1]) < 0)
    throw settings.errorAt(kMovisSection, "pole_ids", "expected two different ids, of p and of q");
  const MovisSettings movis = movisSettings(settings, camera);
  field_ = movis.field;
  pole_height_ = movis.cameras[0].sizes.pole_height;
  for (std::size_t i = 0; i < movis.cameras.size(); ++i)
  {
    const auto mount = movisCamera(static_cast<int>(i) + 1, movis.mount_radius);
    const double u_axis = forwardBearingFromSlant(mount->slantFromTheta(0));
    cameras_.push_back(
        {kLabels[i], robotFromMovis(mount->position), wrap(u_axis + movis.mount_yaw[i]), OmniCamera(movis.cameras[i])});
  }
}

double MovisFrontEnd::bearingOf(const Mounted& mounted, const OmniObject& object) const
{
  return wrap(object.azimuth + mounted.yaw);
}

int MovisFrontEnd::idOf(const std::string& label) const
{
  if (label == "p") return pole_ids_[0];
  return label == "q" ? pole_ids_[1] : kNoId;
}

LandmarkTable MovisFrontEnd::landmarks() const
{
  const auto pole = [&](int id, const char* name, double x) {
    return Landmark{id, {x, field_.depth, pole_height_}, name, {0, 0}};
  };
  return LandmarkTable({pole(pole_ids_[0], "p", -field_.half_width), pole(pole_ids_[1], "q", field_.half_width)});
}

std::size_t MovisFrontEnd::dropContradicted(std::vector<Seen>& frame) const
{
  std::size_t dropped = 0;
  for (const std::string label : kObjects)
  {
    std::vector<RangedSight> sights;
    for (const auto& [mounted, objects] : frame)
      for (const OmniObject& object : objects)
        if (object.label == label)
          sights.push_back({{mounted->position, bearingOf(*mounted, object), object.std_azimuth}, object.distance});
    const std::vector<bool> confirmed = confirmedSights(sights, kMounting);
    std::size_t next = 0;
    for (Seen& seen : frame)
    {
      std::vector<OmniObject> kept;
      for (OmniObject& object : seen.objects)
        if (object.label != label || confirmed[next++])
          kept.push_back(std::move(object));
        else
          ++dropped;
      seen.objects = std::move(kept);
    }
  }
  return dropped;
}

FrameMeasurements MovisFrontEnd::measure(const ImageFrame& frame, bool with_drawings) const
{
  FrameMeasurements result;
  std::vector<Seen> seen;
  bool any = false;
  for (const Mounted& mounted : cameras_)
  {
    const FrameImage* const image = frame.find(mounted.label);
    if (!image) continue;
    any = true;
    const OmniView view = mounted.camera.view(image->pixels);
    if (with_drawings) result.drawings.push_back({image->name, mounted.camera.draw(image->pixels, view, mounted.yaw)});
    if (const std::string problem = image->complaint(view.problem); !problem.empty())
    {
      result.problems.push_back(frame.nameOf(*image) + ": " + problem);
      continue;
    }
    seen.push_back({&mounted, view.objects});
  }
  result.contradicted = dropContradicted(seen);
  for (const auto& [mounted, objects] : seen)
  {
    Reading reading;
    reading.time = frame.time;
    reading.sensor = mounted->label;
    reading.T_robot_sensor = {mounted->position.x(), mounted->position.y(), 0};
    for (const OmniObject& object : objects)
    {
      Detection detection;
      detection.id = idOf(object.label);
      detection.category = object.label;
      detection.bearing = bearingOf(*mounted, object);
      detection.std_bearing = object.std_azimuth;
      reading.detections.push_back(detection);
      result.rows.emplace_back(mounted->label, object.label, detection);
    }
    result.readings.push_back(std::move(reading));
  }
  if (!any)
    result.problems.push_back(
        std::string("frame ").append(std::to_string(frame.number)).append(": no image of M1, M2 or M3"));
  return result;
}

CalibrationNotes MovisFrontEnd::calibrate(const std::vector<FrameAtPose>& frames)
{
  const LandmarkTable poles = landmarks();
  CalibrationNotes notes;
  for (Mounted& mounted : cameras_)
  {
    std::vector<CalibrationSighting> detections;
    double variances = 0;
    bool is_there = false;
    for (const auto& [frame, robot] : frames)
    {
      const FrameImage* const image = frame.find(mounted.label);
      if (!image) continue;
      is_there = true;
      for (const OmniObject& object : mounted.camera.view(image->pixels).objects)
        if (const auto pole = poles.indexOf(idOf(object.label)))
        {
          detections.push_back({robot, poles[*pole].position.head<2>(), bearingOf(mounted, object),
                                std::hypot(object.std_azimuth, kStdPlaces)});
          variances += square(object.std_azimuth);
        }
    }
    if (!is_there)
    {
      notes.results.push_back(mounted.label + ": not calibrated, no image of it in the calibration frames");
      continue;
    }
    const CameraYaw yaw = calibrateCameraYaw(detections, {mounted.position.x(), mounted.position.y(), 0});
    if (yaw.status != SolveStatus::ok)
    {
      notes.warnings.push_back(refusalText(mounted.label, yaw, detections.size()));
      continue;
    }
    mounted.yaw = wrap(mounted.yaw - yaw.offset);
    // Two detections may agree by chance: their scatter alone underestimates the error of the mean.
    const double by_detections = std::sqrt(variances) / static_cast<double>(detections.size());
    notes.results.push_back(yawText(mounted.label, yaw, std::hypot(yaw.std_offset, by_detections), detections.size()));
  }
  return notes;
}
}  // namespace mrpt_ext
