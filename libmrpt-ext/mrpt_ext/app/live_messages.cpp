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

/// The members of one JSON object; each is asked for by its name, and none may be left over.
class JsonObject
{
 public:
  JsonObject(const Json& value, std::string name) : value_(value), name_(std::move(name))
  {
    if (!value_.is_object()) throw dataError(name_ + ": expected an object {...}");
  }

  [[nodiscard]] bool has(const std::string& key) const { return value_.contains(key) && !value_.at(key).is_null(); }
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
  const Json& value_;
  std::string name_;
  std::set<std::string> known_;
};

Pose2 poseFrom(const std::vector<double>& values) { return {values[0], values[1], wrap(degToRad(values[2]))}; }

Detection detectionFrom(const Json& value)
{
  JsonObject object(value, "detection");
  Detection detection{.id = object.id(), .category = object.text("category", "")};
  const auto positive = [&](const std::string& key)
  {
    const double std = object.number(key);
    if (!(std > 0)) throw dataError("detection: '" + key + "': expected a standard deviation > 0");
    return std;
  };
  if (const auto bearing = object.optionalNumber("bearing_deg"))
  {
    detection.bearing = wrap(degToRad(*bearing));
    detection.std_bearing = degToRad(positive("std_bearing_deg"));
  }
  if (const auto range = object.optionalNumber("range_m"))
  {
    if (!(*range > 0)) throw dataError("detection: 'range_m': expected a distance > 0");
    detection.range = *range;
    detection.std_range = positive("std_range_m");
  }
  if (!detection.bearing && !detection.range) throw dataError("detection: expected 'bearing_deg' or 'range_m'");
  object.expectNothingElse();
  return detection;
}

void applyDetections(JsonObject& line, OnlineLocalizer& robot)
{
  const std::string sensor = line.text("sensor", "");
  if (sensor.empty()) throw dataError("line: 'sensor': expected the name of the sensor");
  std::vector<Detection> detections;
  for (const Json& detection : line.list("detections")) detections.push_back(detectionFrom(detection));
  const Pose2 mount = line.has("mount") ? poseFrom(line.numbers("mount", 3)) : Pose2{};
  const double time = line.number("t"), height = line.number("height_m", 0);
  line.expectNothingElse();
  robot.addDetections(time, sensor, std::move(detections), mount, height);
}

void applyReset(JsonObject& line, OnlineLocalizer& robot)
{
  const double time = line.number("t");
  std::optional<GaussianPose> pose;
  if (!(line.member("reset").is_string() && line.text("reset", "") == "unknown"))
  {
    pose = GaussianPose{poseFrom(line.numbers("reset", 3)), Matrix3d::Zero()};
    const double std_xy = line.number("std_m", kStartStdXy);
    const double std_phi = degToRad(line.number("std_deg", radToDeg(kStartStdPhi)));
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
    object.expectNothingElse();
    landmarks.push_back(std::move(landmark));
  }
  line.expectNothingElse();
  robot.setMap(LandmarkTable(std::move(landmarks)));
}
}  // namespace

void applyLiveLine(const std::string& line, OnlineLocalizer& robot)
{
  const Json value = Json::parse(line, nullptr, false);
  if (value.is_discarded()) throw dataError("no JSON, expected one object per line");
  JsonObject object(value, "line");
  if (object.has("detections")) return applyDetections(object, robot);
  if (object.has("reset")) return applyReset(object, robot);
  if (object.has("map")) return applyMap(object, robot);
  if (object.has("odometry"))
  {
    const Pose2 pose = poseFrom(object.numbers("odometry", 3));
    const double time = object.number("t");
    object.expectNothingElse();
    return robot.addOdometry(time, pose);
  }
  if (object.has("velocity"))
  {
    const std::vector<double> velocity = object.numbers("velocity", 2);
    const double time = object.number("t");
    object.expectNothingElse();
    return robot.addVelocity(time, velocity[0], degToRad(velocity[1]));
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
  line["latency_ms"] = latency_ms;
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string liveErrorLine(std::size_t number, const std::string& message)
{
  return Json{{"error", message}, {"line", number}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}
}  // namespace mrpt_ext
