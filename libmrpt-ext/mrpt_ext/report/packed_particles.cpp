#include "mrpt_ext/report/packed_particles.h"

#include <Eigen/Geometry>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSteps = 4095, kHeadings = 256;

unsigned quantised(double value, double low, double extent)
{
  return extent > 0 ? static_cast<unsigned>(std::lround(kSteps * (value - low) / extent)) : 0U;
}

unsigned turnStep(double phi)
{
  const double turns = phi / kTwoPi;
  return static_cast<unsigned>(std::lround(kHeadings * (turns - std::floor(turns)))) & 255U;
}
}  // namespace

PackedPoses packPoses(const std::vector<Pose2>& poses)
{
  PackedPoses packed;
  if (poses.empty()) return packed;
  Eigen::AlignedBox2d box;
  for (const Pose2& pose : poses) box.extend(pose.position());
  packed.low = box.min();
  packed.extent = box.sizes();
  packed.bytes.reserve(4 * poses.size());
  for (const Pose2& pose : poses)
  {
    const unsigned x = quantised(pose.x, packed.low.x(), packed.extent.x());
    const unsigned y = quantised(pose.y, packed.low.y(), packed.extent.y());
    for (const unsigned byte : {x >> 4U, (x & 15U) << 4U | y >> 8U, y & 255U, turnStep(pose.phi)})
      packed.bytes += static_cast<char>(byte);
  }
  return packed;
}

std::string base64(const std::string& bytes)
{
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const auto byte = [&](std::size_t k)
    { return i + k < bytes.size() ? static_cast<unsigned>(static_cast<unsigned char>(bytes[i + k])) : 0U; };
    const unsigned bits = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (unsigned shift : {18U, 12U, 6U, 0U}) text += kDigits[bits >> shift & 63U];
  }
  const std::size_t rest = bytes.size() % 3;
  for (std::size_t i = 0; rest > 0 && i < 3 - rest; ++i) text[text.size() - 1 - i] = '=';
  return text;
}
}  // namespace mrpt_ext
