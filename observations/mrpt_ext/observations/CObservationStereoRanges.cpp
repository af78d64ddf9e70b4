#include "mrpt_ext/observations/CObservationStereoRanges.h"

#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/observations/observation_archive.h"
#include "mrpt_ext/observations/observation_text.h"

IMPLEMENTS_SERIALIZABLE(CObservationStereoRanges, mrpt::obs::CObservation, mrpt_ext)

namespace mrpt_ext
{
double CObservationStereoRanges::rangeStd(const Detection& detection) const
{
  if (detection.std_range > 0 || !detection.range || !(baseline_focal > 0)) return detection.std_range;
  return square(*detection.range) * std::abs(std::cos(detection.bearing.value_or(0))) * detection.std_disparity /
         baseline_focal;
}

std::uint8_t CObservationStereoRanges::serializeGetVersion() const { return 0; }

void CObservationStereoRanges::serializeTo(mrpt::serialization::CArchive& out) const
{
  writeHeader(out, *this, sensor_pose);
  out << field_of_view << max_range << baseline_focal << horizontal << static_cast<std::uint32_t>(detections.size());
  for (const Detection& d : detections)
  {
    out << d.id;
    writeText(out, d.category);
    writeOptional(out, d.range);
    out << d.std_range << d.std_disparity;
    writeOptional(out, d.bearing);
    out << d.std_bearing;
  }
}

void CObservationStereoRanges::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version)
{
  switch (version)
  {
    case 0:
      readHeader(in, *this, sensor_pose);
      in >> field_of_view >> max_range >> baseline_focal;
      horizontal = readFlag(in);
      detections.assign(readDetectionCount(in), {});
      for (Detection& d : detections)
      {
        in >> d.id;
        readText(in, d.category);
        d.range = readOptional(in);
        in >> d.std_range >> d.std_disparity;
        d.bearing = readOptional(in);
        in >> d.std_bearing;
      }
      break;
    default:
      MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  }
}

namespace
{
std::optional<double> degrees(const std::optional<double>& angle)
{
  return angle ? std::optional(radToDeg(*angle)) : std::nullopt;
}
}  // namespace

void CObservationStereoRanges::getDescriptionAsText(std::ostream& o) const
{
  CObservation::getDescriptionAsText(o);
  describeSensor(o, sensor_pose, field_of_view, max_range);
  if (baseline_focal > 0) o << "Baseline times focal length: " << decimalText(baseline_focal, 3) << " m px\n";
  o << detections.size() << (horizontal ? " ranges in the floor plane" : " slant ranges")
    << ":\n  id category range [m] std [m] bearing [deg] std [deg]\n";
  for (const Detection& d : detections)
    o << "  " << d.id << ' ' << textOrDash(d.category) << ' ' << decimalText(d.range, 4) << ' '
      << decimalText(rangeStd(d), 4) << ' ' << decimalText(degrees(d.bearing), 4) << ' '
      << decimalText(radToDeg(d.std_bearing), 4) << '\n';
}

std::string CObservationStereoRanges::exportTxtHeader() const
{
  return numberedHeader({"id", "category", "range_m", "std_range_m", "bearing_deg", "std_bearing_deg"});
}

std::string CObservationStereoRanges::exportTxtDataRow() const
{
  return numberedRow(detections.size(), 6,
                     [this](std::size_t i)
                     {
                       const Detection& d = detections[i];
                       return std::vector<std::string>{std::to_string(d.id),
                                                       textOrDash(d.category),
                                                       decimalText(d.range, 6),
                                                       decimalText(rangeStd(d), 6),
                                                       decimalText(degrees(d.bearing), 6),
                                                       decimalText(radToDeg(d.std_bearing), 6)};
                     });
}
}  // namespace mrpt_ext
