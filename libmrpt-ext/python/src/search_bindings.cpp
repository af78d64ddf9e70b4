#include "bindings.h"
#include "mrpt_ext/correspondence/global_pose_search.h"

namespace mrpt_ext::python
{
namespace py = pybind11;

namespace
{
/// Keeps the map that its search refers to.
struct PoseSearch
{
  explicit PoseSearch(LandmarkTable landmarks) : map(std::move(landmarks)), search(map) {}

  LandmarkTable map;
  GlobalPoseSearch search;
};

py::dict find(const PoseSearch& where, const Eigen::VectorXd& bearings, const py::object& std_bearing,
              const std::optional<Eigen::VectorXd>& ranges, const py::object& std_range,
              std::optional<double> max_range, double clutter_probability, double field_of_view)
{
  const Eigen::MatrixX2d no_landmarks = Eigen::MatrixX2d::Zero(bearings.size(), 2);
  const Measured directions = measured(no_landmarks, bearings, std_bearing);
  const std::optional<Measured> distances =
      ranges ? std::optional(measured(no_landmarks, *ranges, std_range)) : std::nullopt;
  Scan scan;
  scan.model = {.field_of_view = field_of_view, .max_range = max_range, .clutter_probability = clutter_probability};
  for (Eigen::Index i = 0; i < bearings.size(); ++i)
  {
    AnonymousDetection& detection = scan.detections.emplace_back();
    detection.bearing = bearings[i];
    detection.std_bearing = directions.stds[i];
    if (distances)
    {
      detection.range = distances->values[i];
      detection.std_range = distances->stds[i];
    }
  }
  PoseSearchResult found;
  {
    const py::gil_scoped_release others_may_run;
    found = where.search.search(std::span(&scan, 1), {});
  }
  py::dict result;
  result["status"] = std::string(toString(found.status));
  result["unique"] = found.unique;
  result["finished"] = found.finished;
  py::list poses;
  for (const ConsistentPose& pose : found.poses)
  {
    py::dict one;
    addPose(one, pose.pose);
    one["probability"] = pose.probability;
    one["assignment"] = pose.assignment;
    poses.append(one);
  }
  result["poses"] = poses;
  return result;
}
}  // namespace

void bindSearch(py::module_& module)
{
  py::class_<PoseSearch>(module, "PoseSearch", "Where is a robot that sees anonymous landmarks? Maps of any size.")
      .def(py::init<LandmarkTable>(), py::arg("map"))
      .def("find", &find, py::arg("bearings"), py::arg("std_bearing"), py::arg("ranges") = py::none(),
           py::arg("std_range") = 1.0, py::arg("max_range") = py::none(), py::arg("clutter_probability") = 0.05,
           py::arg("field_of_view") = kTwoPi,
           "All poses that are consistent with (n,) bearings [rad] and, where given, (n,) ranges [m] of one scan.\n\n"
           "Returns a dict: status, unique, finished, poses (likeliest first): pose (3,), covariance (3, 3), "
           "probability,"
           " assignment (index of the landmark per detection, -1: a false one).");
}
}  // namespace mrpt_ext::python
