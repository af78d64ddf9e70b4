#include "mrpt_ext/app/live_messages.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/geometry/verdict.h"

namespace mrpt_ext
{
namespace
{
using Json = nlohmann::ordered_json;

const std::string kDeg = "_deg", kRad = "_rad";            // ends of the names of angles
constexpr auto kReplace = Json::error_handler_t::replace;  // of text that is no UTF-8
const std::string kNoStd = "expected a standard deviation > 0";

/// The members of one JSON object; each is asked for by its name, and none may be left over.
class JsonObject
{
 public:
  JsonObject(const Json& value, std::string name) : value_(value), name_(std::move(name))
  {
    if (!value_.is_object()) throw dataError(name_ + ": expected an object {...}");
  }

  [[nodiscard]] bool has(const std::string& key) const { return value_.contains(key) && !value_.at(key).is_null(); }
  /// In degrees or in radians.
  [[nodiscard]] bool hasAngled(const std::string& key) const { return has(key) || has(key + kRad); }
  const Json& member(const std::string& key)
  {
    known_.insert(key);
    if (!has(key)) throw dataError(name_ + ": '" + key + "' is missing");
    return value_.at(key);
  }
  double number(const std::string& key)
  {
    const Json& value = member(key);
    if (!value.is_number()) throw dataError(name_ + ": '" + key + "': expected a number");
    return value.get<double>();
  }
  double number(const std::string& key, double otherwise)
  {
    known_.insert(key);
    return has(key) ? number(key) : otherwise;
  }
  std::optional<double> optionalNumber(const std::string& key)
  {
    known_.insert(key);
    return has(key) ? std::optional(number(key)) : std::nullopt;
  }
  /// [rad] of `key`_rad, or of `key`_deg.
  std::optional<double> angle(const std::string& key)
  {
    expectOneOf(key + kDeg, key + kRad);
    if (const auto radians = optionalNumber(key + kRad)) return radians;
    const auto degrees = optionalNumber(key + kDeg);
    return degrees ? std::optional(degToRad(*degrees)) : std::nullopt;
  }
  bool flag(const std::string& key)
  {
    known_.insert(key);
    if (!has(key)) return false;
    if (!value_.at(key).is_boolean()) throw dataError(name_ + ": '" + key + "': expected true or false");
    return value_.at(key).get<bool>();
  }
  std::string text(const std::string& key, const std::string& otherwise)
  {
    known_.insert(key);
    if (!has(key)) return otherwise;
    if (!value_.at(key).is_string()) throw dataError(name_ + ": '" + key + "': expected a text");
    return value_.at(key).get<std::string>();
  }
  int id()
  {
    known_.insert("id");
    if (!has("id")) return kNoId;
    const Json& value = value_.at("id");
    if (!value.is_number_integer() || value.get<std::int64_t>() < 0 || value.get<std::int64_t>() > 2'000'000'000)
      throw dataError(name_ + ": 'id': expected a number from 0 to 2000000000");
    return value.get<int>();
  }
  /// `size` numbers.
  std::vector<double> numbers(const std::string& key, std::size_t size)
  {
    const Json& value = member(key);
    const bool fits = value.is_array() && value.size() == size &&
                      std::all_of(value.begin(), value.end(), [](const Json& entry) { return entry.is_number(); });
    if (!fits) throw dataError(name_ + ": '" + key + "': expected [" + std::to_string(size) + " numbers]");
    return value.get<std::vector<double>>();
  }
  /// `size` numbers of which the last one is an angle [rad]: those of `key`_rad, or of `key`, where it is in degrees.
  std::vector<double> angled(const std::string& key, std::size_t size)
  {
    expectOneOf(key, key + kRad);
    if (has(key + kRad)) return numbers(key + kRad, size);
    std::vector<double> values = numbers(key, size);
    values.back() = degToRad(values.back());
    return values;
  }
  Pose2 pose(const std::string& key)
  {
    const std::vector<double> values = angled(key, 3);
    return {values[0], values[1], wrap(values[2])};
  }
  const Json& list(const std::string& key)
  {
    const Json& value = member(key);
    if (!value.is_array()) throw dataError(name_ + ": '" + key + "': expected a list [...]");
    return value;
  }
  void expectNothingElse() const
  {
    for (const auto& [key, value] : value_.items())
      if (!known_.contains(key)) throw dataError(name_ + ": unknown member '" + key + "'");
  }

 private:
  void expectOneOf(const std::string& degrees, const std::string& radians) const
  {
    if (has(degrees) && has(radians))
      throw dataError(name_ + ": '" + degrees + "' and '" + radians + "': expected one of them");
  }

  const Json& value_;
  std::string name_;
  std::set<std::string> known_;
};

/// An angle `name` with its standard deviation `std_name`; nothing where it is not given.
std::optional<Facing::Attitude> attitudeFrom(JsonObject& object, const std::string& name, const std::string& std_name)
{
  const auto yaw = object.angle(name), std = object.angle(std_name);
  if (!yaw) return std::nullopt;
  if (!std) throw dataError("detection: '" + std_name + "_deg' is missing");
  if (!(*std > 0)) throw dataError("detection: '" + std_name + "_deg': " + kNoStd);
  return Facing::Attitude{*yaw, *std, 1};
}

std::optional<Facing> facingFrom(JsonObject& object)
{
  const auto one = attitudeFrom(object, "yaw", "std_yaw"), other = attitudeFrom(object, "other_yaw", "other_std_yaw");
  const auto weight = object.optionalNumber("other_weight");
  if (!one && other) throw dataError("detection: 'other_yaw_deg' without 'yaw_deg'");
  if (!one) return std::nullopt;
  if (!other) return Facing::single(one->yaw, one->std);
  if (!weight || !(*weight >= 0 && *weight <= 1))
    throw dataError("detection: 'other_weight': expected a probability beside 'other_yaw_deg'");
  return Facing::either(*one, *other, *weight);
}

Detection detectionFrom(const Json& value)
{
  JsonObject object(value, "detection");
  Detection detection{.id = object.id(), .category = object.text("category", "")};
  if (const auto bearing = object.angle("bearing"))
  {
    const auto std = object.angle("std_bearing");
    if (!std) throw dataError("detection: 'std_bearing_deg' is missing");
    if (!(*std > 0)) throw dataError("detection: 'std_bearing_deg': " + kNoStd);
    detection.bearing = wrap(*bearing);
    detection.std_bearing = *std;
  }
  if (const auto range = object.optionalNumber("range_m"))
  {
    if (!(*range > 0)) throw dataError("detection: 'range_m': expected a distance > 0");
    detection.range = *range;
    detection.std_range = object.number("std_range_m");
    if (!(detection.std_range > 0)) throw dataError("detection: 'std_range_m': " + kNoStd);
  }
  if (!detection.bearing && !detection.range) throw dataError("detection: expected 'bearing_deg' or 'range_m'");
  detection.facing = facingFrom(object);
  object.expectNothingElse();
  return detection;
}

SensorModel modelFrom(JsonObject& line)
{
  SensorModel model;
  const auto field_of_view = line.angle("field_of_view");
  model.max_range = line.optionalNumber("max_range_m");
  if (field_of_view && !(*field_of_view > 0)) throw dataError("line: 'field_of_view_deg': expected an angle > 0");
  if (model.max_range && !(*model.max_range > 0)) throw dataError("line: 'max_range_m': expected a distance > 0");
  model.has_field_of_view = field_of_view.has_value();
  if (field_of_view) model.field_of_view = std::min(*field_of_view, kTwoPi);
  return model;
}

void applyDetections(JsonObject& line, OnlineLocalizer& robot)
{
  Reading reading{.time = line.number("t"), .sensor = line.text("sensor", "")};
  if (reading.sensor.empty()) throw dataError("line: 'sensor': expected the name of the sensor");
  for (const Json& detection : line.list("detections")) reading.detections.push_back(detectionFrom(detection));
  if (line.hasAngled("mount")) reading.T_robot_sensor = line.pose("mount");
  reading.sensor_height = line.number("height_m", 0);
  reading.horizontal_range = line.flag("horizontal");
  reading.model = modelFrom(line);
  line.expectNothingElse();
  robot.add(std::move(reading));
}

void applyReset(JsonObject& line, OnlineLocalizer& robot)
{
  const double time = line.number("t");
  std::optional<GaussianPose> pose;
  if (!(line.has("reset") && line.member("reset").is_string() && line.text("reset", "") == "unknown"))
  {
    pose = GaussianPose{line.pose("reset"), Matrix3d::Zero()};
    const double std_xy = line.number("std_m", kStartStdXy);
    const double std_phi = line.angle("std").value_or(kStartStdPhi);
    if (!(std_xy > 0) || !(std_phi > 0)) throw dataError("line: expected standard deviations > 0");
    pose->covariance.diagonal() << square(std_xy), square(std_xy), square(std_phi);
  }
  line.expectNothingElse();
  robot.reset(time, pose);
}

void applyMap(JsonObject& line, OnlineLocalizer& robot)
{
  std::vector<Landmark> landmarks;
  for (const Json& value : line.list("map"))
  {
    JsonObject object(value, "landmark");
    Landmark landmark{.id = object.id(), .category = object.text("category", "")};
    landmark.position = {object.number("x"), object.number("y"), object.number("z", 0)};
    landmark.yaw = object.angle("yaw");
    landmark.std_yaw = object.angle("std_yaw").value_or(0);
    if (!(landmark.std_yaw >= 0)) throw dataError("landmark: 'std_yaw_deg': " + kNoStd);
    object.expectNothingElse();
    landmarks.push_back(std::move(landmark));
  }
  line.expectNothingElse();
  robot.setMap(LandmarkTable(std::move(landmarks)));
}
Json arrayOf(const Pose2& pose) { return {pose.x, pose.y, pose.phi}; }

Json objectOf(const Detection& detection)
{
  Json object = Json::object();
  if (detection.id != kNoId) object["id"] = detection.id;
  if (!detection.category.empty()) object["category"] = detection.category;
  if (detection.bearing)
    object.update({{"bearing_rad", *detection.bearing}, {"std_bearing_rad", detection.std_bearing}});
  if (detection.range) object.update({{"range_m", *detection.range}, {"std_range_m", detection.std_range}});
  if (!detection.facing) return object;
  const auto& [likelier, other] = detection.facing->attitudes;
  object.update({{"yaw_rad", likelier.yaw}, {"std_yaw_rad", likelier.std}});
  if (other.weight > 0)
    object.update({{"other_yaw_rad", other.yaw}, {"other_std_yaw_rad", other.std}, {"other_weight", other.weight}});
  return object;
}

Json objectOf(const Reading& reading)
{
  Json line{{"t", reading.time}, {"sensor", reading.sensor}, {"mount_rad", arrayOf(reading.T_robot_sensor)}};
  if (reading.sensor_height != 0) line["height_m"] = reading.sensor_height;
  if (reading.horizontal_range) line["horizontal"] = true;
  if (reading.model.has_field_of_view) line["field_of_view_rad"] = reading.model.field_of_view;
  if (reading.model.max_range) line["max_range_m"] = *reading.model.max_range;
  line["detections"] = Json::array();
  for (const Detection& detection : reading.detections) line["detections"].push_back(objectOf(detection));
  return line;
}
}  // namespace

void applyLiveLine(const std::string& line, OnlineLocalizer& robot)
{
  const Json value = Json::parse(line, nullptr, false);
  if (value.is_discarded()) throw dataError("no JSON, expected one object per line");
  JsonObject object(value, "line");
  if (object.has("detections")) return applyDetections(object, robot);
  if (object.hasAngled("reset")) return applyReset(object, robot);
  if (object.has("map")) return applyMap(object, robot);
  if (object.hasAngled("odometry"))
  {
    const OdometryRecord odometry{object.number("t"), object.pose("odometry")};
    object.expectNothingElse();
    return robot.add(odometry);
  }
  if (object.hasAngled("velocity"))
  {
    const std::vector<double> velocity = object.angled("velocity", 2);
    const double time = object.number("t");
    object.expectNothingElse();
    return robot.addVelocity(time, velocity[0], velocity[1]);
  }
  throw dataError("line: expected 'odometry', 'velocity', 'detections', 'reset' or 'map'");
}

std::string liveLineOf(const OnlineEstimate& estimate, const BiasModel& biases, double latency_ms)
{
  Json line{{"t", estimate.time}, {"verdict", toString(estimate.verdict)}, {"reason", estimate.reason}};
  if (estimate.best)
  {
    const auto& [mean, P] = estimate.best->pose;
    line["x"] = mean.x;
    line["y"] = mean.y;
    line["phi_deg"] = estimate.best->heading_known ? Json(radToDeg(mean.phi)) : Json();
    line["covariance"] = {P(0, 0), P(0, 1), P(0, 2), P(1, 1), P(1, 2), P(2, 2)};
  }
  line["modes"] = Json::array();
  for (const Mode& mode : estimate.modes)
    if (mode.weight >= kMinReportedWeight)
      line["modes"].push_back({{"weight", mode.weight},
                               {"x", mode.pose.mean.x},
                               {"y", mode.pose.mean.y},
                               {"phi_deg", radToDeg(mode.pose.mean.phi)}});
  for (std::size_t k = 0; k < estimate.biases.size(); ++k)
    line["biases"][biasName(biases[k])] = {fileUnit(biases[k]) * estimate.biases[k].mean,
                                           fileUnit(biases[k]) * estimate.biases[k].std};
  line["steps_late"] = estimate.steps_late;
  line["latency_ms"] = latency_ms;
  return line.dump(-1, ' ', false, kReplace);
}

std::optional<std::string> liveLineOf(const Record& record)
{
  if (const auto* odometry = std::get_if<OdometryRecord>(&record))
    return Json{{"t", odometry->time}, {"odometry_rad", arrayOf(odometry->pose)}}.dump();
  if (const auto* reading = std::get_if<Reading>(&record)) return objectOf(*reading).dump(-1, ' ', false, kReplace);
  return std::nullopt;
}

std::string liveErrorLine(std::size_t number, const std::string& message)
{
  return Json{{"error", message}, {"line", number}}.dump(-1, ' ', false, kReplace);
}
}  // namespace mrpt_ext
