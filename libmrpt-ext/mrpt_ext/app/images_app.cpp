#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <ostream>

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/app/apps.h"
#include "mrpt_ext/app/rawlog_output.h"
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

std::unique_ptr<ImageSequence> openImages(const fs::path& input, const Settings& settings)
{
  if (fs::is_directory(input)) return openImageFolder(input, imageRoles(settings), headingOffset(settings));
  if (fs::is_regular_file(input)) return openImageRawlog(input, imageRoles(settings));
  throw dataError(input.string() + ": not found, expected a folder with frames.csv or a rawlog with images");
}

/// All measurements, to be written at the end.
struct Outcome
{
  Recording recording;
  MeasurementCsv csv;
  int frames = 0, without_measurement = 0, contradictory = 0;
  std::size_t measurements = 0, contradicted = 0;
};

constexpr int kOneInSoMany = 5;  ///< contradictory frames: not a person who walks by, but the cameras

/// Empty when the images agree.
std::string disagreementText(const Outcome& outcome)
{
  if (kOneInSoMany * outcome.contradictory < outcome.frames || outcome.contradictory < 2) return "";
  return "the images disagree in " + std::to_string(outcome.contradictory) + " of " + std::to_string(outcome.frames) +
         " frames: expected cameras that stand as camera.json says, and one mirror that does not move in its image";
}

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
    outcome.contradicted += found.contradicted;
    if (found.contradicted > 0) ++outcome.contradictory;
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

/// The first frames, for constants of the sensor that show in any of them.
std::vector<ImageFrame> firstFrames(ImageSequence& images, std::size_t count)
{
  std::vector<ImageFrame> frames;
  while (frames.size() < count)
  {
    auto record = images.next();
    if (!record) break;
    if (auto* frame = std::get_if<ImageFrame>(&*record)) frames.push_back(std::move(*frame));
  }
  return frames;
}

int convert(const ImageOptions& options, const Settings& settings, AppShell& shell)
{
  const RawlogOutput files = rawlogOutput("images2rawlog", shell.options().output, {options.input});
  const auto images = openImages(options.input, settings);
  const auto front_end = makeFrontEnd(settings, images->camera);
  const auto print = [&](const std::string& line)
  {
    if (!shell.options().quiet) shell.out() << line << '\n';
  };
  const auto tell = [&](const CalibrationNotes& notes)
  {
    for (const std::string& line : notes.results) print(line);
    for (const std::string& line : notes.warnings) shell.err() << line << '\n';
  };
  if (const auto numbers = front_end->calibrationFrames(); !numbers.empty())
    tell(front_end->calibrate(framesAtPose(*openImages(options.input, settings), numbers)));
  if (const std::size_t count = front_end->selfCalibrationFrames(); count > 0)
    tell(front_end->selfCalibrate(firstFrames(*openImages(options.input, settings), count)));
  const Outcome outcome = measureAll(*images, *front_end, options.debug_images, shell.err());
  if (outcome.frames == 0) throw dataError(options.input.string() + ": no images in it");

  if (images->ignored > 0) print(std::to_string(images->ignored) + " records that are no images were left out");
  print(std::to_string(outcome.frames) + " frames, " + std::to_string(outcome.measurements) + " measurements, " +
        std::to_string(outcome.without_measurement) + " frames without measurement" +
        (outcome.contradicted > 0 ? ", " + std::to_string(outcome.contradicted) + " left out that others contradict"
                                  : ""));
  const std::string disagreement = disagreementText(outcome);
  if (!disagreement.empty()) shell.err() << disagreement << '\n';
  writeRawlog(files.rawlog, outcome.recording, disagreement);
  print("wrote " + files.rawlog.string());
  const LandmarkTable map = images->map.empty() ? front_end->landmarks() : images->map;
  if (!map.empty()) writeLandmarkCsv(files.map, map);
  if (!images->truth.empty()) writeTum(files.truth, images->truth);
  if (const auto numbers = front_end->calibratedNumbers(); !numbers.empty())
  {
    writeFileAtomically(files.camera, images->camera.textWith(numbers));
    print("wrote " + files.camera.string() + ", which states this as camera.json of the images");
  }
  if (!options.csv.empty()) writeFileAtomically(options.csv, outcome.csv.text());
  return kExitDone;
}
}  // namespace

int runImages2Rawlog(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err)
{
  AppShell shell({.name = "images2rawlog",
                  .purpose = "Measures landmarks in the images of a camera and writes them as a rawlog.",
                  .examples = {"ini/images2rawlog/conic-mirror.ini -i datasets/conic-mirror -o out/mirror.rawlog",
                               "ini/images2rawlog/stereo.ini -i datasets/stereo-goal -o out/stereo.rawlog "
                               "--debug-images out/seen"}},
                 out, err);
  ImageOptions options;
  shell.commandLine()
      .add({.names = "CONFIG",
            .target = &options.config,
            .help = "Sensor and thresholds, e.g. ini/images2rawlog/conic-mirror.ini",
            .required = true})
      .add({.names = "-i,--input",
            .target = &options.input,
            .help = "Folder with frames.csv and images, or a rawlog with images",
            .required = true})
      .add({.names = "--csv", .target = &options.csv, .help = "Write the measurements as a table"})
      .add({.names = "--debug-images",
            .target = &options.debug_images,
            .help = "Folder for the images with the measurements drawn in"});
  const KeyTable keys = imagesKeys();
  shell.answerQuestionsAbout(keys);
  return shell.run(arguments, [&] { return convert(options, shell.loadSettings(options.config, keys), shell); });
}
}  // namespace mrpt_ext
