#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/geometry/pose.h"

// The table of `images2rawlog --csv` beside the truth of a rendered stereo scene.
namespace mrpt_ext::testing
{
struct LineScore
{
  int visible = 0, found = 0;
};

struct StereoScore
{
  int visible = 0, found = 0;  ///< goal corners seen by both cameras
  int false_corners = 0;       ///< reported where none is
  double range_errors = 0;     ///< [m] sum of absolute values
  LineScore near, far;         ///< line landmarks within 0.35 m, and from there to 0.6 m
  int false_landmarks = 0;     ///< line landmarks that explain none within sight
  [[nodiscard]] double meanRangeError() const { return range_errors / found; }
};

struct SeenRow
{
  std::string label;
  double range = 0, u_left = 0, u_right = 0;
  bool explained = false;
};

using SeenByFrame = std::map<int, std::vector<SeenRow>>;

inline SeenByFrame rowsOf(const std::filesystem::path& csv)
{
  const TextTable table(csv, {});
  SeenByFrame rows;
  for (std::size_t i = 0; i < table.size(); ++i)
    rows[table.integer(i, table.column("frame"))].push_back(
        {table.text(i, table.column("label")), table.number(i, table.column("range_m")),
         table.number(i, table.column("u_left")), table.number(i, table.column("u_right")), false});
  return rows;
}

/// [m] horizontally from the left camera of each frame.
class RangeFromLeft
{
 public:
  explicit RangeFromLeft(const std::filesystem::path& scene)
  {
    std::ifstream file(scene / "camera.json");
    const auto camera = nlohmann::json::parse(file).at("stereo");
    width_ = camera.at("width");
    const Pose2 mount{camera.at("forward"), 0.5 * camera.at("baseline").get<double>(), 0};
    const TextTable frames(scene / "frames.csv", {});
    for (std::size_t i = 0; i < frames.size(); ++i)
      cameras_[frames.integer(i, frames.column("frame"))] =
          compose({frames.number(i, frames.column("x_m")), frames.number(i, frames.column("y_m")),
                   degToRad(frames.number(i, frames.column("heading_deg")))},
                  mount);
  }
  [[nodiscard]] double operator()(int frame, double x, double y) const
  {
    const Pose2& camera = cameras_.at(frame);
    return std::hypot(x - camera.x, y - camera.y);
  }
  /// [px] columns this far apart belong to different features.
  [[nodiscard]] double columnTolerance() const { return 4 * width_ / 320.0; }

 private:
  double width_ = 0;
  std::map<int, Pose2> cameras_;
};

inline void scoreCorners(StereoScore& score, SeenByFrame& seen, const std::filesystem::path& scene,
                         const RangeFromLeft& range)
{
  const TextTable truth(scene / "observations.csv", {});
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const auto value = [&](const char* column) { return std::atof(truth.text(i, truth.column(column)).c_str()); };
    const int frame = truth.integer(i, truth.column("frame"));
    const bool visible = truth.integer(i, truth.column("visible_both")) != 0;
    score.visible += visible;
    for (SeenRow& row : seen[frame])
    {
      if (row.label != truth.text(i, truth.column("landmark"))) continue;
      if (!(std::abs(row.u_left - value("uL")) < range.columnTolerance()) ||
          !(std::abs(row.u_right - value("uR")) < range.columnTolerance()))
        continue;
      row.explained = true;
      if (!visible) continue;
      ++score.found;
      score.range_errors += std::abs(row.range - range(frame, value("lx_m"), value("ly_m")));
    }
  }
  for (const auto& [frame, rows] : seen)
    score.false_corners += static_cast<int>(std::count_if(
        rows.begin(), rows.end(), [](const SeenRow& row) { return row.label.size() > 1 && !row.explained; }));
}

inline void scoreLines(StereoScore& score, SeenByFrame& seen, const std::filesystem::path& scene,
                       const RangeFromLeft& range)
{
  const TextTable truth(scene / "line_points.csv", {});
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const auto value = [&](const char* column) { return std::atof(truth.text(i, truth.column(column)).c_str()); };
    if (truth.integer(i, truth.column("visible_both")) == 0) continue;
    const int frame = truth.integer(i, truth.column("frame"));
    const double true_range = range(frame, value("fx_m"), value("fy_m"));
    LineScore none;
    LineScore& bin = true_range <= 0.35 ? score.near : true_range <= 0.6 ? score.far : none;
    ++bin.visible;
    const auto found = std::find_if(seen[frame].begin(), seen[frame].end(),
                                    [&](const SeenRow& row)
                                    {
                                      return row.label == truth.text(i, truth.column("point")).substr(0, 1) &&
                                             std::abs(row.u_left - value("uL")) < range.columnTolerance() &&
                                             std::abs(row.u_right - value("uR")) < range.columnTolerance() &&
                                             std::abs(row.range - true_range) < 0.1 * true_range;
                                    });
    if (found == seen[frame].end()) continue;
    found->explained = true;
    ++bin.found;
  }
  for (const auto& [frame, rows] : seen)
    score.false_landmarks += static_cast<int>(std::count_if(
        rows.begin(), rows.end(), [](const SeenRow& row) { return row.label.size() == 1 && !row.explained; }));
}

inline StereoScore scoreStereo(const std::filesystem::path& csv, const std::filesystem::path& scene)
{
  SeenByFrame seen = rowsOf(csv);
  const RangeFromLeft range(scene);
  StereoScore score;
  scoreCorners(score, seen, scene, range);
  scoreLines(score, seen, scene, range);
  return score;
}
}  // namespace mrpt_ext::testing
