#include "mrpt_ext/importers/import_options.h"

#include <algorithm>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
template <typename Action>
void forEachDetection(Recording& recording, Action&& action)
{
  for (Record& record : recording.records)
    if (auto* reading = std::get_if<Reading>(&record))
      std::for_each(reading->detections.begin(), reading->detections.end(), action);
}

bool isEmptyReading(const Record& record)
{
  const auto* reading = std::get_if<Reading>(&record);
  return reading && reading->detections.empty();
}
}  // namespace

void hideIdentity(Recording& recording, IdentityLevel identity)
{
  if (identity == IdentityLevel::known) return;
  bool any_category = false;
  forEachDetection(recording,
                   [&](Detection& detection)
                   {
                     any_category |= !detection.category.empty();
                     detection.id = kNoId;
                     if (identity == IdentityLevel::anonymous) detection.category.clear();
                   });
  if (identity == IdentityLevel::category && !any_category)
    throw configurationError("identity 'category': no detection has a category, expected 'known' or 'anonymous'");
  recording.notes.push_back(identity == IdentityLevel::category ? "landmark ids removed, categories kept"
                                                                : "landmark ids and categories removed");
}

void keepMeasurements(Recording& recording, MeasurementSelection measurements)
{
  if (measurements == MeasurementSelection::range_bearing) return;
  const bool bearings_only = measurements == MeasurementSelection::bearing;
  std::size_t dropped_detections = 0, kept_detections = 0, dropped_readings = 0;
  for (Record& record : recording.records)
  {
    auto* reading = std::get_if<Reading>(&record);
    if (!reading) continue;
    for (Detection& detection : reading->detections) (bearings_only ? detection.range : detection.bearing).reset();
    dropped_detections += std::erase_if(reading->detections, [](const Detection& d) { return !d.bearing && !d.range; });
    kept_detections += reading->detections.size();
  }
  dropped_readings = std::erase_if(recording.records, isEmptyReading);
  const std::string kept = bearings_only ? "bearing" : "range";
  if (kept_detections == 0)
    throw configurationError("measurements '" + kept + "': no detection has a " + kept + ", nothing would be left");
  recording.notes.push_back("only " + kept + "s kept; " + std::to_string(dropped_detections) +
                            " detections without one dropped, " + std::to_string(dropped_readings) +
                            " readings left empty dropped");
}
}  // namespace mrpt_ext
