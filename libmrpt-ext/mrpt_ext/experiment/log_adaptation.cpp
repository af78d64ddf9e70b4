#include "mrpt_ext/experiment/log_adaptation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mrpt_ext/geometry/formatted.h"

namespace mrpt_ext
{
namespace
{
void widenRegion(LocalizationConfig& config, double margin, std::vector<std::string>& notes)
{
  PoseRegion& region = config.filter.region;
  if (!config.region_assumed || !(margin > kRegionMargin)) return;
  region.low.array() -= margin - kRegionMargin;
  region.high.array() += margin - kRegionMargin;
  config.running_fix.region = region;
  notes.push_back(formatted(
      "possible positions: up to %.1f m outside the map, as far as the detections allow (init_PDF_margin_m)", margin));
}

void narrowFieldsOfView(LocalizationConfig& config, const BearingExtent& extent, std::vector<std::string>& notes)
{
  for (const auto& [label, field_of_view] : extent.fieldsOfView())
  {
    SensorConfig sensor = configOf(config.frames.sensors, label);
    sensor.field_of_view = field_of_view;
    config.frames.sensors[label] = sensor;
    notes.push_back(
        formatted("%s: all its bearings are within %.0f deg, which is taken for its field of view "
                  "([Sensor_%s] field_of_view_deg)",
                  label.c_str(), radToDeg(field_of_view), label.c_str()));
  }
}
}  // namespace

double stationaryStd(double walk, double information)
{
  return information > 0 ? std::pow(walk / information, 0.25) : std::numeric_limits<double>::infinity();
}

void adaptToLog(LocalizationConfig& config, const LogContents& log, std::vector<std::string>& notes)
{
  if (config.frames.independent) return;
  widenRegion(config, log.reach.metres(), notes);
  if (config.auto_calibrate && log.available.anonymous_bearing) narrowFieldsOfView(config, log.extent, notes);
  if (log.available.odometry) return;
  ParticleFilterOptions& filter = config.filter;
  if (filter.motion.type != MotionType::random_walk)
  {
    filter.motion = config.running_fix.motion = walkingSpeedRandomWalk();
    notes.push_back(formatted(
        "no odometry in the log: the motion is taken for a random walk of %.1f m and %.0f deg after one second "
        "([MotionModel] type = random_walk, std_xy_per_sqrt_s, std_phi_deg_per_sqrt_s)",
        filter.motion.std_xy_per_s, radToDeg(filter.motion.std_phi_per_s)));
  }
  const double information = log.available.heading_information / std::max(log.duration, 1.0);
  if (stationaryStd(square(filter.motion.std_phi_per_s), information) <= filter.verdict.max_std_phi) return;
  filter.heading_observable = false;
  filter.modes.cell_phi = kTwoPi;
  filter.verdict.max_std_phi = std::numeric_limits<double>::infinity();
  notes.emplace_back(
      "nothing in the log tells the heading (no odometry, and ranges to the robot's origin or near it): positions are "
      "estimated and judged, headings are unknown");
}
}  // namespace mrpt_ext
