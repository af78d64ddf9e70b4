#include "mrpt_ext/configuration/localization_choices.h"
#include "mrpt_ext/configuration/simulator_choices.h"
#include "mrpt_ext/configuration/simulator_keys.h"
#include "mrpt_ext/settings/key_section.h"

namespace mrpt_ext
{
namespace
{
const SimulatedSensor kSensor;  // its defaults are those of the keys

void addView(KeySection& keys)
{
  const Pose2& pose = kSensor.T_robot_sensor;
  keys.choice("kind", kSensor.kind, sensorKinds(), "What it measures.")
      .forBeginners()
      .number("rate_hz", "Hz", kSensor.rate_hz, {1e-3, 1000}, "Readings per second.")
      .forBeginners()
      .number("phase_s", "s", kSensor.phase_s, ranges::kNotNegative, "Time of the first reading after the start.")
      .number("delay_s", "s", kSensor.delay_s, {-10, 10}, "Latency: stamps are this much late.")
      .number("scan_duration_s", "s", kSensor.sweep.duration, {0, 10},
              "Time from the first beam of a spinning scanner to the last, at the stamp. 0: all at once.")
      .choice("scan_direction", kSensor.sweep.direction, sweepDirections(), "Which way it turns, seen from above.")
      .numbers("pose", "m m m deg", {pose.x, pose.y, kSensor.height, radToDeg(pose.phi)}, ranges::kAny,
               "x y z yaw on the robot (x forward, y left). yaw turns the sensor's forward axis.")
      .flag("horizontal_range", kSensor.horizontal_range, "Ranges are measured in the floor plane, not as a slant.")
      .degrees("field_of_view_deg", "deg", kSensor.field_of_view, {1e-3, 360}, "Full angle around the forward axis.")
      .number("max_range_m", "m", kSensor.max_range, {1e-3, ranges::kUnbounded},
              "Farthest visible landmark, horizontally. Not set: no limit.")
      .number("min_range_m", "m", kSensor.min_range, ranges::kNotNegative, "Nearest visible landmark, horizontally.");
}

void addErrors(KeySection& keys)
{
  keys.degrees("std_bearing_deg", "deg", kSensor.std_bearing, ranges::kNotNegative, "Standard deviation of bearings.")
      .forBeginners()
      .degrees("bias_bearing_deg", "deg", kSensor.bias_bearing, {-180, 180}, "Added to every bearing.")
      .number("std_range_m", "m", kSensor.std_range, ranges::kNotNegative,
              "Standard deviation of ranges, the constant part.")
      .forBeginners()
      .number("std_range_per_m", "m/m", kSensor.std_range_per_m, ranges::kNotNegative,
              "The part that grows with the range. The variances add up.")
      .number("bias_range_m", "m", kSensor.bias_range, ranges::kAny, "Added to every range.")
      .number("scale_range", "", kSensor.scale_range, {0.1, 10}, "Factor on every range, applied before the bias.")
      .number("baseline_focal_m_px", "m px", kUnset, ranges::kPositive, "Baseline times focal length of a stereo pair.")
      .number("std_disparity_px", "px", kSensor.std_disparity, ranges::kNotNegative,
              "Standard deviation of a stereo pair's disparity. The range error then grows with the range squared.")
      .degrees("std_heading_deg", "deg", kSensor.std_heading, ranges::kNotNegative, "Standard deviation of a compass.")
      .degrees("bias_heading_deg", "deg", kSensor.bias_heading, {-180, 180}, "Added to every heading of a compass.");
}

void addDetection(KeySection& keys)
{
  keys.choice("identity", kSensor.identity, identityLevels(), "What a detection reports of its landmark.")
      .number("wrong_identity_probability", "", kSensor.wrong_identity_probability, ranges::kShare,
              "Share of detections with the identity of another landmark.")
      .number("detection_probability", "", kSensor.detection_probability, ranges::kShare,
              "Share of landmarks in view that are detected.")
      .number("clutter_per_reading", "", kSensor.clutter_per_reading, {0, 1000},
              "Expected number of false detections. Anywhere in view, with the identity of any landmark.")
      .integer("max_detections", "", kUnset, {1, 1e6}, "Maximum number of detections, chosen at random. Not set: all.")
      .flag("sees_objects", kSensor.sees_objects, "Whether it detects the objects of [Object_<label>], too.")
      .number("fix_distance_m", "m", kSensor.fix_distance, {1e-3, ranges::kUnbounded},
              "Distance between the two ranges of a running fix.")
      .flag("fix_bearing", kSensor.fix_bearing, "The second range of a running fix comes with a bearing.");
}
}  // namespace

KeyTable simulatedSensorKeys()
{
  KeySection keys("Sensor_<label>");
  addView(keys);
  addErrors(keys);
  addDetection(keys);
  return keys;
}
}  // namespace mrpt_ext
