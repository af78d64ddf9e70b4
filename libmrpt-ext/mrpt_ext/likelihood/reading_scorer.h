#pragma once

#include <optional>
#include <span>

#include "mrpt_ext/likelihood/anonymous_scorer.h"
#include "mrpt_ext/likelihood/density_kernels.h"
#include "mrpt_ext/likelihood/missed_scorer.h"

namespace mrpt_ext
{
/// logLikelihood() of one reading, without the directions that landmarks face, for many robots, in single precision:
/// what does not depend on the robot is prepared once, then any number of batches about the same origin are scored,
/// also by several threads at a time.
///
/// Agrees with logLikelihood() to 2e-4 per anonymous detection (see AnonymousScorer) and to 1e-5 for each other
/// term, as far as single precision can tell the prediction: positions to 1e-7 of their distance from the origin,
/// headings to 3e-7 rad. For a detection z standard deviations s off, an error d of the prediction changes the result
/// by z d / s.
class ReadingScorer
{
 public:
  /// The reading, the map and the clutter must outlive the scorer.
  ReadingScorer(const Reading& reading, const LandmarkTable& map, const LandmarkClutter& clutter,
                const Vector2d& origin);
  ReadingScorer(const ReadingScorer&) = delete;
  ReadingScorer& operator=(const ReadingScorer&) = delete;

  /// Adds the log-likelihood of robot i to log_likelihood[i].
  void addTo(const PoseBatch& robots, std::span<float> log_likelihood) const;

 private:
  /// Identified detections of one kind that are scored by one kernel.
  struct Group
  {
    DetectionKind kind;
    int together = 8;  ///< see factorsPerLogarithm()
    std::vector<PreparedDetection> detections;
  };
  /// What is summed for one block of tiles.
  struct BlockTerms;

  void addIdentified(const Detection& detection, std::size_t landmark, double volume);
  Group& groupOf(const DetectionKind& kind);
  [[nodiscard]] bool isSpread(const PoseBatch& robots, std::size_t first, std::size_t count) const;
  void scoreBlock(const PoseBatch& robots, std::size_t first, std::size_t count, BlockTerms& terms,
                  std::span<float> log_likelihood) const;
  void scoreTile(const SensorTile& tile, const BlockTerms& terms, SensorTile::Column& log_sum) const;

  const Reading& reading_;
  const LandmarkTable& map_;
  const LandmarkClutter& clutter_;
  ScoringFrame frame_;
  double default_max_range_;
  double constant_ = 0;  // what is the same for every robot
  std::vector<Group> groups_;
  AnonymousScorer anonymous_;
  std::optional<MissedScorer> missed_;
};
}  // namespace mrpt_ext
