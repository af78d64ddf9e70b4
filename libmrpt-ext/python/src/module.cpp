#include <cmath>
#include <sstream>

#include "bindings.h"
#include "mrpt_ext/app/apps.h"
#include "mrpt_ext/app/version.h"
#include "mrpt_ext/files/landmark_map_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/maps/register_all_classes.h"

namespace mrpt_ext::python
{
namespace py = pybind11;

namespace
{
void bindMap(py::module_& module)
{
  py::class_<LandmarkTable>(module, "LandmarkMap", "Known landmarks: position [m], id and category.")
      .def(py::init(
               [](const Eigen::MatrixXd& positions, const std::optional<std::vector<int>>& ids,
                  const std::optional<std::vector<std::string>>& categories,
                  const std::optional<std::vector<double>>& yaws)
               {
                 const auto count = static_cast<std::size_t>(positions.rows());
                 if (positions.cols() != 2 && positions.cols() != 3)
                   throw py::value_error("positions: expected an array of shape (n, 2) or (n, 3)");
                 if ((ids && ids->size() != count) || (categories && categories->size() != count) ||
                     (yaws && yaws->size() != count))
                   throw py::value_error("ids, categories, yaws: expected one for each position");
                 std::vector<Landmark> landmarks(count);
                 for (std::size_t i = 0; i < count; ++i)
                 {
                   const auto row = positions.row(static_cast<Eigen::Index>(i));
                   landmarks[i].id = ids ? (*ids)[i] : static_cast<int>(i);
                   landmarks[i].position = {row(0), row(1), positions.cols() == 3 ? row(2) : 0.0};
                   if (categories) landmarks[i].category = (*categories)[i];
                   if (yaws && !std::isnan((*yaws)[i])) landmarks[i].yaw = (*yaws)[i];
                 }
                 return LandmarkTable(std::move(landmarks));
               }),
           py::arg("positions"), py::arg("ids") = py::none(), py::arg("categories") = py::none(),
           py::arg("yaws") = py::none(),
           "positions: (n, 2) or (n, 3) [m]; ids: n numbers, default 0 ... n-1; categories: n texts; yaws: n "
           "directions in "
           "which they face [rad], nan: unknown.")
      .def_static(
          "load", [](const std::string& path) { return readLandmarkMapFile(path); }, py::arg("path"),
          "Reads landmarks.csv: id,x,y,z,category.")
      .def("__len__", &LandmarkTable::size)
      .def_property_readonly(
          "ids",
          [](const LandmarkTable& map)
          {
            Eigen::VectorXi ids(static_cast<Eigen::Index>(map.size()));
            for (std::size_t i = 0; i < map.size(); ++i) ids[static_cast<Eigen::Index>(i)] = map[i].id;
            return ids;
          },
          "(n,) ids; -1: anonymous.")
      .def_property_readonly(
          "positions",
          [](const LandmarkTable& map)
          {
            Eigen::MatrixX3d positions(static_cast<Eigen::Index>(map.size()), 3);
            for (std::size_t i = 0; i < map.size(); ++i) positions.row(static_cast<Eigen::Index>(i)) = map[i].position;
            return positions;
          },
          "(n, 3) [m].");
}

/// The app in this process: exit code, what it printed, and its errors.
py::tuple runApp(const std::vector<std::string>& arguments)
{
  std::ostringstream out, err;
  int exit_code = 0;
  {
    const py::gil_scoped_release others_may_run;
    registerAllClasses();
    exit_code = runLandmarkLocalization(arguments, out, err);
  }
  return py::make_tuple(exit_code, out.str(), err.str());
}
}  // namespace

Measured measured(const Eigen::MatrixX2d& landmarks, const Eigen::VectorXd& values, const py::object& std)
{
  Measured all{landmarks, values, Eigen::VectorXd::Constant(values.size(), 1)};
  if (py::isinstance<py::float_>(std) || py::isinstance<py::int_>(std))
    all.stds.setConstant(std.cast<double>());
  else
    all.stds = std.cast<Eigen::VectorXd>();
  if (landmarks.rows() != values.size() || all.stds.size() != values.size())
    throw py::value_error("expected as many landmarks and standard deviations as values");
  return all;
}

PYBIND11_MODULE(_native, module)
{
  module.doc() = "The compiled part of mrpt_ext.";
  module.attr("__version__") = version();
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
  bindMap(module);
  bindSolvers(module);
  bindSearch(module);
  bindOnline(module);
  module.def("_run_app", &runApp, py::arg("arguments"));
}
}  // namespace mrpt_ext::python
