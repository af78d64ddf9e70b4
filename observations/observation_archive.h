#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CArchive.h>

#include <optional>
#include <stdexcept>
#include <string>

/// What the serialization of our observations has in common. The base class writes neither its stamp nor its label.
namespace mrpt_ext
{
/// No sensor sees more features at once; a larger number means a damaged stream, not a larger allocation.
inline constexpr std::uint32_t kMaxDetections = 100'000;

inline void writeHeader(mrpt::serialization::CArchive& out, const mrpt::obs::CObservation& observation,
                        const mrpt::poses::CPose3D& sensor_pose)
{
  out << observation.timestamp << observation.sensorLabel << sensor_pose;
}

inline void readHeader(mrpt::serialization::CArchive& in, mrpt::obs::CObservation& observation,
                       mrpt::poses::CPose3D& sensor_pose)
{
  in >> observation.timestamp >> observation.sensorLabel >> sensor_pose;
}

inline void writeOptional(mrpt::serialization::CArchive& out, const std::optional<double>& value)
{
  out << value.has_value();
  if (value) out << *value;
}

[[nodiscard]] inline std::optional<double> readOptional(mrpt::serialization::CArchive& in)
{
  if (!in.ReadAs<bool>()) return std::nullopt;
  return in.ReadAs<double>();
}

[[nodiscard]] inline std::uint32_t readDetectionCount(mrpt::serialization::CArchive& in)
{
  const auto count = in.ReadAs<std::uint32_t>();
  if (count > kMaxDetections) throw std::runtime_error("implausible number of detections: " + std::to_string(count));
  return count;
}
}  // namespace mrpt_ext
