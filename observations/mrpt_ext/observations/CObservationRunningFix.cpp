#include "mrpt_ext/observations/CObservationRunningFix.h"

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/observations/observation_archive.h"
#include "mrpt_ext/observations/observation_text.h"
#include "mrpt_ext/observations/timestamps.h"

IMPLEMENTS_SERIALIZABLE(CObservationRunningFix, mrpt::obs::CObservation, mrpt_ext)

namespace mrpt_ext
{
std::uint8_t CObservationRunningFix::serializeGetVersion() const { return 0; }

void CObservationRunningFix::serializeTo(mrpt::serialization::CArchive& out) const
{
  writeHeader(out, *this, sensor_pose);
  out << horizontal << id << first_timestamp << first_range << first_std << second_range << second_std << displacement;
  for (int i = 0; i < 9; ++i) out << displacement_covariance(i / 3, i % 3);
  writeOptional(out, second_bearing);
  out << second_bearing_std;
}

void CObservationRunningFix::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version)
{
  switch (version)
  {
    case 0:
      readHeader(in, *this, sensor_pose);
      horizontal = readFlag(in);
      in >> id >> first_timestamp >> first_range >> first_std >> second_range >> second_std >> displacement;
      for (int i = 0; i < 9; ++i) in >> displacement_covariance(i / 3, i % 3);
      second_bearing = readOptional(in);
      in >> second_bearing_std;
      break;
    default:
      MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  }
}

void CObservationRunningFix::getDescriptionAsText(std::ostream& o) const
{
  CObservation::getDescriptionAsText(o);
  describeSensor(o, sensor_pose, 0, 0);
  o << "Landmark: " << id << (horizontal ? ", ranges in the floor plane\n" : ", slant ranges\n");
  o << "First range: " << decimalText(first_range, 4) << " +- " << decimalText(first_std, 4) << " m at "
    << decimalText(secondsOf(first_timestamp), 3) << " s\n";
  o << "Second range: " << decimalText(second_range, 4) << " +- " << decimalText(second_std, 4) << " m at "
    << decimalText(secondsOf(timestamp), 3) << " s\n";
  o << "Displacement: " << displacement.asString() << " with covariance\n" << displacement_covariance << '\n';
  if (second_bearing)
    o << "Second bearing: " << decimalText(radToDeg(*second_bearing), 4) << " +- "
      << decimalText(radToDeg(second_bearing_std), 4) << " deg\n";
}

std::string CObservationRunningFix::exportTxtHeader() const
{
  return "id first_time first_range_m first_std_m second_range_m second_std_m dx_m dy_m dphi_deg cxx cxy cxp cyy cyp "
         "cpp second_bearing_deg second_bearing_std_deg";
}

std::string CObservationRunningFix::exportTxtDataRow() const
{
  std::string row = std::to_string(id);
  for (double value : {secondsOf(first_timestamp), first_range, first_std, second_range, second_std, displacement.x(),
                       displacement.y(), radToDeg(displacement.phi())})
    row += ' ' + decimalText(value, 6);
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) row += ' ' + decimalText(displacement_covariance(i, j), 9);
  row += ' ' + decimalText(second_bearing ? std::optional(radToDeg(*second_bearing)) : std::nullopt, 6);
  return row + ' ' + decimalText(radToDeg(second_bearing_std), 6);
}
}  // namespace mrpt_ext
