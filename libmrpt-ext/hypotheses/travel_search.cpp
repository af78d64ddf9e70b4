#include "mrpt_ext/hypotheses/travel_search.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "mrpt_ext/correspondence/tree_search.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/three_bearing_pose.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStdParallax = degToRad(0.7);  // of bearings taken within a look, from one place to the other
constexpr std::size_t kMostProposed = 500;      // by one look
constexpr std::size_t kMostFollowed = 400;
constexpr std::size_t kMostTracks = 40;  // judged from the beginning
constexpr double kSamePose = 1;          // standard deviations in each coordinate
constexpr std::size_t kApart = 3;        // looks between two that propose

class WaySearch
{
 public:
  WaySearch(std::span<const TravelStep> steps, const LostRobotSearch& search, const PoseRegion& region,
            const TravelSearchOptions& options)
      : steps_(steps), search_(search), map_(search.index()), region_(region), options_(options)
  {
  }

  TravelSearch run()
  {
    for (const std::size_t birth : births())
    {
      std::vector<Travelled> tracks = proposed(birth);
      result_.proposed += tracks.size();
      follow(tracks, birth);
      for (Travelled& track : tracks) judgeFromBeginning(std::move(track), birth);
    }
    rank();
    return std::move(result_);
  }

 private:
  struct Travelled
  {
    PoseTrack track;
    GaussianPose first;                       // at the look that proposed it
    std::vector<std::vector<int>> landmarks;  // taken in on the way back, newest look first
  };

  [[nodiscard]] std::size_t detections(std::size_t step) const { return detectionCount(steps_[step].seen); }

  /// The fullest looks, not next to each other.
  [[nodiscard]] std::vector<std::size_t> births() const
  {
    std::vector<std::size_t> order, chosen;
    for (std::size_t k = 0; k < steps_.size(); ++k)
      if (detections(k) >= 2) order.push_back(k);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return detections(a) > detections(b); });
    for (const std::size_t k : order)
    {
      const bool near =
          std::any_of(chosen.begin(), chosen.end(), [&](std::size_t c) { return (c > k ? c - k : k - c) < kApart; });
      if (!near) chosen.push_back(k);
      if (chosen.size() >= options_.births) break;
    }
    return chosen;
  }

  // ---- proposals

  [[nodiscard]] std::vector<Travelled> proposed(std::size_t birth) const
  {
    PoseSearchOptions options;
    options.gate = options_.gate;
    options.area = MapArea{region_.low, region_.low + region_.extent()};
    options.max_poses = kMostProposed;
    std::vector<Travelled> tracks;
    const auto add = [&](const GaussianPose& pose)
    {
      if (region_.contains(pose.mean)) tracks.push_back({{pose, 0}, pose, {}});
    };
    const std::vector<SensorPlace>& seen = steps_[birth].seen;
    if (pointCount(seen) >= 2)
      for (const ConsistentPose& pose : search_.search(seen, options).poses) add(pose.pose);
    else
      for (const GaussianPose& pose : fromBearings(seen)) add(pose);
    return tracks;
  }

  [[nodiscard]] static std::size_t pointCount(std::span<const SensorPlace> seen)
  {
    std::size_t points = 0;
    for (const SensorPlace& place : seen)
      points += static_cast<std::size_t>(std::count_if(place.detections.begin(), place.detections.end(),
                                                       [](const auto& d) { return d.bearing && d.range; }));
    return points;
  }

  /// Three bearings of a look, the widest apart and one between, as if all were taken from its last place, against all
  /// triples of landmarks.
  [[nodiscard]] std::vector<GaussianPose> fromBearings(std::span<const SensorPlace> seen) const
  {
    std::vector<PoseMeasurement> bearings;
    std::vector<int> kinds;
    for (const SensorPlace& place : seen)
      for (const UnidentifiedDetection& d : place.detections)
        if (d.bearing && d.kind != kNoSuchKind)
          bearings.push_back({PoseMeasurement::Kind::bearing, Vector2d::Zero(), *d.bearing,
                              std::hypot(d.std_bearing, kStdParallax), place.T_robot_sensor});
    for (const SensorPlace& place : seen)
      for (const UnidentifiedDetection& d : place.detections)
        if (d.bearing && d.kind != kNoSuchKind) kinds.push_back(d.kind);
    if (bearings.size() < 3 || map_.size() > kLargestTreeMap) return {};
    const std::array<std::size_t, 3> chosen = widest(bearings);
    std::array<PoseMeasurement, 3> three;
    for (std::size_t k = 0; k < 3; ++k) three[k] = bearings[chosen[k]];

    std::vector<GaussianPose> poses;
    const auto may = [&](std::size_t k, std::size_t landmark) { return map_.mayShow(kinds[chosen[k]], landmark); };
    for (std::size_t i = 0; i < map_.size(); ++i)
      for (std::size_t j = 0; j < map_.size() && may(0, i); ++j)
        for (std::size_t l = 0; l < map_.size() && j != i && may(1, j); ++l)
        {
          if (l == i || l == j || !may(2, l)) continue;
          three[0].landmark = map_.position(i);
          three[1].landmark = map_.position(j);
          three[2].landmark = map_.position(l);
          if (const auto pose = poseOf(three, seen.back().T_robot_sensor)) poses.push_back(*pose);
        }
    return poses;
  }

  static double robotAngle(const PoseMeasurement& m) { return m.value + m.T_robot_sensor.phi; }

  /// In angular order: the first, the one nearest to the middle, the last.
  static std::array<std::size_t, 3> widest(const std::vector<PoseMeasurement>& bearings)
  {
    std::vector<std::size_t> order(bearings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto angle = [&](std::size_t k) { return wrap(robotAngle(bearings[k]) - robotAngle(bearings.front())); };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
    const double middle = 0.5 * (angle(order.front()) + angle(order.back()));
    const auto centre = std::min_element(order.begin() + 1, order.end() - 1,
                                         [&](std::size_t a, std::size_t b)
                                         { return std::abs(angle(a) - middle) < std::abs(angle(b) - middle); });
    return {order.front(), *centre, order.back()};
  }

  /// The robot's pose when the bearings are taken from one place on it.
  [[nodiscard]] std::optional<GaussianPose> poseOf(const std::array<PoseMeasurement, 3>& bearings,
                                                   const Pose2& T_robot_sensor) const
  {
    std::array<SightedLandmark<double>, 3> sighted;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double angle = robotAngle(bearings[k]);
      sighted[k] = {bearings[k].landmark.x(), bearings[k].landmark.y(), std::cos(angle), std::sin(angle)};
    }
    const ThreeBearingPose<double> solved = solveThreeBearingPose(sighted[0], sighted[1], sighted[2]);
    if (solved.outcome != ThreeBearingOutcome::pose) return std::nullopt;
    // Found in the robot's axes, but at the sensor's place.
    const Pose2 robot =
        compose({solved.x, solved.y, std::atan2(solved.s, solved.c)}, {-T_robot_sensor.x, -T_robot_sensor.y, 0});
    if (!region_.contains(robot)) return std::nullopt;
    const std::optional<Matrix3d> covariance = covarianceFromInformation(poseInformation(bearings, robot));
    if (!covariance) return std::nullopt;
    return GaussianPose{robot, *covariance};
  }

  // ---- tracks

  /// Forward to the end of the way, then back from the look that proposed them to its beginning.
  void follow(std::vector<Travelled>& tracks, std::size_t birth) const
  {
    for (Travelled& t : tracks) confront(t.track, map_, steps_[birth].seen, options_.gate);
    prune(tracks);
    for (std::size_t k = birth + 1; k < steps_.size(); ++k)
    {
      for (Travelled& t : tracks)
      {
        moveForward(t.track, steps_[k]);
        confront(t.track, map_, steps_[k].seen, options_.gate);
      }
      if (!steps_[k].seen.empty()) prune(tracks);
    }
    for (Travelled& t : tracks) t.track.pose = t.first;
    for (std::size_t k = birth + 1; k-- > 0;)
    {
      for (Travelled& t : tracks)
      {
        t.landmarks.push_back(confront(t.track, map_, steps_[k].seen, options_.gate));
        if (k > 0) moveBack(t.track, steps_[k]);
      }
      if (!steps_[k].seen.empty()) prune(tracks);
    }
    if (tracks.size() > kMostTracks) tracks.resize(kMostTracks);
  }

  /// Best first, without those that have fallen behind, left the region, or met a better one.
  void prune(std::vector<Travelled>& tracks) const
  {
    std::stable_sort(tracks.begin(), tracks.end(),
                     [](const Travelled& a, const Travelled& b)
                     { return a.track.log_evidence > b.track.log_evidence; });
    const double best = tracks.empty() ? 0 : tracks.front().track.log_evidence;
    std::vector<Travelled> kept;
    for (Travelled& t : tracks)
    {
      if (t.track.log_evidence < best - options_.keep_log_units || kept.size() >= kMostFollowed) break;
      if (std::none_of(kept.begin(), kept.end(),
                       [&](const Travelled& k) { return samePose(k.track.pose, t.track.pose); }))
        kept.push_back(std::move(t));
    }
    tracks = std::move(kept);
  }

  /// Neither lies outside the other's uncertainty.
  [[nodiscard]] static bool samePose(const GaussianPose& a, const GaussianPose& b)
  {
    const Vector3d e(a.mean.x - b.mean.x, a.mean.y - b.mean.y, wrap(a.mean.phi - b.mean.phi));
    for (Eigen::Index k = 0; k < 3; ++k)
      if (square(e(k)) > square(kSamePose) * std::min(a.covariance(k, k), b.covariance(k, k))) return false;
    return true;
  }

  // ---- judgement

  void judgeFromBeginning(Travelled track, std::size_t birth)
  {
    PoseTrack again{track.track.pose, 0};
    const Vector2d extent = region_.extent();
    again.pose.covariance = Vector3d(square(extent.x()), square(extent.y()), square(kTwoPi)).asDiagonal();
    for (std::size_t k = 0; k < steps_.size(); ++k)
    {
      if (k > 0) moveForward(again, steps_[k]);
      if (k <= birth)
        confrontAs(again, map_, steps_[k].seen, track.landmarks[birth - k]);
      else
        confront(again, map_, steps_[k].seen, options_.gate);
    }
    if (region_.contains(again.pose.mean) && again.pose.covariance.allFinite()) judged_.push_back(again);
  }

  void rank()
  {
    if (result_.proposed == 0) return;
    result_.status = SolveStatus::none;
    std::stable_sort(judged_.begin(), judged_.end(),
                     [](const PoseTrack& a, const PoseTrack& b) { return a.log_evidence > b.log_evidence; });
    std::vector<PoseTrack> distinct;
    for (const PoseTrack& track : judged_)
    {
      if (track.log_evidence < judged_.front().log_evidence - options_.keep_log_units) break;
      if (std::none_of(distinct.begin(), distinct.end(),
                       [&](const PoseTrack& d) { return samePlace(d.pose, track.pose); }))
        distinct.push_back(track);
    }
    if (distinct.empty()) return;
    double expected = std::log(options_.missed);
    for (const TravelStep& step : steps_) expected += expectedEvidence(map_, step.seen);
    const double best = distinct.front().log_evidence;
    double total = std::exp(expected - best);
    if (!(total < 1e300)) total = 1e300;
    for (const PoseTrack& track : distinct) total += std::exp(track.log_evidence - best);
    double known = 0;
    for (const PoseTrack& track : distinct)
    {
      const double weight = std::exp(track.log_evidence - best) / total;
      known += weight;
      result_.hypotheses.push_back(
          {.pose = track.pose, .log_score = track.log_evidence, .weight = weight, .source = "travel_search"});
    }
    result_.elsewhere = std::max(0.0, 1 - known);
    result_.status = SolveStatus::ok;
  }

  /// Within four standard deviations of the better one.
  [[nodiscard]] static bool samePlace(const GaussianPose& better, const GaussianPose& other)
  {
    const Vector3d e(other.mean.x - better.mean.x, other.mean.y - better.mean.y,
                     wrap(other.mean.phi - better.mean.phi));
    return e.dot(better.covariance.ldlt().solve(e)) < 16;
  }

  std::span<const TravelStep> steps_;
  const LostRobotSearch& search_;
  const LandmarkIndex& map_;
  const PoseRegion& region_;
  const TravelSearchOptions& options_;
  std::vector<PoseTrack> judged_;
  TravelSearch result_;
};
}  // namespace

TravelSearch searchAlongWay(std::span<const TravelStep> oldest_first, const LostRobotSearch& search,
                            const PoseRegion& region, const TravelSearchOptions& options)
{
  return WaySearch(oldest_first, search, region, options).run();
}
}  // namespace mrpt_ext
