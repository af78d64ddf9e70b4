#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// Gathers detections, given in order of time, into readings: one per stamp and sensor.
class ReadingCollector
{
 public:
  /// `prototype` gives every reading what does not change: sensor pose, height, model.
  explicit ReadingCollector(Reading prototype = {}) : prototype_(std::move(prototype)) {}

  void add(double time, const std::string& sensor, Detection detection)
  {
    readingFor(time, sensor).detections.push_back(std::move(detection));
  }
  [[nodiscard]] const std::vector<Reading>& readings() const { return readings_; }

 private:
  Reading& readingFor(double time, const std::string& sensor)
  {
    for (auto reading = readings_.rbegin(); reading != readings_.rend() && reading->time == time; ++reading)
      if (reading->sensor == sensor) return *reading;
    readings_.push_back(prototype_);
    readings_.back().time = time;
    readings_.back().sensor = sensor;
    return readings_.back();
  }

  Reading prototype_;
  std::vector<Reading> readings_;
};
}  // namespace mrpt_ext
