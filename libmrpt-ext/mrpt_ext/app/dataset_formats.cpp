#include "mrpt_ext/app/dataset_formats.h"

#include <algorithm>

#include "mrpt_ext/files/landmark_map_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/csv_recording.h"
#include "mrpt_ext/importers/cuhksz.h"
#include "mrpt_ext/importers/labyrinth.h"
#include "mrpt_ext/importers/mrclam.h"
#include "mrpt_ext/importers/mrclam_snapshots.h"
#include "mrpt_ext/importers/plaza.h"
#include "mrpt_ext/importers/roh.h"
#include "mrpt_ext/importers/rosbag2/rosbag2_recording.h"
#include "mrpt_ext/importers/uwb_demo_map.h"
#include "mrpt_ext/rawlog/slam_demo_import.h"
#include "mrpt_ext/rawlog/uwb_demo_import.h"
#include "mrpt_ext/settings/name_suggestion.h"

namespace mrpt_ext
{
namespace
{
struct DatasetFormat
{
  std::string name;
  std::string inputs;  ///< in words, for help and errors
  std::size_t least_inputs, most_inputs;
  bool takes_robot, takes_origin;
  Recording (*import)(const DatasetRequest&);
};

Recording readMrclam(const DatasetRequest& request)
{
  if (request.robot) return importMrclam(request.inputs[0], *request.robot);
  std::string robots;
  for (const int robot : mrclamRobots(request.inputs[0])) robots += ' ' + std::to_string(robot);
  throw configurationError("mrclam: no robot chosen, expected --robot with one of" +
                           (robots.empty() ? " 1 2 3 4 5" : robots));
}

Recording readMrclamSnapshots(const DatasetRequest& request)
{
  return importMrclamSnapshots(request.inputs[0], request.robot);
}

Recording readUwbDemo(const DatasetRequest& request)
{
  const std::filesystem::path truth = request.inputs.size() > 1 ? request.inputs[1] : std::filesystem::path();
  return importUwbDemo(request.inputs[0], truth, request.truth_origin.value_or(kUwbDemoStart),
                       request.map.empty() ? uwbDemoMap() : readLandmarkMapFile(request.map));
}

Recording readKfSlamDemo(const DatasetRequest& request) { return importKfSlamDemo(request.inputs); }
Recording readRoSlamDemo(const DatasetRequest& request) { return importRoSlamDemo(request.inputs); }
Recording readRoh(const DatasetRequest& request) { return importRoh(request.inputs[0]); }
Recording readPlaza(const DatasetRequest& request) { return importPlaza(request.inputs[0]); }
Recording readLabyrinth(const DatasetRequest& request) { return importLabyrinth(request.inputs[0]); }
Recording readCuhksz(const DatasetRequest& request) { return importCuhksz(request.inputs[0]); }
Recording readRosbag2(const DatasetRequest& request)
{
  Rosbag2Options options{.topics = {}, .base = request.base, .map = request.map};
  for (const std::string& topic : request.topics) addTopicRequest(options.topics, topic);
  return importRosbag2(request.inputs, options);
}

Recording readCsv(const DatasetRequest& request)
{
  CsvFiles files = findCsvFiles(request.inputs);
  files.wheelbase = request.wheelbase;
  files.wheel_offset = request.wheel_offset.value_or(0);
  files.base = request.base;
  return importCsv(files);
}

const std::vector<DatasetFormat>& formats()
{
  static const std::vector<DatasetFormat> kFormats = {
      {"csv",
       "a folder with landmarks.csv, odometry.csv, detections.csv or scans.csv (and ground_truth.tum), or these "
       "files",
       1, 4, false, false, readCsv},
      {"cuhksz", "folder with UWB_<run>.csv (and motion_capture_<run>.csv), or FOLDER/RUN", 1, 1, false, false,
       readCuhksz},
      {"labyrinth", "folder with <run>_Input.txt (and <run>_GT.txt), or FOLDER/RUN", 1, 1, false, false, readLabyrinth},
      {"mrclam", "folder of a UTIAS MRCLAM data set; needs --robot", 1, 1, true, false, readMrclam},
      {"mrclam-snapshots", "folder of a UTIAS MRCLAM data set with Snapshots.csv", 1, 1, true, false,
       readMrclamSnapshots},
      {"mrpt-kf-slam",
       "log of MRPT's kf-slam_demo or simul-landmarks (and <log>_ground_truth.txt, "
       "<log>_ground_truth_robot_path.txt, if not beside it)",
       1, 3, false, false, readKfSlamDemo},
      {"mrpt-ro-slam", "MRPT's RO-SLAM_demo.rawlog (and <log>_ground_truth.txt, if not beside it)", 1, 2, false, false,
       readRoSlamDemo},
      {"mrpt-uwb", "MRPT's uwb_ro-localization_demo.rawlog (and its truth file)", 1, 2, false, true, readUwbDemo},
      {"plaza", "folder with <run>_TD.txt, <run>_DR.txt, <run>_TL.txt (and <run>_GT.txt), or FOLDER/RUN", 1, 1, false,
       false, readPlaza},
      {"roh", "folder with landmark.csv and files (Xx,Yy).csv of bearings", 1, 1, false, false, readRoh},
      {"rosbag2", "folder of a ROS 2 bag, or its files (.mcap, .db3); needs --map", 1, 1000, false, false,
       readRosbag2}};
  return kFormats;
}

const DatasetFormat& findFormat(const std::string& name)
{
  const auto found = std::find_if(formats().begin(), formats().end(),
                                  [&](const DatasetFormat& format) { return format.name == name; });
  if (found != formats().end()) return *found;
  std::string message = "unknown format '" + name + "', expected one of";
  for (const std::string& known : datasetFormats()) message += ' ' + known;
  if (const auto similar = closestName(name, datasetFormats())) message += " (did you mean " + *similar + "?)";
  throw configurationError(message);
}

void checkRequest(const DatasetRequest& request, const DatasetFormat& format)
{
  const std::size_t count = request.inputs.size();
  if (count < format.least_inputs || count > format.most_inputs)
    throw configurationError(format.name + ": " + std::to_string(count) + " inputs, expected " + format.inputs);
  if (request.robot && !format.takes_robot)
    throw configurationError(format.name + ": has no robots to choose from, expected no --robot");
  if ((request.wheelbase || request.wheel_offset) && format.name != "csv")
    throw configurationError(format.name + ": has no steering angles, expected no --wheelbase and no --wheel-offset");
  const bool is_bag = format.name == "rosbag2";
  if ((!request.map.empty() && !format.takes_origin && !is_bag) || (request.truth_origin && !format.takes_origin))
    throw configurationError(format.name + ": brings its own map and frame, expected no --map and no --truth-origin");
  if (!request.topics.empty() && !is_bag)
    throw configurationError(format.name + ": has no topics, expected no --topic");
  if (!request.base.empty() && !is_bag && format.name != "csv")
    throw configurationError(format.name + ": has one frame of the robot, expected no --base");
  if (!request.map.empty() && !std::filesystem::exists(request.map))
    throw dataError("--map " + request.map.string() + ": no such file");
}
}  // namespace

std::vector<std::string> datasetFormats()
{
  std::vector<std::string> names;
  for (const DatasetFormat& format : formats()) names.push_back(format.name);
  return names;
}

std::string describeDatasetFormats()
{
  std::string text = "FORMAT and its INPUT:\n";
  for (const DatasetFormat& format : formats()) text += "  " + format.name + ": " + format.inputs + '\n';
  return text;
}

Recording importDataset(const DatasetRequest& request)
{
  const DatasetFormat& format = findFormat(request.format);
  checkRequest(request, format);
  Recording recording = format.import(request);
  keepMeasurements(recording, request.measurements);
  hideIdentity(recording, request.identity);
  return recording;
}
}  // namespace mrpt_ext
