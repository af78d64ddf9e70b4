#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/trajectory.h"
#include "mrpt_ext/importers/velocity_odometry.h"

namespace mrpt_ext
{
/// The files of one UTIAS MRCLAM data set (Leung, Halpern, Barfoot, Liu: The UTIAS Multi-Robot Cooperative Localization
/// and Mapping Dataset, IJRR 30(8), 2011), each plain or as .gz. Units in the files: s (Unix time), m, rad. Five robots
/// (subjects 1-5) and barcode tubes as landmarks (from subject 6 on). All readers throw InputError (data) with file and
/// line when a file is missing, damaged or not ordered by time.
inline constexpr int kMrclamLastRobot = 5;
inline constexpr const char* kMrclamCategory = "barcode";  ///< of every landmark

/// One row of Robot<n>_Measurement.dat; the camera sits at the robot's origin and looks forward.
struct MrclamMeasurement
{
  double time = 0;
  int barcode = 0;
  double range = 0;    ///< [m]
  double bearing = 0;  ///< [rad] CCW
};

/// Landmark_Groundtruth.dat: positions with their standard deviations.
[[nodiscard]] LandmarkTable readMrclamLandmarks(const std::filesystem::path& folder);
/// Barcodes.dat: subject by barcode.
[[nodiscard]] std::map<int, int> readMrclamBarcodes(const std::filesystem::path& folder);
/// Robot<n>_Measurement.dat. Here and below, rows that go back in time are sorted in, with a warning in `notes` each.
[[nodiscard]] std::vector<MrclamMeasurement> readMrclamMeasurements(const std::filesystem::path& folder, int robot,
                                                                    std::vector<std::string>& notes);
/// Robot<n>_Odometry.dat, commanded velocities; nothing when the data set has no such file.
[[nodiscard]] std::optional<std::vector<VelocityRecord>> readMrclamVelocities(const std::filesystem::path& folder,
                                                                              int robot,
                                                                              std::vector<std::string>& notes);
/// Robot<n>_Groundtruth.dat, the motion capture's poses; nothing when the data set has no such file.
[[nodiscard]] std::optional<Trajectory> readMrclamTruth(const std::filesystem::path& folder, int robot,
                                                        std::vector<std::string>& notes);
/// GroundtruthSparse.csv: the pose of a robot while it stood still, put at the middle of each interval
/// [t_begin, t_end]; nothing when the data set has no such file. Of intervals with the same middle the first
/// is kept.
[[nodiscard]] std::optional<Trajectory> readMrclamSparseTruth(const std::filesystem::path& folder, int robot);
}  // namespace mrpt_ext
