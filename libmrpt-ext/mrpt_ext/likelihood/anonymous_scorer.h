#pragma once

#include <array>
#include <memory>

#include "mrpt_ext/likelihood/landmark_clutter.h"
#include "mrpt_ext/likelihood/landmark_culling.h"
#include "mrpt_ext/likelihood/visibility_kernels.h"

namespace mrpt_ext
{
/// Likelihood of the anonymous detections of a reading (category or nothing known): a sum over all landmarks that they
/// may show.
///
/// Robots close together see the same landmarks near a detection. Per block of tiles only those landmarks are summed
/// that may be within k standard deviations of the detection for any robot of the block, with k such that all others
/// together change no likelihood by more than kNeglected of itself (the clutter term bounds it from below). For a block
/// that is spread over the map nothing is left out.
class AnonymousScorer
{
 public:
  static constexpr double kNeglected = 1e-4;

  AnonymousScorer(const Reading& reading, const LandmarkTable& map, const LandmarkClutter& clutter,
                  const ScoringFrame& frame, double default_max_range);

  /// What is summed for one block.
  struct Terms
  {
    struct Set  ///< of candidates
    {
      float certain_visibility = 0, certain_clutter = 0;  ///< sums over those in view of all
      std::vector<ViewedLandmark> rim;                    ///< in view of some
    };
    struct Sum  ///< of one detection
    {
      std::vector<PreparedDetection> sharp, broad;
    };
    std::vector<Set> sets;
    std::vector<Sum> sums;
    std::vector<std::uint32_t> near;
  };

  [[nodiscard]] bool empty() const { return detections_.empty(); }
  void prepare(const LandmarkCulling& culling, Terms& terms) const;
  void addTo(const SensorTile& tile, const Terms& terms, SensorTile::Column& log_sum) const;

 private:
  /// Landmarks that detections of one category may show.
  struct CandidateSet
  {
    std::string category;
    std::vector<std::uint32_t> landmarks;
    double mean_clutter = 0, least_clutter = 1;
  };
  struct AnonymousTerm
  {
    const Detection* detection;
    std::size_t set;
    float clutter_density;  ///< 1 / V
    double cut;             ///< [standard deviations]
  };

  std::size_t setOf(const Detection& detection);

  const Reading& reading_;
  const LandmarkTable& map_;
  const LandmarkClutter& clutter_;
  const ScoringFrame& frame_;
  VisibilityLimits limits_;
  std::vector<CandidateSet> sets_;
  std::vector<AnonymousTerm> detections_;
};
}  // namespace mrpt_ext
