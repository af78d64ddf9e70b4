#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/filter/integrity/missed_landmarks.h"
#include "mrpt_ext/filter/motion/dead_reckoning.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/hypotheses/map_symmetries.h"
#include "mrpt_ext/hypotheses/pose_region.h"

namespace mrpt_ext
{
/// The poses from which the map looks nearly as it does from the pose under test: its images under the symmetries of
/// the map (hypotheses/map_symmetries.h).
///
/// What fits at a pose fits at these as well, and not by chance, so the null hypothesis says nothing about them. For
/// each, the odds of the pose against it are those of the start, changed by what the two expect to be seen
/// differently: landmarks that have no counterpart, or one of another category or identity. As the two are a pair
/// before anything is seen, no selection has to be feared, and every independent detection counts; those of one frame
/// within limits, so that one that is false decides nothing.
///
/// A landmark that was missed whenever it was in view, behind a wall or removed, is not expected to be the origin of
/// the next detection there: what fits it is clutter (MissedLandmarks::shareSeen()).
class SymmetricRivals
{
 public:
  /// `most`: log odds remembered at most.
  SymmetricRivals(const LandmarkTable& map, double most);

  /// The robot starts somewhere: nothing tells a pose from its images.
  void start();
  /// The robot started in `region`, `motion` before it was `now`: another mode, which is precise. Where its image would
  /// have started outside, that is no rival.
  void leaveOutOf(const PoseRegion& region, const GaussianPose& now, const DeadReckoning& motion);
  /// The start was given as a distribution, which odometry brings to `start`, when the pose became precise.
  void startAt(const GaussianPose& start, const Pose2& now);
  /// The pose is known.
  void accept();
  /// The pose under test is verified, against the rivals as well.
  void rememberVerified();
  /// Another mode is under test, that odometry did not lead to. From the one that was verified last it leads to
  /// `before`; absent: none was.
  void changeMode(const std::optional<GaussianPose>& before, const Pose2& now);
  /// The heading was measured by a compass. Its errors last, so only the last measurement counts.
  void useHeading(const CompassRecord& compass, const ParticleSet& particles);
  /// Some of normalised particles, which stand for all of them below; none without rivals.
  [[nodiscard]] ParticleSet drawsFrom(const ParticleSet& particles) const;
  /// Counts independent detections of one frame. `draws` are not weighted with them.
  void update(const std::vector<Reading>& independent, const LandmarkTable& map, const ParticleSet& draws);
  /// Counts what the first reading from a spot shows and misses, with all its detections.
  void look(const Reading& reading, const LandmarkTable& map, const ParticleSet& draws);
  /// Hypotheses compete with the pose under test: nothing counts against the one that survives.
  void doubt();

  [[nodiscard]] bool empty() const { return rivals_.empty(); }
  /// Log odds of the pose against the strongest of them; `most` without any.
  [[nodiscard]] double logOdds() const;
  /// Motion that leads from the pose under test to the strongest of them.
  [[nodiscard]] std::optional<Pose2> strongest() const;

 private:
  struct Rival
  {
    [[nodiscard]] double total() const { return log_odds + log_odds_of_heading; }

    MapSymmetry symmetry;
    MissedLandmarks missed;
    double log_odds = 0;
    double log_odds_of_heading = 0;   // by the last measurement of a compass
    double log_odds_of_verified = 0;  // of the pose that was verified last, or of the start
  };

  [[nodiscard]] const Rival* strongestRival() const;
  [[nodiscard]] double bounded(double log_odds) const;
  /// Another pose is under test: it was not looked for its landmarks yet.
  void forgetMissed();

  double most_;
  double log_density_anywhere_;  // of a robot that was carried somewhere else
  MissedLandmarks missed_;
  std::vector<Rival> rivals_;
};
}  // namespace mrpt_ext
