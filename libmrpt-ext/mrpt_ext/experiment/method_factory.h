#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/localizers/filter_localizer.h"
#include "mrpt_ext/localizers/localizer.h"

namespace mrpt_ext
{
class GlobalPoseSearch;

/// The methods of one trial. The filter, when it runs, is the first; it is owned by `localizers` like all others.
struct Methods
{
  std::vector<std::unique_ptr<Localizer>> localizers;
  FilterLocalizer* filter = nullptr;
  double step_budget_ms = 0;  ///< of the filter, where it counts its work (localizers/sliced_localizer.h)
};

/// Which measurements a log contains: decides which methods apply.
struct AvailableMeasurements
{
  bool identified_bearing = false, identified_range = false, identified_point = false;
  bool anonymous_bearing = false, fix = false;
  bool separate_sensors = false;  ///< sensors at different positions on the robot
  bool odometry = false;
  /// Fisher information on the heading, if the position were known [1/rad^2]: of bearings, compass, and ranges to
  /// sensors off the robot's origin.
  double heading_information = 0;

  void add(const Frame& frame);
};

/// Builds the methods of each trial: those of the configuration, or all that apply to the log. What all trials share is
/// built once; trials may call make() concurrently. The arguments must outlive the factory and the methods.
class MethodFactory
{
 public:
  /// Throws InputError (configuration) for an unknown method. `stop` ends the searches of all methods.
  MethodFactory(const LocalizationConfig& config, const LandmarkTable& map, const AvailableMeasurements& available,
                const std::atomic<bool>* stop = nullptr);

  [[nodiscard]] Methods make(std::uint64_t seed, int trial) const;
  [[nodiscard]] const LandmarkTable& map() const { return map_; }

 private:
  /// A method by name; `applies`: the log contains measurements for it.
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
  AvailableMeasurements available_;
  std::shared_ptr<const GlobalPoseSearch> search_;
};
}  // namespace mrpt_ext
