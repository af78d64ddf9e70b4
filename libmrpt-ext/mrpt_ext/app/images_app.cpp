#include "mrpt_ext/app/images_app.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <ostream>

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/front_ends/front_end_factory.h"
#include "mrpt_ext/front_ends/images_keys.h"
#include "mrpt_ext/front_ends/measurement_csv.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

struct ImageOptions
{
  fs::path config, input, csv, debug_images;
};

fs::path beside(const fs::path& rawlog, const std::string& ending)
{
  return rawlog.parent_path() / (rawlog.stem().string() + ending);
}

void checkOutput(const fs::path& rawlog)
{
  if (rawlog.empty()) throw configurationError("images2rawlog: -o/--output is missing, expected STEM.rawlog");
  if (rawlog.extension() != ".rawlog")
    throw configurationError("images2rawlog: --output " + rawlog.string() + ": expected a name ending in .rawlog");
}

std::unique_ptr<ImageSequence> openImages(const fs::path& input, const Settings& settings)
{
  if (fs::is_directory(input)) return openImageFolder(input, imageRoles(settings), headingOffset(settings));
  if (fs::is_regular_file(input)) return openImageRawlog(input, imageRoles(settings));
  throw dataError(input.string() + ": not found, expected a folder with frames.csv or a rawlog with images");
}

/// Everything the images gave, to be written at the end.
struct Outcome
{
  Recording recording;
  MeasurementCsv csv;
  int frames = 0, without_measurement = 0;
  std::size_t measurements = 0;
};

void writeDrawings(const fs::path& folder, const std::vector<DebugImage>& drawings)
{
  for (const DebugImage& drawing : drawings)
  {
    if (drawing.pixels.empty()) continue;
    const fs::path file = folder / (fs::path(drawing.name).stem().string() + ".png");
    std::vector<unsigned char> bytes;
    cv::imencode(".png", drawing.pixels, bytes);
    writeFileAtomically(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
}

Outcome measureAll(ImageSequence& images, const VisionFrontEnd& front_end, const fs::path& debug_images,
                   std::ostream& err)
{
  Outcome outcome;
  while (auto record = images.next())
  {
    if (const auto* odometry = std::get_if<OdometryRecord>(&*record))
    {
      outcome.recording.records.emplace_back(*odometry);
      continue;
    }
    const auto& frame = std::get<ImageFrame>(*record);
    FrameMeasurements found = front_end.measure(frame, !debug_images.empty());
    ++outcome.frames;
    if (found.rows.empty()) ++outcome.without_measurement;
    outcome.measurements += found.rows.size();
    for (const std::string& problem : found.problems) err << problem << ", no measurement\n";
    for (Reading& reading : found.readings) outcome.recording.records.emplace_back(std::move(reading));
    outcome.csv.add(frame, found.rows);
    writeDrawings(debug_images, found.drawings);
  }
  return outcome;
}

/// The frames with these numbers and their poses; a first pass over the images.
std::vector<FrameAtPose> framesAtPose(ImageSequence& images, const std::vector<int>& numbers)
{
  std::vector<FrameAtPose> found;
  while (auto record = images.next())
    if (auto* frame = std::get_if<ImageFrame>(&*record))
      for (const TimedPose& truth : images.truth)
        if (truth.time == frame->time && std::count(numbers.begin(), numbers.end(), frame->number) > 0)
          found.push_back({std::move(*frame), truth.pose});
  if (found.size() < numbers.size())
    throw configurationError("calibration_frame: not all of these frames are there with a pose in frames.csv");
  return found;
}

int convert(const ImageOptions& files, const CommonOptions& options, std::ostream& out, std::ostream& err)
{
  const Settings settings = Settings::load(files.config, imagesKeys(), options.overrides);
  checkOutput(options.output);
  const auto images = openImages(files.input, settings);
  const auto front_end = makeFrontEnd(settings, images->camera);
  const auto tell = [&](const std::string& line)
  {
    if (!options.quiet) out << line << '\n';
  };
  if (const auto numbers = front_end->calibrationFrames(); !numbers.empty())
    for (const std::string& line : front_end->calibrate(framesAtPose(*openImages(files.input, settings), numbers)))
      tell(line);
  const Outcome outcome = measureAll(*images, *front_end, files.debug_images, err);
  if (outcome.frames == 0) throw dataError(files.input.string() + ": no images in it");

  if (images->ignored > 0) tell(std::to_string(images->ignored) + " records that are no images were left out");
  tell(std::to_string(outcome.frames) + " frames, " + std::to_string(outcome.measurements) + " measurements, " +
       std::to_string(outcome.without_measurement) + " frames without measurement");
  writeRawlog(options.output, outcome.recording);
  tell("wrote " + options.output.string());
  const LandmarkTable map = images->map.empty() ? front_end->landmarks() : images->map;
  if (!map.empty()) writeLandmarkCsv(beside(options.output, "_map.csv"), map);
  if (!images->truth.empty()) writeTum(beside(options.output, "_ground_truth.tum"), images->truth);
  if (!files.csv.empty()) writeFileAtomically(files.csv, outcome.csv.text());
  return kExitDone;
}
}  // namespace

int ImagesApp::run(const std::vector<std::string>& arguments)
{
  AppShell shell("images2rawlog", "Measures in the images of a camera and writes what they show as a rawlog.", out_,
                 err_);
  ImageOptions files;
  shell.cli().add_option("CONFIG", files.config, "Sensor and thresholds, e.g. conic-mirror.ini")->required();
  shell.cli()
      .add_option("-i,--input", files.input, "Folder with frames.csv and images, or a rawlog with images")
      ->required();
  shell.cli().add_option("--csv", files.csv, "Write the measurements as a table");
  shell.cli().add_option("--debug-images", files.debug_images, "Folder for the images with what was found drawn in");
  shell.answerQuestionsAbout(imagesKeys());
  return shell.run(arguments, [&] { return convert(files, shell.options(), out_, err_); });
}
}  // namespace mrpt_ext
