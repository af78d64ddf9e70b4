#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/correspondence/global_pose_search.h"
#include "mrpt_ext/localizers/filter_localizer.h"
#include "mrpt_ext/localizers/localizer.h"

namespace mrpt_ext
{
/// The methods of one trial. The filter, when it runs, is the first; it is owned by `localizers` like all others.
struct Methods
{
  std::vector<std::unique_ptr<Localizer>> localizers;
  FilterLocalizer* filter = nullptr;
};

/// What kinds of measurements a log holds: decides which closed forms make sense.
struct MeasurementKinds
{
  bool known_bearing = false, known_range = false, known_point = false, unknown_bearing = false, fix = false;
  bool several_places = false;  ///< sensors at different places on the robot
  bool odometry = false;

  void add(const Frame& frame);
};

/// Builds the methods of each trial: those named in the configuration, or all for which the log holds measurements.
/// What is the same for all trials is made once; trials may ask at the same time. Everything given must outlive the
/// factory and the methods.
class MethodFactory
{
 public:
  /// Throws InputError (configuration) for an unknown name.
  MethodFactory(const LocalizationConfig& config, const LandmarkTable& map, const MeasurementKinds& kinds);

  [[nodiscard]] Methods make(std::uint64_t seed, int trial) const;
  [[nodiscard]] const LandmarkTable& map() const { return map_; }

 private:
  /// A method by name; `applies` tells whether the log gives it anything.
  struct Entry
  {
    std::string name;
    bool applies = false;
    std::function<std::unique_ptr<Localizer>()> make;
  };
  [[nodiscard]] std::vector<Entry> entries(std::uint64_t seed, int trial, const Methods& methods) const;
  [[nodiscard]] std::vector<Entry> closedForms() const;
  [[nodiscard]] std::vector<Entry> kalmanFilters() const;
  [[nodiscard]] std::unique_ptr<FilterLocalizer> makeFilter(std::uint64_t seed, int trial) const;
  void checkNames() const;

  const LocalizationConfig& config_;
  const LandmarkTable& map_;
  MeasurementKinds kinds_;
  std::shared_ptr<const GlobalPoseSearch> search_;
};
}  // namespace mrpt_ext
