#include <algorithm>
#include <cmath>
#include <fstream>

#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/front_ends/image_file.h"
#include "mrpt_ext/front_ends/image_frame.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

/// Columns of x [m], y [m] and heading [deg]; nothing when the table has none of them.
class PoseColumns
{
 public:
  PoseColumns(const TextTable& table, const std::string& prefix, double heading_offset)
      : table_(table), heading_offset_(heading_offset)
  {
    const std::vector<std::string> names{prefix + "x_m", prefix + "y_m", prefix + "heading_deg"};
    for (const std::string& name : names) present_ = present_ || table.findColumn(name).has_value();
    if (!present_) return;
    for (const std::string& name : names) columns_.push_back(table.column(name));
  }
  [[nodiscard]] std::optional<Pose2> at(std::size_t row) const
  {
    if (!present_) return std::nullopt;
    return Pose2{table_.coordinate(row, columns_[0]), table_.coordinate(row, columns_[1]),
                 wrap(degToRad(table_.number(row, columns_[2])) + heading_offset_)};
  }

 private:
  const TextTable& table_;
  double heading_offset_;
  bool present_ = false;
  std::vector<std::size_t> columns_;
};

/// Files of a role: in the column of its name, else those named *_POINT_ROLE.* by the column `point`.
class ImageNames
{
 public:
  ImageNames(const fs::path& folder, const TextTable& table) : table_(table), point_(table.findColumn("point"))
  {
    if (!point_) return;
    for (const auto& entry : fs::directory_iterator(folder))
      if (const std::string type = entry.path().extension().string(); type == ".jpg" || type == ".png")
        files_.push_back(entry.path().filename().string());
    std::sort(files_.begin(), files_.end());
  }
  /// Where cameras are known by their files alone, one without any image is not mounted.
  [[nodiscard]] bool has(const std::string& role) const
  {
    if (table_.findColumn(role) || !point_) return true;
    for (std::size_t row = 0; row < table_.size(); ++row)
      if (!at(row, role).empty()) return true;
    return false;
  }
  /// Empty when there is none.
  [[nodiscard]] std::string at(std::size_t row, const std::string& role) const
  {
    if (!point_ || table_.findColumn(role)) return table_.text(row, table_.column(role));
    const std::string ending = "_" + table_.text(row, *point_) + "_" + role;
    for (const std::string& file : files_)
      if (fs::path(file).stem().string().ends_with(ending)) return file;
    return "";
  }

 private:
  const TextTable& table_;
  std::optional<std::size_t> point_;
  std::vector<std::string> files_;
};

LandmarkTable readMap(const fs::path& file)
{
  if (!fs::exists(file)) return {};
  const TextTable table(file, {});
  std::vector<Landmark> landmarks;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    Landmark landmark;
    landmark.id = table.integer(row, table.column("id"));
    landmark.position = {table.coordinate(row, table.column("x_m")), table.coordinate(row, table.column("y_m")), 0};
    if (const auto category = table.findColumn("category")) landmark.category = table.text(row, *category);
    if (const auto yaw = table.findColumn("yaw_deg"); yaw && !table.text(row, *yaw).empty())
      landmark.yaw = wrap(degToRad(table.number(row, *yaw)));
    landmarks.push_back(landmark);
  }
  return LandmarkTable(landmarks);
}

class ImageFolder : public ImageSequence
{
 public:
  ImageFolder(const fs::path& folder, const std::vector<std::string>& roles, double heading_offset)
      : folder_(folder),
        table_(folder / "frames.csv", {}),
        names_(folder, table_),
        odometry_(table_, "odometry_", heading_offset)
  {
    camera = CameraFile::read(folder / "camera.json");
    map = readMap(folder / "map.csv");
    for (const std::string& role : roles)
    {
      if (!names_.has(role)) continue;
      roles_.push_back(role);
      if (table_.size() > 0) static_cast<void>(names_.at(0, role));  // reports a missing column
    }
    const PoseColumns poses(table_, "", heading_offset);
    for (std::size_t row = 0; row < table_.size(); ++row)
    {
      if (row > 0 && !(timeOf(row) > timeOf(row - 1))) throw table_.errorAt(row, "time does not ascend");
      if (const auto pose = poses.at(row)) truth.push_back({timeOf(row), *pose, true});
    }
  }

  std::optional<ImageRecord> next() override
  {
    if (row_ == table_.size()) return std::nullopt;
    if (const auto odometry = odometry_.at(row_); odometry && !odometry_done_)
    {
      odometry_done_ = true;
      return OdometryRecord{timeOf(row_), *odometry};
    }
    odometry_done_ = false;
    return frameAt(row_++);
  }

 private:
  [[nodiscard]] double timeOf(std::size_t row) const
  {
    const auto column = table_.findColumn("t");
    return table_.number(row, column ? *column : table_.column("frame"));
  }
  [[nodiscard]] ImageFrame frameAt(std::size_t row) const
  {
    ImageFrame frame{table_.integer(row, table_.column("frame")), timeOf(row), {}};
    for (const std::string& role : roles_)
    {
      const std::string name = names_.at(row, role);
      ImageContent content = name.empty() ? ImageContent() : readImageFile(folder_ / name);
      frame.images.push_back({role, name, std::move(content.pixels), {}, std::move(content.problem)});
    }
    return frame;
  }

  fs::path folder_;
  TextTable table_;
  ImageNames names_;
  std::vector<std::string> roles_;
  PoseColumns odometry_;
  std::size_t row_ = 0;
  bool odometry_done_ = false;  ///< of this row
};
}  // namespace

std::string ImageFrame::nameOf(const FrameImage& image) const
{
  return image.name.empty() ? "frame " + std::to_string(number) + " " + image.role : image.name;
}

const FrameImage* ImageFrame::find(const std::string& role) const
{
  for (const FrameImage& image : images)
    if (image.role == role) return &image;
  return nullptr;
}

std::unique_ptr<ImageSequence> openImageFolder(const fs::path& folder, const std::vector<std::string>& roles,
                                               double heading_offset)
{
  return std::make_unique<ImageFolder>(folder, roles, heading_offset);
}
}  // namespace mrpt_ext
