#include <mrpt/img/CImage.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationStereoImages.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <deque>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/pipeline/image_frame.h"
#include "mrpt_ext/pipeline/rawlog_reader.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

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

class ImageRawlog : public ImageSequence
{
 public:
  ImageRawlog(const fs::path& rawlog, std::vector<std::string> roles) : reader_(rawlog), roles_(std::move(roles))
  {
    mrpt::img::CImage::setImagesPathBase(mrpt::obs::CRawlog::detectImagesDirectory(rawlog.string()));
  }

  std::optional<ImageRecord> next() override
  {
    while (waiting_.empty())
    {
      const auto record = reader_.next();
      if (!record) return std::nullopt;
      if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(record))
        for (const auto& observation : *frame) add(*observation);
      else if (const auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(record))
        add(*observation);
      else
        ++ignored;
    }
    ImageRecord first = std::move(waiting_.front());
    waiting_.pop_front();
    return first;
  }

 private:
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
