#include "mrpt_ext/observations/CObservationLandmarkBearings.h"

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/observations/observation_archive.h"
#include "mrpt_ext/observations/observation_text.h"

IMPLEMENTS_SERIALIZABLE(CObservationLandmarkBearings, mrpt::obs::CObservation, mrpt_ext)

namespace mrpt_ext
{
std::uint8_t CObservationLandmarkBearings::serializeGetVersion() const { return 0; }

void CObservationLandmarkBearings::serializeTo(mrpt::serialization::CArchive& out) const
{
  writeHeader(out, *this, sensor_pose);
  out << field_of_view << max_range << static_cast<std::uint32_t>(detections.size());
  for (const Detection& d : detections)
  {
    out << d.id;
    writeText(out, d.category);
    out << d.bearing << d.std_bearing;
  }
}

void CObservationLandmarkBearings::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version)
{
  switch (version)
  {
    case 0:
      readHeader(in, *this, sensor_pose);
      in >> field_of_view >> max_range;
      detections.assign(readDetectionCount(in), {});
      for (Detection& d : detections)
      {
        in >> d.id;
        readText(in, d.category);
        in >> d.bearing >> d.std_bearing;
      }
      break;
    default:
      MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  }
}

void CObservationLandmarkBearings::getDescriptionAsText(std::ostream& o) const
{
  CObservation::getDescriptionAsText(o);
  describeSensor(o, sensor_pose, field_of_view, max_range);
  o << detections.size() << " bearings:\n  id category bearing [deg] std [deg]\n";
  for (const Detection& d : detections)
    o << "  " << d.id << ' ' << textOrDash(d.category) << ' ' << decimalText(radToDeg(d.bearing), 4) << ' '
      << decimalText(radToDeg(d.std_bearing), 4) << '\n';
}

std::string CObservationLandmarkBearings::exportTxtHeader() const
{
  return numberedHeader({"id", "category", "bearing_deg", "std_bearing_deg"});
}

std::string CObservationLandmarkBearings::exportTxtDataRow() const
{
  return numberedRow(detections.size(), 4,
                     [this](std::size_t i)
                     {
                       const Detection& d = detections[i];
                       return std::vector<std::string>{std::to_string(d.id), textOrDash(d.category),
                                                       decimalText(radToDeg(d.bearing), 6),
                                                       decimalText(radToDeg(d.std_bearing), 6)};
                     });
}
}  // namespace mrpt_ext
