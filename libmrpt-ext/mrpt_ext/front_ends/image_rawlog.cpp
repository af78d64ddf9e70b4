#include <mrpt/img/CImage.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationStereoImages.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <deque>
#include <map>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/front_ends/image_frame.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/rawlog/rawlog_reader.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

const std::set<std::string> kNeeded = {"CObservationImage", "CObservationStereoImages", "CObservationOdometry"};
constexpr double kLeastHorizontal = 0.9;  ///< of the optical axis' vertical part

/// Position of the camera and direction of its image's u axis, seen from above. With the default pose a camera that
/// looks up has the axes of the robot.
Pose2 planarPose(const mrpt::poses::CPose3D& pose)
{
  const auto rotation = pose.getRotationMatrix();
  return {pose.x(), pose.y(), std::atan2(rotation(1, 0), rotation(0, 0))};
}

/// The pixels as OpenCV keeps them, gray or blue, green, red; none when they are not of 8 bits. MRPT 2 keeps colours in
/// OpenCV's order, MRPT 3 in the opposite one.
cv::Mat loadedPixels(const mrpt::img::CImage& image)
{
  const int width = static_cast<int>(image.getWidth()), height = static_cast<int>(image.getHeight());
  if (image.getPixelDepth() != mrpt::img::PixelDepth::D8U) return {};
  const auto* first = image.ptrLine<std::uint8_t>(0);
  const auto channels = static_cast<int>(image.ptr<std::uint8_t>(1, 0) - first);
  const cv::Mat kept(height, width, CV_8UC(channels), const_cast<std::uint8_t*>(first), image.getRowStride());
  if (channels == 1) return kept.clone();
  const bool red_first = image.getChannelsOrder().starts_with("RGB");
  cv::Mat pixels;
  if (channels == 4)
    cv::cvtColor(kept, pixels, red_first ? cv::COLOR_RGBA2BGR : cv::COLOR_BGRA2BGR);
  else if (red_first)
    cv::cvtColor(kept, pixels, cv::COLOR_RGB2BGR);
  else
    pixels = kept.clone();
  return pixels;
}

/// The pixels; none when the image is kept in a file that cannot be read.
cv::Mat pixelsOf(const mrpt::img::CImage& image)
{
  try
  {
    return image.isEmpty() ? cv::Mat() : loadedPixels(image);
  }
  catch (const std::exception&)
  {
    return {};
  }
}

using CameraNumbersByName = std::map<std::string, double>;

/// Size, focal lengths and principal point, as far as they are known: zero stands for unknown.
CameraNumbersByName intrinsicsOf(const mrpt::img::TCamera& model)
{
  CameraNumbersByName camera;
  const auto state = [&](const char* name, double value)
  {
    if (value > 0) camera[name] = value;
  };
  state("width", model.ncols), state("height", model.nrows);
  state("fx", model.fx()), state("fy", model.fy()), state("cx", model.cx()), state("cy", model.cy());
  return camera;
}

/// Adds where the camera is and how it looks; nothing but the height of one that looks up or down: its pose was not
/// set. The optical axis is the pose's z axis, as MRPT has it.
void addMounting(CameraNumbersByName& camera, const mrpt::poses::CPose3D& pose)
{
  const auto rotation = pose.getRotationMatrix();
  if (pose.z() > 0) camera["height_m"] = pose.z();
  if (std::abs(rotation(2, 2)) > kLeastHorizontal) return;
  camera["pitch_deg"] = radToDeg(std::asin(-rotation(2, 2)));
  camera["forward"] = pose.x(), camera["left"] = pose.y();
}

/// What the log states about its stereo pair, under the names of camera.json.
CameraFile cameraOf(const mrpt::obs::CObservationStereoImages& stereo)
{
  CameraNumbersByName camera = intrinsicsOf(stereo.leftCamera);
  if (const double baseline = std::abs(stereo.rightCameraPose.x()); baseline > 0) camera["baseline"] = baseline;
  addMounting(camera, mrpt::poses::CPose3D(stereo.cameraPose));
  return CameraFile(camera);
}

/// The same of a camera that looks ahead, with its distortion; nothing of one whose model or pose was not set.
CameraFile cameraOf(const mrpt::obs::CObservationImage& image)
{
  const mrpt::img::TCamera &model = image.cameraParams, unset;
  const auto rotation = image.cameraPose.getRotationMatrix();
  const bool has_model = model.fx() != unset.fx() || model.fy() != unset.fy() || model.cx() != unset.cx();
  if (!has_model || std::abs(rotation(2, 2)) > kLeastHorizontal) return {};
  CameraNumbersByName camera = intrinsicsOf(model);
  camera["k1"] = model.k1(), camera["k2"] = model.k2(), camera["k3"] = model.k3();
  camera["p1"] = model.p1(), camera["p2"] = model.p2();
  addMounting(camera, image.cameraPose);
  camera["mount_yaw_deg"] = radToDeg(std::atan2(rotation(1, 2), rotation(0, 2)));
  // The image's right and lower side, against the horizontal.
  camera["roll_deg"] = radToDeg(std::atan2(-rotation(2, 0), -rotation(2, 1)));
  return CameraFile(camera);
}

class ImageRawlog : public ImageSequence
{
 public:
  ImageRawlog(const fs::path& rawlog, std::vector<std::string> roles)
      : reader_(rawlog, kNeeded), roles_(std::move(roles))
  {
    mrpt::img::CImage::setImagesPathBase(mrpt::obs::CRawlog::detectImagesDirectory(rawlog.string()));
    // The first image comes with the camera.
    while (frames_ == 0 && read())
    {
    }
  }

  std::optional<ImageRecord> next() override
  {
    while (waiting_.empty())
      if (!read()) return std::nullopt;
    std::optional<ImageRecord> first(std::in_place, std::move(waiting_.front()));
    waiting_.pop_front();
    return first;
  }

 private:
  /// One record; false at the end.
  bool read()
  {
    const auto record = reader_.next();
    if (!record) return false;
    if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(record))
      for (const auto& observation : *frame) add(*observation);
    else if (const auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(record))
      add(*observation);
    else
      ++ignored;
    return true;
  }

  void add(const mrpt::obs::CObservation& observation)
  {
    const auto* odometry = dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation);
    const auto* image = dynamic_cast<const mrpt::obs::CObservationImage*>(&observation);
    const auto* stereo = dynamic_cast<const mrpt::obs::CObservationStereoImages*>(&observation);
    if (!odometry && !image && !stereo)
    {
      ++ignored;
      return;
    }
    if (!isValid(observation.timestamp)) throw dataError(reader_.where() + ": no timestamp, expected one");
    const double time = secondsOf(observation.timestamp);
    if (odometry)
    {
      waiting_.emplace_back(
          OdometryRecord{time, {odometry->odometry.x(), odometry->odometry.y(), wrap(odometry->odometry.phi())}});
      return;
    }
    ImageFrame frame{frames_++, time, {}};
    const std::string name = observation.sensorLabel + "_" + std::to_string(frame.number);
    // One of the sensor's cameras by its label, or the only one.
    const bool labelled = std::find(roles_.begin(), roles_.end(), observation.sensorLabel) != roles_.end();
    const std::string role = labelled ? observation.sensorLabel : "image";
    if (!has_camera_) camera = image ? cameraOf(*image) : cameraOf(*stereo);
    has_camera_ = true;
    if (image) frame.images = {{role, name, pixelsOf(image->image), planarPose(image->cameraPose)}};
    if (stereo)
    {
      frame.images = {{"left", name + "_left", pixelsOf(stereo->imageLeft), {}}};
      if (stereo->hasImageRight) frame.images.push_back({"right", name + "_right", pixelsOf(stereo->imageRight), {}});
    }
    waiting_.emplace_back(std::move(frame));
  }

  RawlogReader reader_;
  std::vector<std::string> roles_;
  std::deque<ImageRecord> waiting_;
  int frames_ = 0;
  bool has_camera_ = false;  // of the first image or stereo pair
};
}  // namespace

std::unique_ptr<ImageSequence> openImageRawlog(const fs::path& rawlog, const std::vector<std::string>& roles)
{
  return std::make_unique<ImageRawlog>(rawlog, roles);
}
}  // namespace mrpt_ext
