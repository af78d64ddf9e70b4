#include "mrpt_ext/solvers/camera_yaw_calibration.h"

#include <algorithm>
#include <vector>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
constexpr double kAgreement = 3;  ///< standard deviations within which two sightings agree

/// Measured minus predicted bearing.
struct Turn
{
  double angle = 0;
  double std = 0;
};

bool agree(const Turn& a, const Turn& b)
{
  return std::abs(wrap(a.angle - b.angle)) <= kAgreement * std::hypot(a.std, b.std);
}

/// The largest set that agrees with one of its members.
std::vector<Turn> consensus(const std::vector<Turn>& turns)
{
  std::vector<Turn> best;
  for (const Turn& candidate : turns)
  {
    std::vector<Turn> agreeing;
    std::copy_if(turns.begin(), turns.end(), std::back_inserter(agreeing),
                 [&](const Turn& turn) { return agree(candidate, turn); });
    if (agreeing.size() > best.size()) best = std::move(agreeing);
  }
  return best;
}

double spreadOf(const std::vector<Turn>& turns)
{
  double spread = 0;
  for (const Turn& a : turns)
    for (const Turn& b : turns) spread = std::max(spread, std::abs(wrap(a.angle - b.angle)));
  return spread;
}
}  // namespace

CameraYaw calibrateCameraYaw(std::span<const CalibrationSighting> sightings, const Pose2& T_robot_camera)
{
  CameraYaw result;
  if (sightings.empty()) return result;
  std::vector<Turn> turns;
  Vector2d all = Vector2d::Zero();
  for (const CalibrationSighting& s : sightings)
  {
    turns.push_back({wrap(s.bearing - predictBearing(s.robot, s.landmark, T_robot_camera)), s.std_bearing});
    all += direction(turns.back().angle);
  }
  result.status = SolveStatus::bad_input;
  if (!all.allFinite()) return result;
  result.spread = spreadOf(turns);
  const bool comparable = std::all_of(turns.begin(), turns.end(), [](const Turn& turn) { return turn.std > 0; });
  if (comparable)
  {
    result.status = turns.size() < 2 ? SolveStatus::too_few : SolveStatus::none;
    auto agreeing = consensus(turns);
    if (agreeing.size() < 2 || 2 * agreeing.size() <= turns.size()) return result;
    turns = std::move(agreeing);
  }
  Vector2d sum = Vector2d::Zero();
  for (const Turn& turn : turns) sum += direction(turn.angle);
  const double count = static_cast<double>(turns.size());
  result.status = SolveStatus::none;
  if (sum.norm() < 0.5 * count) return result;

  result.status = SolveStatus::ok;
  result.used = turns.size();
  result.offset = angleOf(sum);
  double squares = 0;
  for (const Turn& turn : turns) squares += square(wrap(turn.angle - result.offset));
  if (turns.size() > 1) result.scatter = std::sqrt(squares / (count - 1));
  result.std_offset = result.scatter / std::sqrt(count);
  return result;
}
}  // namespace mrpt_ext
