#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/solvers/movis_frame.h"
#include "mrpt_ext/solvers/omni_stereo.h"
#include "mrpt_ext/solvers/two_pole_pose.h"

// Azimuths of paper 001's three cameras, as images2rawlog's table has them, and the truth that comes with the images.
namespace mrpt_ext::testing
{
/// Where things truly were in one frame.
struct MovisTruth
{
  Pose2 robot;             ///< our frame: heading of the forward axis
  Vector2d ball_in_robot;  ///< our frame
};

struct MovisScene
{
  double mount_radius = 0;
  PoleField field;
  Vector2d ball{0, 0};
  std::map<int, MovisTruth> frames;

  explicit MovisScene(const std::filesystem::path& folder)
  {
    const auto camera = nlohmann::json::parse(readTextFile(folder / "camera.json"));
    mount_radius = camera["camera"]["L"];
    field = {camera["field"]["Fw"], camera["field"]["Fd"]};
    ball = {camera["field"]["ball"][0].get<double>(), camera["field"]["ball"][1].get<double>()};
    const TextTable table(folder / "frames.csv", {});
    const auto number = [&](std::size_t row, const char* name) { return table.number(row, table.column(name)); };
    for (std::size_t row = 0; row < table.size(); ++row)
      frames[table.integer(row, table.column("frame"))] = {
          {number(row, "x_m"), number(row, "y_m"), headingFromSlope(degToRad(number(row, "heading_deg")))},
          robotFromMovis({number(row, "ball_xr_m"), number(row, "ball_yr_m")})};
  }
};

/// A line of sight in the robot's frame and the camera it belongs to.
struct MovisSight
{
  int camera = 0;
  SightRay ray;
};

/// Lines of sight of each frame by label ("p", "q", "ball").
using MovisSights = std::map<int, std::map<std::string, std::vector<MovisSight>>>;

inline MovisSights readMovisSights(const std::filesystem::path& csv, double mount_radius)
{
  MovisSights sights;
  const TextTable table(csv, {});
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const int camera = table.text(row, table.column("sensor")).back() - '0';
    const SightRay ray{robotFromMovis(movisCamera(camera, mount_radius)->position),
                       degToRad(table.number(row, table.column("azimuth_deg"))),
                       degToRad(table.number(row, table.column("std_azimuth_deg")))};
    sights[table.integer(row, table.column("frame"))][table.text(row, table.column("label"))].push_back({camera, ray});
  }
  return sights;
}

/// Where the lines of the pair of cameras that sees it best meet, in the robot's frame.
inline std::optional<Vector2d> bestMeeting(const std::vector<MovisSight>& sights)
{
  std::optional<GaussianPoint> best;
  for (std::size_t i = 0; i < sights.size(); ++i)
    for (std::size_t j = i + 1; j < sights.size(); ++j)
      if (const auto meeting = triangulate(sights[i].ray, sights[j].ray); meeting.status == SolveStatus::ok)
        if (!best || meeting.point.covariance.trace() < best->covariance.trace()) best = meeting.point;
  if (!best) return std::nullopt;
  return best->mean;
}
}  // namespace mrpt_ext::testing
