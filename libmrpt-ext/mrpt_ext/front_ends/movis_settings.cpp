#include "mrpt_ext/front_ends/movis_settings.h"

#include <cmath>

#include "mrpt_ext/front_ends/images_keys.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
constexpr double kHolderShare = 1.1;  ///< radius of a mirror's holder over that of its rim, when it is not configured

class Reader
{
 public:
  Reader(const Settings& settings, const CameraFile& camera)
      : settings_(settings), file_(camera), of_camera_(settings, kMovisSection, camera)
  {
  }

  [[nodiscard]] double number(const char* key) const { return settings_.number(kMovisSection, key); }
  [[nodiscard]] int whole(const char* key) const { return static_cast<int>(settings_.integer(kMovisSection, key)); }
  [[nodiscard]] const CameraNumbers& ofCamera() const { return of_camera_; }
  [[nodiscard]] int pixels(const char* key, const char* name) const
  {
    return static_cast<int>(of_camera_.optional(key, name).value_or(0));
  }
  [[nodiscard]] std::vector<double> centres() const
  {
    const bool own = settings_.hasValue(kMovisSection, "centres");
    const auto all = own ? settings_.numbers(kMovisSection, "centres") : file_.centres();
    if (!all) throw of_camera_.missing("centres", "centers");
    if (all->size() == 6) return *all;
    if (own) throw settings_.errorAt(kMovisSection, "centres", "expected cx cy of M1, M2 and M3");
    throw dataError("camera.json: centers: expected [cx, cy] of three cameras");
  }
  [[nodiscard]] std::vector<double> several(const char* key, std::size_t count, const char* expected) const
  {
    auto values = settings_.numbers(kMovisSection, key);
    if (values.size() != count) throw settings_.errorAt(kMovisSection, key, std::string("expected ") + expected);
    return values;
  }
  [[nodiscard]] HueSector hues(const char* key) const
  {
    const auto ends = several(key, 2, "the first and the last hue");
    if (!(ends[0] < ends[1])) throw settings_.errorAt(kMovisSection, key, "expected the smaller hue first");
    return {degToRad(ends[0]), degToRad(ends[1])};
  }
  [[nodiscard]] bool has(const char* key) const { return settings_.hasValue(kMovisSection, key); }

 private:
  const Settings& settings_;
  const CameraFile& file_;
  CameraNumbers of_camera_;
};

ColourModel readColours(const Reader& read)
{
  ColourModel model;
  model.orange = read.hues("orange_hue_deg");
  model.yellow = read.hues("yellow_hue_deg");
  model.blue = read.hues("blue_hue_deg");
  model.min_saturation = read.number("min_saturation");
  model.min_brightness = read.number("min_brightness");
  model.white_share = read.number("white_share");
  if (read.has("white_rgb"))
  {
    const auto levels = read.several("white_rgb", 3, "grey levels of red, green and blue");
    cv::Vec3d white;
    for (int c = 0; c < 3; ++c)
      white[c] = linearLight()[static_cast<std::size_t>(std::lround(levels[static_cast<std::size_t>(2 - c)]))];
    model.white = white;
  }
  return model;
}

/// What all three cameras have in common.
OmniCameraSettings readCamera(const Reader& read)
{
  OmniCameraSettings camera;
  camera.image_size = {read.pixels("image_width", "width"), read.pixels("image_height", "height")};
  camera.mirror.a = read.ofCamera().size("mirror_a_m", "a");
  camera.mirror.b = read.ofCamera().size("mirror_b_m", "b");
  camera.mirror.rim_radius = read.ofCamera().size("mirror_rim_radius_m", "rim_radius");
  camera.mirror.focus_height = read.ofCamera().size("mirror_focus_height_m", "focus_height");
  camera.mirror.fx = read.ofCamera().size("focal_length_x_px", "fx");
  camera.mirror.fy = read.ofCamera().size("focal_length_y_px", "fy");
  camera.sizes = {read.ofCamera().fieldSize("pole_radius_m", "pole_radius"),
                  read.ofCamera().fieldSize("pole_height_m", "pole_height"),
                  read.ofCamera().fieldSize("ball_radius_m", "ball_radius")};
  camera.colours = readColours(read);
  camera.search = {read.number("min_distance_m"), read.number("max_distance_m"), read.number("band_share"),
                   read.number("width_tolerance"), read.number("ball_area")};
  camera.columns = read.whole("columns");
  camera.lowest_slope = read.number("lowest_slope");
  camera.rim_visible_share = read.number("rim_visible_share");
  camera.rim_contrast = read.number("rim_contrast");
  camera.min_slices = read.whole("min_slices");
  camera.std_floor = degToRad(read.number("std_floor_deg"));
  return camera;
}

/// The neighbours as a camera sees them in its own image: 30 degrees on either side of the triangle's middle.
std::vector<BlockedSector> neighbours(double holder_radius, double mount_radius)
{
  const double half_width = std::asin(std::min(1.0, holder_radius / (std::sqrt(3.0) * mount_radius)));
  return {{degToRad(30.0), half_width}, {degToRad(-30.0), half_width}};
}
}  // namespace

MovisSettings movisSettings(const Settings& settings, const CameraFile& camera)
{
  const Reader read(settings, camera);
  MovisSettings result;
  result.mount_radius = read.ofCamera().size("mount_radius_m", "L");
  const auto yaw = read.several("mount_yaw_deg", 3, "the angles of M1, M2 and M3");
  const auto centres = read.centres();
  OmniCameraSettings common = readCamera(read);
  const double holder =
      settings.optionalNumber(kMovisSection, "holder_radius_m").value_or(kHolderShare * common.mirror.rim_radius);
  common.blocked = neighbours(holder, result.mount_radius);
  for (std::size_t i = 0; i < 3; ++i)
  {
    result.mount_yaw[i] = degToRad(yaw[i]);
    result.cameras[i] = common;
    result.cameras[i].mirror.centre = {centres[2 * i], centres[2 * i + 1]};
  }
  result.field = {read.ofCamera().fieldSize("field_half_width_m", "Fw"),
                  read.ofCamera().fieldSize("field_depth_m", "Fd")};
  return result;
}
}  // namespace mrpt_ext
