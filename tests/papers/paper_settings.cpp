#include "paper_settings.h"

namespace mrpt_ext::papers
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr ValueRange kNotNegative{0, kInfinity};
constexpr ValueRange kPositive{1e-9, kInfinity};

KeySpec number(const char* section, const char* name, const char* unit, ValueRange range, const char* help)
{
  return {section, name, KeyType::number, unit, "", range, {}, help};
}
KeySpec numbers(const char* section, const char* name, const char* unit, const char* help)
{
  return {section, name, KeyType::numbers, unit, "", {}, {}, help};
}
KeySpec integer(const char* section, const char* name, const char* help)
{
  return {section, name, KeyType::integer, "", "", {1, 1e9}, {}, help};
}

KeyTable treeKeys()
{
  const char* const s = "Tree";
  return {{
      integer(s, "landmarks", "Landmarks of the random map, a square of 10 m."),
      numbers(s, "observations", "", "Numbers of observations."),
      number(s, "gate_deg", "deg", kPositive, "Largest difference between a measured and a predicted bearing."),
      number(s, "std_bearing_deg", "deg", kNotNegative, "Noise of the bearings."),
  }};
}

KeyTable movisKeys()
{
  const char* const s = "Movis";
  const char* const scan = "YawScan";
  return {{
      number(s, "half_width_m", "m", kPositive, "Fw: the poles are at x = -Fw and Fw."),
      number(s, "depth_m", "m", kPositive, "Fd: y of both poles."),
      numbers(s, "ball", "m", "x y of the object."),
      {s, "points", KeyType::text, "", "", {}, {}, "Names of the lattice points, one letter each."},
      numbers(s, "places", "m", "x y of every lattice point."),
      {s, "origin", KeyType::text, "", "", {}, {}, "The point at which eq 8 and the yaw calibration are made."},
      number(s, "mount_radius_m", "m", kPositive, "L: from the robot's centre to each camera."),
      number(s, "std_bearing_deg", "deg", kNotNegative, "Noise of the azimuths."),
      numbers(s, "yaw_deg", "deg", "Mounting errors of the cameras M1 and M2."),
      numbers(scan, "std_bearing_deg", "deg", "Noises to try."),
      numbers(scan, "common_deg", "deg", "Turns of both cameras together to try."),
      numbers(scan, "difference_deg", "deg", "Turns of M2 against M1 to try."),
      integer(scan, "trials", "Visits of the lattice for each."),
  }};
}

KeyTable stereoKeys()
{
  const char* const s = "Stereo";
  return {{
      numbers(s, "field", "m", "Length and width of the field."),
      numbers(s, "corners", "m", "x y of every goal corner."),
      number(s, "field_of_view_deg", "deg", kPositive, "Horizontal field of view of the left camera."),
      number(s, "baseline_m", "m", kPositive, "Distance of the two cameras."),
      numbers(s, "widths_px", "px", "Image widths: QVGA and VGA."),
      number(s, "range_scale", "", kPositive, "Measured range / true range, on average."),
      number(s, "min_range_m", "m", kPositive, "Nearest corner measured."),
      number(s, "margin_m", "m", kNotNegative, "The robot stays this far from the border of the field."),
      number(s, "std_subpixel_px", "px", kPositive, "Standard deviation of a disparity found between pixels."),
      numbers("Ranges", "measurements", "", "Measured ranges in each of the paper's tables."),
      numbers("Ranges", "other_margins_m", "m", "Other values of Stereo.margin_m to try."),
      numbers("Ranges", "other_min_ranges_m", "m", "Other values of Stereo.min_range_m to try."),
  }};
}

KeyTable fixKeys()
{
  const char* const s = "RunningFix";
  const char* const study = "Study";
  return {{
      numbers(s, "displacements_m", "m", "Ways between the two ranges to try."),
      number(s, "displacement_error", "", kNotNegative, "Error of dead reckoning per way, each axis."),
      number(s, "std_heading_deg", "deg", kNotNegative,
             "Error of the heading that turns the way into the field's axes."),
      number(s, "std_bearing_deg", "deg", kPositive, "Error of the bearing, for the estimator that uses it."),
      number(s, "judged_displacement_m", "m", kPositive, "Way between the ranges where errors are judged."),
      integer(s, "repetitions", "How often the whole experiment is made."),
      number(study, "std_range_m", "m", kPositive, "Error of a range."),
      number(study, "std_bearing_deg", "deg", kPositive, "Error of the bearing, for the estimator that uses it."),
      number(study, "std_heading_deg", "deg", kPositive, "Error of the heading, for both."),
      numbers(study, "ratios", "", "Way between the ranges / error of a range."),
      numbers(study, "displacement_errors", "", "Errors of dead reckoning per way."),
      number(study, "max_range_m", "m", kPositive, "The robot is at most this far from the landmark."),
      number(study, "min_range_m", "m", kPositive, "... and at least this far."),
  }};
}

KeyTable driveKeys()
{
  const char* const s = "Drive";
  return {{
      {s, "scenario", KeyType::text, "", "", {}, {}, "ini/landmark-simulator/ and ini/landmark-localization/<it>.ini."},
      {s, "simulation", KeyType::text, "", "", {}, {}, "Section.key=value: changes of the simulated scenario."},
      {s, "localization", KeyType::text, "", "", {}, {}, "Section.key=value: changes of the localization."},
      {s,
       "bound_simulation",
       KeyType::text,
       "",
       "",
       {},
       {},
       "Section.key=value: what takes the systematic errors off."},
      {s,
       "bound_noise",
       KeyType::text,
       "",
       "",
       {},
       {},
       "Section.key=value: the simulator's noise, for the localization."},
      number(s, "judged_from_s", "s", kNotNegative, "Errors count from here on."),
      integer(s, "runs", "Drives, each with a random seed of its own."),
  }};
}
}  // namespace

KeyTable paperKeys()
{
  KeyTable table({{"Experiment", "random_seed", KeyType::integer, "", "1", {0, 9e18}, {}, "Same seed, same figures."},
                  integer("Experiment", "trials", "Trials of each row.")});
  return table.append(treeKeys()).append(movisKeys()).append(stereoKeys()).append(fixKeys()).append(driveKeys());
}

Settings paperSettings(const std::string& name, const std::vector<std::string>& changes)
{
  return Settings::load(std::string(MRPT_EXT_SOURCE_DIR) + "/tests/papers/" + name + ".ini", paperKeys(), changes);
}
}  // namespace mrpt_ext::papers
