#include <mrpt/img/CImage.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationStereoImages.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <deque>

#include "mrpt_ext/front_ends/image_frame.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/rawlog/rawlog_reader.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

constexpr double kLeastHorizontal = 0.9;  ///< of the optical axis' vertical part

/// Where the camera is and where its image's u axis points, seen from above. A camera that looks up has its axes as
/// the robot has them when its pose says nothing.
Pose2 planarPose(const mrpt::poses::CPose3D& pose)
{
  const auto rotation = pose.getRotationMatrix();
  return {pose.x(), pose.y(), std::atan2(rotation(1, 0), rotation(0, 0))};
}

/// The pixels; none when the image is kept in a file that cannot be read.
cv::Mat pixelsOf(const mrpt::img::CImage& image)
{
  try
  {
    if (image.isEmpty()) return {};
    return image.asCvMat<cv::Mat>(mrpt::img::DEEP_COPY);
  }
  catch (const std::exception&)
  {
    return {};
  }
}

/// What the log says about its stereo pair, under the names of camera.json; nothing about what was left at zero. The
/// optical axis is the pose's z axis, as MRPT has it.
nlohmann::json cameraOf(const mrpt::obs::CObservationStereoImages& stereo)
{
  nlohmann::json camera = nlohmann::json::object();
  const auto tell = [&](const char* name, double value)
  {
    if (value > 0) camera[name] = value;
  };
  const mrpt::img::TCamera& model = stereo.leftCamera;
  tell("width", model.ncols), tell("height", model.nrows);
  tell("fx", model.fx()), tell("fy", model.fy()), tell("cx", model.cx()), tell("cy", model.cy());
  tell("baseline", std::abs(stereo.rightCameraPose.x()));
  const mrpt::poses::CPose3D pose(stereo.cameraPose);
  const auto rotation = pose.getRotationMatrix();
  tell("height_m", pose.z());
  if (std::abs(rotation(2, 2)) > kLeastHorizontal) return camera;  // looks up or down: nothing was said
  camera["pitch_deg"] = radToDeg(std::asin(-rotation(2, 2)));
  camera["forward"] = pose.x(), camera["left"] = pose.y();
  return camera;
}

class ImageRawlog : public ImageSequence
{
 public:
  ImageRawlog(const fs::path& rawlog, std::vector<std::string> roles) : reader_(rawlog), roles_(std::move(roles))
  {
    mrpt::img::CImage::setImagesPathBase(mrpt::obs::CRawlog::detectImagesDirectory(rawlog.string()));
    // The first image tells the camera.
    while (frames_ == 0 && read())
    {
    }
  }

  std::optional<ImageRecord> next() override
  {
    while (waiting_.empty())
      if (!read()) return std::nullopt;
    ImageRecord first = std::move(waiting_.front());
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
    // A camera that the sensor knows by name, or the only one.
    const bool named = std::find(roles_.begin(), roles_.end(), observation.sensorLabel) != roles_.end();
    const std::string role = named ? observation.sensorLabel : "image";
    if (image) frame.images = {{role, name, pixelsOf(image->image), planarPose(image->cameraPose)}};
    if (stereo)
    {
      if (camera.is_null()) camera = cameraOf(*stereo);
      frame.images = {{"left", name + "_left", pixelsOf(stereo->imageLeft), {}}};
      if (stereo->hasImageRight) frame.images.push_back({"right", name + "_right", pixelsOf(stereo->imageRight), {}});
    }
    waiting_.emplace_back(std::move(frame));
  }

  RawlogReader reader_;
  std::vector<std::string> roles_;
  std::deque<ImageRecord> waiting_;
  int frames_ = 0;
};
}  // namespace

std::unique_ptr<ImageSequence> openImageRawlog(const fs::path& rawlog, const std::vector<std::string>& roles)
{
  return std::make_unique<ImageRawlog>(rawlog, roles);
}
}  // namespace mrpt_ext
