#include <algorithm>
#include <cmath>
#include <ctime>
#include <iomanip>

#include "mrpt_ext/correspondence/global_pose_search.h"
#include "mrpt_ext/importers/mrclam_snapshots.h"
#include "mrpt_ext/solvers/pose_from_landmarks.h"
#include "shared_data.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
// One noise model for all sets and robots: the relative bearings of a snapshot have standard deviations of 0.22 to 0.50
// deg, depending on the robot; ranges as in mrclam-snapshots.ini: they are depths along the optical axis (10 % short at
// the border of the image) and 3 to 4 % too long.
constexpr double kStdBearing = degToRad(0.5), kScaleRange = 1.033, kStdRange = 0.03, kStdRangePerM = 0.015;
constexpr double kClutter = 0.05;
constexpr double kFieldOfView = degToRad(70.0),
                 kMaxRange = 9.5;  // of the camera: all detections of all robots are within
constexpr double kMargin = 6;      // [m] around the landmarks, which fill a part of the room in set 5
constexpr std::size_t kLeastLandmarks = 4;
constexpr std::size_t kMostSnapshots = 300;                             // of a set, evenly sampled
constexpr double kRightPosition = 0.5, kRightHeading = degToRad(15.0);  // the contract's convergence

bool isRight(const Pose2& pose, const Pose2& truth)
{
  return (pose.position() - truth.position()).norm() <= kRightPosition &&
         std::abs(wrap(pose.phi - truth.phi)) <= kRightHeading;
}

double stdRange(double range) { return kStdRange + kStdRangePerM * range; }

/// From depth along the axis to distance.
void correctRanges(Reading& reading)
{
  for (Detection& d : reading.detections) *d.range /= kScaleRange * std::cos(*d.bearing);
}

/// The best pose with known identities.
std::optional<Pose2> identifiedPose(const Reading& reading, const LandmarkTable& map, bool with_ranges)
{
  std::vector<PoseMeasurement> measurements;
  for (const Detection& d : reading.detections)
  {
    const Vector2d landmark = map[*map.indexOf(d.id)].position.head<2>();
    measurements.push_back({PoseMeasurement::Kind::bearing, landmark, *d.bearing, kStdBearing, reading.T_robot_sensor});
    if (with_ranges)
      measurements.push_back(
          {PoseMeasurement::Kind::range, landmark, *d.range, stdRange(*d.range), reading.T_robot_sensor});
  }
  const IdentifiedPose found = solvePoseFromLandmarks(measurements);
  if (found.candidates.empty()) return std::nullopt;
  return found.candidates.front().pose.mean;
}

Scan withoutIdentities(const Reading& reading, bool with_ranges)
{
  Scan scan{reading.T_robot_sensor, {}, {}};
  scan.model.clutter_probability = kClutter;
  scan.model.max_range = kMaxRange;
  scan.model.field_of_view = kFieldOfView;
  scan.model.has_field_of_view = true;
  for (const Detection& d : reading.detections)
  {
    AnonymousDetection& anonymous = scan.detections.emplace_back();
    anonymous.bearing = d.bearing;
    anonymous.std_bearing = kStdBearing;
    if (with_ranges) anonymous.range = d.range;
    anonymous.std_range = stdRange(*d.range);
  }
  return scan;
}

struct Tally
{
  int snapshots = 0, known = 0, first = 0, among = 0, unique = 0, unique_wrong = 0;
  double returned = 0;
  std::vector<double> ms;
};

/// The snapshots with enough landmarks, as indices of `records`.
std::vector<std::size_t> chosenSnapshots(const Recording& recording)
{
  std::vector<std::size_t> all, chosen;
  for (std::size_t k = 0; k < recording.records.size(); ++k)
    if (const auto* reading = std::get_if<Reading>(&recording.records[k]))
      if (reading->detections.size() >= kLeastLandmarks) all.push_back(k);
  const std::size_t count = std::min(all.size(), kMostSnapshots);
  for (std::size_t k = 0; k < count; ++k) chosen.push_back(all[k * all.size() / count]);
  return chosen;
}

Tally tallyOf(const Recording& recording, bool with_ranges)
{
  const GlobalPoseSearch search(recording.map);
  const auto [low, high] = recording.map.boundingBox();
  PoseSearchOptions options;
  options.area = Box2{low.array() - kMargin, high.array() + kMargin};
  Tally tally;
  for (const std::size_t k : chosenSnapshots(recording))
  {
    Reading reading = std::get<Reading>(recording.records[k]);
    correctRanges(reading);
    const Pose2 truth = interpolate(recording.truth, reading.time, 0.5)->pose;
    ++tally.snapshots;
    const auto known = identifiedPose(reading, recording.map, with_ranges);
    tally.known += known && isRight(*known, truth);
    const Scan scan = withoutIdentities(reading, with_ranges);
    const std::clock_t start = std::clock();
    const PoseSearchResult found = search.search({&scan, 1}, options);
    tally.ms.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    const bool first = !found.poses.empty() && isRight(found.poses.front().pose.mean, truth);
    tally.first += first;
    tally.among += std::any_of(found.poses.begin(), found.poses.end(),
                               [&](const ConsistentPose& p) { return isRight(p.pose.mean, truth); });
    tally.returned += static_cast<double>(found.poses.size());
    tally.unique += found.unique;
    tally.unique_wrong += found.unique && !first;
  }
  return tally;
}

void print(std::ostream& out, int set, const char* what, Tally tally)
{
  const double n = std::max(1, tally.snapshots);
  std::sort(tally.ms.begin(), tally.ms.end());
  out << "| " << set << " | " << what << " | " << tally.snapshots << " | " << std::fixed << std::setprecision(1)
      << 100 * tally.known / n << " % | " << 100 * tally.first / n << " % | " << 100 * tally.among / n << " % | "
      << tally.returned / n << " | " << 100 * tally.unique / n << " % | " << tally.unique_wrong << " | "
      << std::setprecision(3) << (tally.ms.empty() ? 0 : tally.ms[tally.ms.size() / 2]) << " |" << std::defaultfloat
      << std::endl;
}

void run(std::ostream& out)
{
  out << "Snapshots with " << kLeastLandmarks << " or more landmarks, at most " << kMostSnapshots
      << " of a set, evenly sampled. Right: within " << kRightPosition << " m and " << radToDeg(kRightHeading)
      << " deg of the motion capture.\n\n| set | measured | snapshots | identified: right | anonymous: right pose "
         "first "
         "| among the returned | returned | called unique | of these wrong | processor, median [ms] |\n"
      << "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const int set : {1, 2, 3, 5, 6})
  {
    const auto folder = sharedData("mrclam/MRCLAM_Dataset" + std::to_string(set));
    if (!folder)
    {
      out << "skipped: MRCLAM data set " << set << " is not there (LANDMARK_DATA_DIR)\n";
      continue;
    }
    const Recording recording = importMrclamSnapshots(*folder);
    print(out, set, "range and bearing", tallyOf(recording, true));
    print(out, set, "bearing", tallyOf(recording, false));
  }
}

const RegisterStudy kStudy("anonymous_snapshots",
                           "MRCLAM snapshots without identities: how often is the true pose first, and among how many?",
                           run);
}  // namespace
}  // namespace mrpt_ext
