#pragma once

#include <filesystem>
#include <vector>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// The plain text format for your own data; the columns of every file are found by their header names.
struct CsvFiles
{
  /// `id,x,y,z,category` (+ optional `std_x,std_y`), see landmark_csv.h.
  std::filesystem::path landmarks;
  /// Either `t,x,y,phi_deg`, dead-reckoned poses in a frame of their own, or `t,v,omega_deg_s`, velocities that hold
  /// until the next row and are integrated as arcs. [s, m, deg, m/s, deg/s] Empty: no odometry.
  std::filesystem::path odometry;
  /// `t,sensor,id,category,bearing_deg,range_m,std_bearing_deg,std_range_m`; an empty field was not measured or is not
  /// known. The sensor sits at the robot's origin and looks forward; ranges are 3-D distances from there. Rows with one
  /// time and sensor are one reading.
  std::filesystem::path detections;
  /// TUM file, see tum.h; empty: no truth.
  std::filesystem::path ground_truth;
};

/// `inputs` is a folder with landmarks.csv, detections.csv, perhaps odometry.csv and ground_truth.tum, or the paths of
/// three or four such files in this order. Throws InputError (configuration) on another number of inputs.
[[nodiscard]] CsvFiles findCsvFiles(const std::vector<std::filesystem::path>& inputs);

/// Throws InputError (data), with file and line, on missing files, wrong columns, values out of range and times that
/// descend.
[[nodiscard]] Recording importCsv(const CsvFiles& files);
}  // namespace mrpt_ext
