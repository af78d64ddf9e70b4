#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <chrono>
#include <iomanip>

#include "local_map_truth.h"
#include "mrpt_ext/correspondence/bearings/bearing_search.h"
#include "mrpt_ext/correspondence/pose_verification.h"
#include "mrpt_ext/solvers/two_landmark_pose.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr int kTrials = 60;
constexpr double kGate = 3.3;

struct Found
{
  std::size_t poses = 0;  // within 12 log units of the best
  bool truth_first = false;
};

Found tally(std::vector<ConsistentPose> poses, const Pose2& truth)
{
  std::sort(poses.begin(), poses.end(),
            [](const ConsistentPose& a, const ConsistentPose& b) { return a.log_evidence > b.log_evidence; });
  std::vector<ConsistentPose> distinct;
  for (const ConsistentPose& pose : poses)
  {
    if (pose.log_evidence < poses.front().log_evidence - 12) break;
    if (std::none_of(distinct.begin(), distinct.end(),
                     [&](const ConsistentPose& other) { return isAtTruth(pose.pose.mean, other.pose.mean); }))
      distinct.push_back(pose);
  }
  return {distinct.size(), !distinct.empty() && isAtTruth(distinct.front().pose.mean, truth)};
}

/// The best pairs of points against all pairs of landmarks at the same distance, verified on all detections.
Found searchPairs(const LocalLandmarkMap& local_map, const LandmarkIndex& index, const Pose2& truth)
{
  struct Pair
  {
    const LocalLandmark *a, *b;
    double distance, std;
  };
  std::vector<Pair> pairs;
  for (const LocalLandmark& a : local_map.points)
    for (const LocalLandmark& b : local_map.points)
    {
      const Vector2d apart = b.in_robot.mean - a.in_robot.mean;
      const Matrix2d C = a.in_robot.covariance + b.in_robot.covariance;
      const double distance = apart.norm();
      if (&a < &b) pairs.push_back({&a, &b, distance, std::sqrt(apart.dot(C * apart)) / distance});
    }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.std < q.std; });
  pairs.resize(std::min<std::size_t>(pairs.size(), 12));
  const std::vector<Scan> scans = asScans(local_map);
  const auto least = std::max(3, static_cast<int>(local_map.points.size() / 2));
  std::vector<ConsistentPose> poses;
  for (const Pair& pair : pairs)
    for (std::size_t i = 0; i < index.size(); ++i)
      index.forEachNear(index.position(i), pair.distance + kGate * pair.std,
                        [&](std::size_t j)
                        {
                          const double apart = (index.position(j) - index.position(i)).norm();
                          if (i == j || std::abs(apart - pair.distance) > kGate * pair.std) return;
                          const std::array seen{SeenLandmark{index.position(i), pair.a->in_robot},
                                                SeenLandmark{index.position(j), pair.b->in_robot}};
                          const PointPose fit = solvePointPose(seen);
                          if (fit.status != SolveStatus::ok) return;
                          if (const auto pose = verifyPose(index, scans, {.gate = kGate}, fit.pose, least))
                            poses.push_back(*pose);
                        });
  return tally(std::move(poses), truth);
}

double quantile(std::vector<double> values, double share)
{
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

struct Row
{
  std::vector<double> errors;
  double points = 0, right = 0, squared = 0, milliseconds = 0;
  double map_first = 0, map_poses = 0, scan_first = 0, scan_poses = 0;
};

Row measure(const WindowSceneOptions& options)
{
  RandomStream random(7);
  const SceneMap map = randomMap(options.scene, random);
  const LandmarkIndex index = map.index();
  const BearingSearch bearings(index);
  Row row;
  int settled = 0;
  for (int trial = 0; trial < kTrials; ++trial)
  {
    const WindowScene view = driveSomewhere(map, index, options, random);
    const auto begin = std::chrono::steady_clock::now();
    const LocalLandmarkMap local_map = buildLocalMap(view.scans);
    row.milliseconds +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count() / kTrials;
    for (const LocalLandmark& point : local_map.points)
    {
      const PointTruth truth = truthOf(point, view, index);
      row.points += 1.0 / kTrials;
      row.right += truth.right ? 1 : 0;
      if (!truth.right) continue;
      row.errors.push_back(truth.error);
      row.squared += truth.squared_error;
      ++settled;
    }
    const Found constellation = searchPairs(local_map, index, view.robot);
    row.map_first += 100.0 * constellation.truth_first / kTrials;
    row.map_poses += static_cast<double>(constellation.poses) / kTrials;
    const Found single = tally(bearings.search({&view.scans.back().scan, 1}).poses, view.robot);
    row.scan_first += 100.0 * single.truth_first / kTrials;
    row.scan_poses += static_cast<double>(single.poses) / kTrials;
  }
  row.right *= 100.0 / std::max(1.0, row.points * kTrials);
  row.squared /= std::max(1, settled);
  return row;
}

void run(std::ostream& out)
{
  out << kTrials << " drives in a map of 300 landmarks, one per 10 m^2, 70 % detected of those in range, one false "
      << "detection per scan, a scan every 0.25 m; odometry 2 % and 1 deg after one metre. A point is right if within "
      << "4.5 standard deviations of the landmark that most of its detections show. `first`: the most likely pose is "
      << "within 0.1 m and 1 deg of the truth; `poses`: within 12 log units of the best. `map`: the local map, matched "
      << "by pairs of its points; `scan`: the newest scan alone.\n\n"
      << "| range [m] | sigma [deg] | length [m] | points | right [%] | error median [m] | 90 % [m] | squared error / "
         "covariance | "
      << "time [ms] | map: first [%] | poses | scan: first [%] | poses |\n"
      << "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n"
      << std::fixed;
  struct Case
  {
    double range, sigma;
  };
  for (const auto& [range, sigma] : {Case{4, 0.1}, Case{4, 0.3}, Case{8, 0.1}})
    for (const double length : {1.0, 2.0, 3.0})
    {
      WindowSceneOptions options;
      options.scene.landmarks = 300;
      options.scene.max_range = range;
      options.scene.std_bearing = degToRad(sigma);
      options.length = length;
      const Row row = measure(options);
      out << "| " << std::setprecision(1) << range << " | " << sigma << " | " << length << " | " << row.points << " | "
          << row.right << " | " << std::setprecision(3) << quantile(row.errors, 0.5) << " | "
          << quantile(row.errors, 0.9) << " | " << std::setprecision(2) << row.squared << " | " << std::setprecision(1)
          << row.milliseconds << " | " << row.map_first << " | " << row.map_poses << " | " << row.scan_first << " | "
          << row.scan_poses << " |" << std::endl;
    }
}

const RegisterStudy kStudy("local_map",
                           "Local map from the bearings of a short trajectory: how many points, how accurate, and is "
                           "the pose found from them?",
                           run);
}  // namespace
}  // namespace mrpt_ext
