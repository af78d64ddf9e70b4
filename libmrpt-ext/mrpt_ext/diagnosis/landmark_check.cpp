#include "mrpt_ext/diagnosis/landmark_check.h"

#include <algorithm>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/hypotheses/landmark_measurement.h"
#include "mrpt_ext/solvers/pose_from_landmarks.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostFrames = 200, kMostMeasurements = 16, kLeastFrames = 10;
constexpr double kTolerance = 3;      // on the declared standard deviations
constexpr double kConsistent = 0.01;  // least probability of the residuals of an explained frame
constexpr double kMost = 0.5;         // share of the frames that counts as "the frames"
constexpr double kUsualBearingStd = degToRad(1.0);

std::vector<PoseMeasurement> measurementsOf(const Frame& frame, const LandmarkTable& map)
{
  std::vector<PoseMeasurement> measurements = poseMeasurements(identifiedMeasurements(frame.readings, map));
  std::erase_if(measurements, [](const PoseMeasurement& m) { return m.kind == PoseMeasurement::Kind::heading; });
  if (measurements.size() > kMostMeasurements) measurements.resize(kMostMeasurements);
  for (PoseMeasurement& m : measurements) m.std *= kTolerance;
  return measurements;
}

void mirror(PoseMeasurement& m)
{
  m.T_robot_sensor = {m.T_robot_sensor.x, -m.T_robot_sensor.y, -m.T_robot_sensor.phi};
  if (m.kind == PoseMeasurement::Kind::bearing) m.value = -m.value;
}

/// A bearing in radians that was read as degrees.
void fromRadians(PoseMeasurement& m)
{
  if (m.kind != PoseMeasurement::Kind::bearing) return;
  m.value = wrap(radToDeg(m.value));
  m.std = std::max(m.std, kTolerance * kUsualBearingStd);  // which may be in radians, too
}

std::string causeText(const LandmarkFaultFinding& finding)
{
  switch (finding.fault)
  {
    case LandmarkFault::motion:
      return "every frame fits the map by itself, but not the motion between them: check signs, clock and units of "
             "odometry, the angle at which the sensor is mounted, and, with bearings alone, the unit of the map";
    case LandmarkFault::mirrored:
      return "the frames fit when bearings are counted clockwise: check the sign of the bearings, the order of x "
             "and y in the map, and whether the map is mirrored";
    case LandmarkFault::radians:
      return "the frames fit when bearings are taken for radians: degrees are expected";
    case LandmarkFault::unit:
      return "the frames fit a map that is " + fixedText(finding.factor, 4) +
             " times as large: check the units of map and ranges";
    case LandmarkFault::unknown:
      break;
  }
  return "the frames fit the map in no way: check that the map is of this place and its ids are those of the "
         "detections";
}
}  // namespace

void LandmarkCheck::add(const Frame& frame)
{
  Measurements measurements = measurementsOf(frame, map_);
  if (measurements.size() < 4 || offered_++ % stride_ != 0) return;  // one more than a pose needs
  frames_.push_back(std::move(measurements));
  if (frames_.size() < 2 * kMostFrames) return;
  for (std::size_t k = 0; k < kMostFrames; ++k) frames_[k] = std::move(frames_[2 * k]);
  frames_.resize(kMostFrames);
  stride_ *= 2;
}

template <typename Change>
double LandmarkCheck::explained(const Change& change) const
{
  std::size_t count = 0;
  for (Measurements measurements : frames_)
  {
    std::for_each(measurements.begin(), measurements.end(), change);
    const IdentifiedPose found = solvePoseFromLandmarks(measurements);
    if (!found.candidates.empty() && found.consistency > kConsistent) ++count;
  }
  return static_cast<double>(count) / static_cast<double>(frames_.size());
}

LandmarkFaultFinding LandmarkCheck::findFault() const
{
  if (frames_.size() < kLeastFrames) return {};
  // First what is least likely by chance: bearings that are 57 times too small also fit from far away.
  if (explained(fromRadians) > kMost) return {LandmarkFault::radians};
  if (explained([](PoseMeasurement&) {}) > kMost) return {LandmarkFault::motion};
  if (explained(mirror) > kMost) return {LandmarkFault::mirrored};
  for (const double factor : {1000.0, 0.001, 100.0, 0.01, 0.3048, 1 / 0.3048})
    if (explained([=](PoseMeasurement& m) { m.landmark *= factor; }) > kMost) return {LandmarkFault::unit, factor};
  return {};
}

std::string LandmarkCheck::cause() const
{
  if (frames_.size() >= kLeastFrames) return causeText(findFault());
  return "check that the map is of this place, its unit, the order of x and y and its ids, and units, signs and clocks "
         "of detections and odometry";
}

std::string LandmarkCheck::hint(const std::map<std::string, LandmarkRecord>& landmarks) const
{
  constexpr std::size_t kLeastSeen = 10;  // detections
  constexpr double kOftenWrong = 0.7;     // inlier rate below
  std::size_t seen = 0, wrong = 0;
  for (const auto& [id, landmark] : landmarks)
  {
    if (landmark.seen < kLeastSeen) continue;
    ++seen;
    wrong += landmark.inlier_rate < kOftenWrong ? 1 : 0;
  }
  if (frames_.size() < kLeastFrames || wrong < 3 || 2 * wrong <= seen) return {};
  return std::to_string(wrong) + " of " + std::to_string(seen) +
         " landmarks are often wrong, so it is hardly the landmarks: " + cause();
}
}  // namespace mrpt_ext
