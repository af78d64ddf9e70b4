#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// The plain text format for your own data; the columns of every file are found by their header names.
struct CsvFiles
{
  /// `id,x,y,z,category` (+ optional `std_x,std_y`), or a map of tags in another format: see landmark_map_file.h.
  std::filesystem::path landmarks;
  /// Either `t,x,y,phi_deg`, dead-reckoned poses in a frame of their own, or `t,v,omega_deg_s`, velocities that hold
  /// until the next row and are integrated as arcs. [s, m, deg, m/s, deg/s] Or `t,speed_m_s,steering_rad`, the same for
  /// a car: speed of the rear axle and angle of the front wheels, to the left positive. Empty: no odometry.
  std::filesystem::path odometry;
  /// `t,sensor,id,category,bearing_deg,range_m,std_bearing_deg,std_range_m`; an empty field was not measured or is not
  /// known. Ranges are 3-D distances from the sensor. Rows with one time and sensor are one reading. Optional:
  /// `yaw_deg,std_yaw_deg`, the direction in which the landmark faces, from the sensor's forward axis, and
  /// `other_yaw_deg,other_std_yaw_deg,other_weight`, the attitude that explains the image as well, with its
  /// probability.
  std::filesystem::path detections;
  /// Laser scans, see scan_table.h; empty: none. Without detections they are enough; beside detections they are left
  /// out, with a note, where `sensors` is empty and nothing says where their beams point.
  std::filesystem::path scans;
  /// TUM file, see tum.h; empty: no truth.
  std::filesystem::path ground_truth;
  /// `sensor,x,y,z,yaw_deg`, see sensor_poses.h; empty: all sensors sit at the robot's origin and look forward.
  std::filesystem::path sensors;
  std::optional<double> wheelbase;  ///< [m] distance of the axles, for a car's odometry
  double wheel_offset = 0;  ///< [m] how far to the left of the axle's middle the wheel is that measures the speed
  std::string base;         ///< sensor whose pose becomes the robot's frame; empty: the origin of sensors.csv
};

/// `inputs` is a folder with landmarks.csv (or landmarks.json, tags.yaml), detections.csv or scans.csv, perhaps
/// odometry.csv, sensors.csv and ground_truth.tum, or the paths of LANDMARKS ODOMETRY DETECTIONS [GROUND_TRUTH] in this
/// order. Throws InputError (configuration) on another number of inputs.
[[nodiscard]] CsvFiles findCsvFiles(const std::vector<std::filesystem::path>& inputs);

/// Throws InputError (data), with file and line, on missing files, wrong columns, values out of range and times that
/// descend.
[[nodiscard]] Recording importCsv(const CsvFiles& files);
}  // namespace mrpt_ext
