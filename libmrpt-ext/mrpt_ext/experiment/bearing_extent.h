#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// How far to either side each sensor of a log sees, by its bearings: a camera looks ahead, whether its log says so or
/// not. A landmark beside or behind it is none that an anonymous detection may show, and the null hypothesis expects no
/// bearing there. Of three quarters of the landmarks around a robot that is much to know.
class BearingExtent
{
 public:
  void add(const Frame& frame);
  /// The field of view of the sensors that declare none and have seen enough: full angle [rad] around the forward axis
  /// that holds all their bearings, with a margin. Nothing for a sensor that sees all around.
  [[nodiscard]] std::map<std::string, double> fieldsOfView() const;

 private:
  struct Sensor
  {
    std::size_t bearings = 0;
    double widest = 0;  // [rad] to either side
    bool declared = false;
  };
  std::map<std::string, Sensor> sensors_;
};
}  // namespace mrpt_ext
