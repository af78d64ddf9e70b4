#pragma once

#include <array>
#include <memory>

#include "mrpt_ext/likelihood/landmark_clutter.h"
#include "mrpt_ext/likelihood/landmark_culling.h"
#include "mrpt_ext/likelihood/visibility_kernels.h"

namespace mrpt_ext
{
/// Likelihood of the detections of a reading that name a category or nothing: a sum over all landmarks they may show.
///
/// Robots close together see the same landmarks near a detection. Per block of tiles only those are summed that can be
/// within k standard deviations of it for any robot of the block, k such that all others together change no detection's
/// likelihood by more than kNeglected of itself (the clutter term alone bounds it from below). A block spread over the
/// map leaves nothing out.
class UnidentifiedScorer
{
 public:
  static constexpr double kNeglected = 1e-4;

  UnidentifiedScorer(const Reading& reading, const LandmarkTable& map, const LandmarkClutter& clutter,
                     const ScoringFrame& frame, double default_max_range);

  /// What is summed for one block.
  struct Terms
  {
    struct Set  ///< of candidates
    {
      float sure_chance = 0, sure_clutter = 0;  ///< sums over those surely in view
      std::vector<ViewedLandmark> rim;          ///< those perhaps in view
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
  void prepare(const LandmarkCulling& window, Terms& terms) const;
  void addTo(const SensorTile& tile, const Terms& terms, SensorTile::Column& log_sum) const;

 private:
  /// Landmarks that detections of one category may show.
  struct CandidateSet
  {
    std::string category;
    std::vector<std::uint32_t> landmarks;
    double mean_clutter = 0, least_clutter = 1;
  };
  struct Unidentified
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
  ViewLimits limits_;
  std::vector<CandidateSet> sets_;
  std::vector<Unidentified> detections_;
};
}  // namespace mrpt_ext
