#include "mrpt_ext/observations/CObservationStereoRanges.h"

#include <algorithm>
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

// Version 1 adds `facing`. What has none is written as version 0, which older programs read.
std::uint8_t CObservationStereoRanges::serializeGetVersion() const
{
  const auto faces = [](const Detection& d) { return d.facing.has_value(); };
  return std::any_of(detections.begin(), detections.end(), faces) ? 1 : 0;
}

void CObservationStereoRanges::serializeTo(mrpt::serialization::CArchive& out) const
{
  const bool with_facing = serializeGetVersion() > 0;
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
    if (with_facing) writeFacing(out, d.facing);
  }
}

void CObservationStereoRanges::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version)
{
  switch (version)
  {
    case 0:
    case 1:
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
        if (version > 0) d.facing = readFacing(in);
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

/// " 170.0 2.1" and, where there is one, the other attitude with its probability: " (or 150.0 3.4, 0.12)".
std::string facingText(const std::optional<Facing>& facing)
{
  if (!facing) return " nan nan";
  const auto& [first, second] = facing->attitudes;
  const auto textOf = [](const Facing::Attitude& a)
  { return decimalText(radToDeg(a.yaw), 4) + ' ' + decimalText(radToDeg(a.std), 4); };
  return ' ' + textOf(first) +
         (second.weight > 0 ? " (or " + textOf(second) + ", " + decimalText(second.weight, 4) + ')' : "");
}
}  // namespace

void CObservationStereoRanges::getDescriptionAsText(std::ostream& o) const
{
  CObservation::getDescriptionAsText(o);
  describeSensor(o, sensor_pose, field_of_view, max_range);
  if (baseline_focal > 0) o << "Baseline times focal length: " << decimalText(baseline_focal, 3) << " m px\n";
  const bool facing = serializeGetVersion() > 0;
  o << detections.size() << (horizontal ? " ranges in the floor plane" : " slant ranges")
    << ":\n  id category range [m] std [m] bearing [deg] std [deg]" << (facing ? " yaw [deg] std [deg]" : "") << '\n';
  for (const Detection& d : detections)
    o << "  " << d.id << ' ' << textOrDash(d.category) << ' ' << decimalText(d.range, 4) << ' '
      << decimalText(rangeStd(d), 4) << ' ' << decimalText(degrees(d.bearing), 4) << ' '
      << decimalText(radToDeg(d.std_bearing), 4) << (facing ? facingText(d.facing) : "") << '\n';
}

std::string CObservationStereoRanges::exportTxtHeader() const
{
  return numberedHeader({"id", "category", "range_m", "std_range_m", "bearing_deg", "std_bearing_deg"}) +
         numberedNames({"yaw_deg", "std_yaw_deg"});
}

std::string CObservationStereoRanges::exportTxtDataRow() const
{
  const auto measured = [this](std::size_t i)
  {
    const Detection& d = detections[i];
    return std::vector<std::string>{std::to_string(d.id),
                                    textOrDash(d.category),
                                    decimalText(d.range, 6),
                                    decimalText(rangeStd(d), 6),
                                    decimalText(degrees(d.bearing), 6),
                                    decimalText(radToDeg(d.std_bearing), 6)};
  };
  const auto faces = [this](std::size_t i)
  {
    const auto& facing = detections[i].facing;
    if (!facing) return std::vector<std::string>(2, "nan");
    const Facing::Attitude& likelier = facing->attitudes.front();
    return std::vector<std::string>{decimalText(radToDeg(likelier.yaw), 6), decimalText(radToDeg(likelier.std), 6)};
  };
  return numberedRow(detections.size(), 6, measured) + numberedCells(detections.size(), 2, faces);
}
}  // namespace mrpt_ext
