#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CArchive.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "mrpt_ext/geometry/facing.h"

/// Shared by the serialization of our observations. The base class writes neither its stamp nor its label.
namespace mrpt_ext
{
/// No sensor sees more features at once; a larger number means a damaged stream, not a larger allocation.
inline constexpr std::uint32_t kMaxDetections = 100'000;

inline constexpr std::uint32_t kMaxTextLength = 10'000;

/// As MRPT serializes a string, but a damaged length is rejected before memory is allocated for it.
inline void writeText(mrpt::serialization::CArchive& out, const std::string& text)
{
  out << static_cast<std::uint32_t>(text.size());
  if (!text.empty()) out.WriteBuffer(text.data(), text.size());
}

inline void readText(mrpt::serialization::CArchive& in, std::string& text)
{
  const auto length = in.ReadAs<std::uint32_t>();
  if (length > kMaxTextLength) throw std::runtime_error("implausible length of a text: " + std::to_string(length));
  text.resize(length);
  if (length > 0) in.ReadBuffer(text.data(), length);
}

inline void writeHeader(mrpt::serialization::CArchive& out, const mrpt::obs::CObservation& observation,
                        const mrpt::poses::CPose3D& sensor_pose)
{
  out << observation.timestamp;
  writeText(out, observation.sensorLabel);
  out << sensor_pose;
}

inline void readHeader(mrpt::serialization::CArchive& in, mrpt::obs::CObservation& observation,
                       mrpt::poses::CPose3D& sensor_pose)
{
  in >> observation.timestamp;
  readText(in, observation.sensorLabel);
  in >> sensor_pose;
}

inline void writeOptional(mrpt::serialization::CArchive& out, const std::optional<double>& value)
{
  out << value.has_value();
  if (value) out << *value;
}

/// A bool whose byte may be damaged.
[[nodiscard]] inline bool readFlag(mrpt::serialization::CArchive& in)
{
  const auto byte = in.ReadAs<std::uint8_t>();
  if (byte > 1) throw std::runtime_error("a flag of " + std::to_string(byte) + ", expected 0 or 1");
  return byte == 1;
}

[[nodiscard]] inline std::optional<double> readOptional(mrpt::serialization::CArchive& in)
{
  if (!readFlag(in)) return std::nullopt;
  return in.ReadAs<double>();
}

/// Both attitudes; the probability of the second follows from that of the first.
inline void writeFacing(mrpt::serialization::CArchive& out, const std::optional<Facing>& facing)
{
  out << facing.has_value();
  if (!facing) return;
  for (const Facing::Attitude& attitude : facing->attitudes) out << attitude.yaw << attitude.std;
  out << facing->attitudes.back().weight;
}

[[nodiscard]] inline std::optional<Facing> readFacing(mrpt::serialization::CArchive& in)
{
  if (!readFlag(in)) return std::nullopt;
  Facing facing;
  for (Facing::Attitude& attitude : facing.attitudes) in >> attitude.yaw >> attitude.std;
  const auto other = in.ReadAs<double>();
  facing.attitudes.front().weight = 1 - other, facing.attitudes.back().weight = other;
  return facing;
}

[[nodiscard]] inline std::uint32_t readDetectionCount(mrpt::serialization::CArchive& in)
{
  const auto count = in.ReadAs<std::uint32_t>();
  if (count > kMaxDetections) throw std::runtime_error("implausible number of detections: " + std::to_string(count));
  return count;
}
}  // namespace mrpt_ext
