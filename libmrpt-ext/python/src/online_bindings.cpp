#include <set>

#include "bindings.h"
#include "mrpt_ext/online/online_localizer.h"

namespace mrpt_ext::python
{
namespace py = pybind11;

namespace
{
template <typename Value>
std::optional<Value> entry(const py::dict& detection, const char* key)
{
  if (!detection.contains(key) || detection[key].is_none()) return std::nullopt;
  return detection[key].cast<Value>();
}

const std::set<std::string> kKeys{"id",  "category", "bearing",   "range",         "std_bearing", "std_range",
                                  "yaw", "std_yaw",  "other_yaw", "other_std_yaw", "other_weight"};

std::optional<Facing> facingOf(const py::dict& given)
{
  const auto yaw = entry<double>(given, "yaw"), other = entry<double>(given, "other_yaw");
  if (!yaw) return std::nullopt;
  const double std = entry<double>(given, "std_yaw").value_or(0),
               other_std = entry<double>(given, "other_std_yaw").value_or(0);
  const double weight = entry<double>(given, "other_weight").value_or(-1);
  if (!(std > 0) || (other && !(other_std > 0 && weight >= 0 && weight <= 1)))
    throw py::value_error(
        "detection: every yaw needs its standard deviation > 0, the other one its probability as well");
  return other ? Facing::either({*yaw, std}, {*other, other_std}, weight) : Facing::single(*yaw, std);
}

Detection detectionOf(const py::dict& given)
{
  for (const auto& [key, value] : given)
    if (const auto name = key.cast<std::string>(); !kKeys.contains(name))
      throw py::key_error("detection: unknown key '" + name + "'");
  Detection detection;
  detection.id = entry<int>(given, "id").value_or(kNoId);
  detection.category = entry<std::string>(given, "category").value_or("");
  detection.bearing = entry<double>(given, "bearing");
  detection.range = entry<double>(given, "range");
  detection.std_bearing = entry<double>(given, "std_bearing").value_or(0);
  detection.std_range = entry<double>(given, "std_range").value_or(0);
  detection.facing = facingOf(given);
  if ((detection.bearing && !(detection.std_bearing > 0)) || (detection.range && !(detection.std_range > 0)))
    throw py::value_error("detection: every bearing and range needs its standard deviation > 0");
  if (!detection.bearing && !detection.range) throw py::value_error("detection: expected 'bearing' or 'range'");
  return detection;
}

void addDetections(OnlineLocalizer& robot, double t, const std::string& sensor, const std::vector<py::dict>& detections,
                   const Vector3d& mount, double height)
{
  std::vector<Detection> all;
  for (const py::dict& detection : detections) all.push_back(detectionOf(detection));
  robot.addDetections(t, sensor, std::move(all), poseOf(mount), height);
}

/// A known start or restart, (x, y, phi) with its covariance.
std::optional<GaussianPose> startOf(const std::optional<Vector3d>& pose, const std::optional<Matrix3d>& covariance)
{
  if (!pose) return std::nullopt;
  if (!covariance) throw py::value_error("covariance: expected an array of shape (3, 3) with a pose");
  return GaussianPose{poseOf(*pose), *covariance};
}

py::dict dictOf(const PoseEstimate& estimate)
{
  py::dict result;
  result["t"] = estimate.time;
  addPose(result, estimate.pose);
  result["heading_known"] = estimate.heading_known;
  result["verdict"] = std::string(toString(estimate.verdict));
  return result;
}

py::dict dictOf(const OnlineEstimate& estimate)
{
  py::dict result;
  if (estimate.best) result = dictOf(*estimate.best);
  result["t"] = estimate.time;
  result["verdict"] = std::string(toString(estimate.verdict));
  result["reason"] = estimate.reason;
  result["steps_late"] = estimate.steps_late;
  py::list modes;
  for (const Mode& mode : estimate.modes)
  {
    py::dict one;
    one["weight"] = mode.weight;
    addPose(one, mode.pose);
    modes.append(one);
  }
  result["modes"] = modes;
  return result;
}

std::vector<py::dict> dictsOf(const std::vector<OnlineEstimate>& estimates)
{
  std::vector<py::dict> dicts;
  for (const OnlineEstimate& estimate : estimates) dicts.push_back(dictOf(estimate));
  return dicts;
}

template <auto Function>
std::vector<py::dict> released(OnlineLocalizer& robot)
{
  std::vector<OnlineEstimate> estimates;
  {
    const py::gil_scoped_release others_may_run;
    estimates = (robot.*Function)();
  }
  return dictsOf(estimates);
}

std::unique_ptr<OnlineLocalizer> fromMap(const LandmarkTable& map, double margin, std::size_t particles,
                                         std::size_t initial_particles, std::uint64_t seed, double lateness,
                                         double step_budget_ms)
{
  OnlineOptions options;
  const auto [low, high] = map.boundingBox();
  options.filter.region = {low - Vector2d::Constant(margin), high + Vector2d::Constant(margin)};
  options.filter.particles = particles;
  options.filter.initial_particles = initial_particles;
  options.seed = seed;
  options.lateness = lateness;
  options.step_budget_ms = step_budget_ms;
  return std::make_unique<OnlineLocalizer>(options, map);
}
}  // namespace

void bindOnline(py::module_& module)
{
  const ParticleFilterOptions defaults;
  py::class_<OnlineLocalizer>(
      module, "OnlineLocalizer",
      "The particle filter on a robot: measurements in, estimates with a verdict out.\n\n"
      "Lengths in metres, angles in radians (counter-clockwise), times in seconds of one clock.")
      .def(
          py::init(&fromMap), py::arg("map"), py::arg("margin") = kRegionMargin,
          py::arg("particles") = defaults.particles, py::arg("initial_particles") = defaults.initial_particles,
          py::arg("seed") = 1, py::arg("lateness") = 0.0, py::arg("step_budget_ms") = kStepBudgetMs,
          "The robot is within `margin` [m] of the box around the landmarks. A measurement may be `lateness` [s] "
          "older\n"
          "than the newest. A step does no more work than `step_budget_ms`, in counted operations (0: no limit): what\n"
          "takes longer, as a start or a search, goes on in the next steps, with the same estimates.")
      .def_static(
          "from_ini",
          [](const std::string& ini, const std::string& map)
          { return std::unique_ptr<OnlineLocalizer>(new OnlineLocalizer(OnlineLocalizer::fromIni(ini, map))); },
          py::arg("ini"), py::arg("map") = "",
          "With the keys of landmark-localization; without `map` the one of the .ini.")
      .def(
          "add_odometry",
          [](OnlineLocalizer& robot, double t, const Vector3d& pose) { robot.addOdometry(t, poseOf(pose)); },
          py::arg("t"), py::arg("pose"), "Dead-reckoned pose (x, y, phi) in a frame of its own.")
      .def("add_velocity", &OnlineLocalizer::addVelocity, py::arg("t"), py::arg("v"), py::arg("omega"),
           "Speed [m/s] and turn rate [rad/s] from then on, instead of poses.")
      .def("add_detections", &addDetections, py::arg("t"), py::arg("sensor"), py::arg("detections"),
           py::arg("mount") = Vector3d(Vector3d::Zero()), py::arg("height") = 0.0,
           "What one sensor detects: dicts with bearing and std_bearing [rad], range and std_range [m], and, where "
           "known, "
           "id and category, and yaw and std_yaw [rad], which way the landmark faces from the sensor's forward axis, "
           "with other_yaw, other_std_yaw, other_weight where another attitude is possible. mount: (x, y, yaw) on the "
           "robot.")
      .def(
          "estimates", &released<&OnlineLocalizer::estimates>,
          "What became final since the last call: dicts with t [s], verdict, reason, modes, steps_late, and after the\n"
          "start pose (3,) and covariance (3, 3). A call does the work of one step for every frame of measurements\n"
          "that it gets, or of one step without any; steps_late counts those that followed the one of the estimate's\n"
          "own frame, 0 where it is in time.")
      .def("working", &OnlineLocalizer::working, py::call_guard<py::gil_scoped_release>(),
           "True while frames wait for more work: call estimates() again when there is nothing else to do.")
      .def("finish", &released<&OnlineLocalizer::finish>, "No measurement will follow: what is left.")
      .def(
          "pose_at",
          [](const OnlineLocalizer& robot, double t) -> py::object
          {
            const auto estimate = robot.poseAt(t);
            return estimate ? py::object(dictOf(*estimate)) : py::none();
          },
          py::arg("t"), "The newest estimate moved to time t by odometry; None before the first one.")
      .def(
          "reset",
          [](OnlineLocalizer& robot, double t, const std::optional<Vector3d>& pose,
             const std::optional<Matrix3d>& covariance) { robot.reset(t, startOf(pose, covariance)); },
          py::arg("t"), py::arg("pose") = py::none(), py::arg("covariance") = py::none(),
          "Starts anew at time t, from a pose or from anywhere.")
      .def("set_map", &OnlineLocalizer::setMap, py::arg("map"), "Other landmarks from the next estimate on.")
      .def("snapshot", &OnlineLocalizer::snapshot, "What a robot that restarts needs to go on, as text.")
      .def("restore", &OnlineLocalizer::restore, py::arg("snapshot"))
      .def_property_readonly("unusable", &OnlineLocalizer::unusable, "Counts of what could not be used, by reason.");
}
}  // namespace mrpt_ext::python
