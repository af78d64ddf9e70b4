#include "mrpt_ext/configuration/filter_keys.h"

namespace mrpt_ext
{
namespace
{
constexpr ValueRange kPositive{1e-9, std::numeric_limits<double>::infinity()};
constexpr ValueRange kShare{0, 1};
constexpr ValueRange kCount{1, 1e8};
}  // namespace

KeyTable filterKeys()
{
  const std::string s = "ParticleFilter";
  using T = KeyType;
  return {{
      {s,
       "mode_cell_m",
       T::number,
       "m",
       "0.25",
       kPositive,
       {},
       "Peaks of the posterior closer than about two cells are one mode."},
      {s, "mode_cell_deg", T::number, "deg", "20", {0.1, 360}, {}, "The same for the heading."},
      {s, "learn_reliability", T::flag, "", "true", {}, {}, "Learn which landmarks give false readings."},
      {s,
       "reliability_prior",
       T::number,
       "",
       "30",
       kPositive,
       {},
       "The sensor's clutter probability counts as much as this many detections of a landmark."},
      {s,
       "reseed_inlier_ratio",
       T::number,
       "",
       "0.5",
       kShare,
       {},
       "When the share of recent detections that the pose explains falls below this, seeds are injected."},
      {s, "lost_share", T::number, "", "0.3", kShare, {}, "Below this the verdict is `lost`."},
      {s,
       "injected_particle_share",
       T::number,
       "",
       "0.25",
       kShare,
       {},
       "Injected particles per frame, of particles_count."},
      {s,
       "relocalization_prior",
       T::number,
       "",
       "0.02",
       {1e-9, 1},
       {},
       "Probability per injection that the robot is somewhere else altogether."},
      {s,
       "mode_kalman_filters",
       T::flag,
       "",
       "true",
       {},
       {},
       "While several places are possible, one Kalman filter per place divides the weight between them; the particles "
       "keep the shape of each."},
      {s,
       "kalman_proposal_below_ess",
       T::integer,
       "",
       "400",
       {0, 1e9},
       {},
       "Fewer effective particles than this are drawn anew around the posterior of an iterated Kalman update, with "
       "importance weights (at most 4000 particles held). 0: never."},
      {s, "ok_min_weight", T::number, "", "0.9", kShare, {}, "Least weight of the best mode for verdict `ok`."},
      {s,
       "ok_max_std_m",
       T::number,
       "m",
       "",
       kPositive,
       {},
       "Largest standard deviation of the position for `ok`; default: converged_within_m."},
      {s,
       "ok_max_std_deg",
       T::number,
       "deg",
       "",
       kPositive,
       {},
       "Largest standard deviation of the heading for `ok`; default: converged_within_deg."},
  }};
}

KeyTable mrptKeys()
{
  using T = KeyType;
  return {{
      {"PF_options",
       "PF_algorithm",
       T::choice,
       "",
       "pfStandardProposal",
       {},
       {{"pfStandardProposal", 0}, {"pfAuxiliaryPFStandard", 1}, {"pfAuxiliaryPFOptimal", 3}},
       "Proposal of the mrpt engine; that of the batch engine is chosen by kalman_proposal_below_ess."},
      {"PF_options",
       "resamplingMethod",
       T::choice,
       "",
       "prSystematic",
       {},
       {{"prMultinomial", 0}, {"prResidual", 1}, {"prStratified", 2}, {"prSystematic", 3}},
       "How particles are drawFromKalmanProposal."},
      {"PF_options", "adaptiveSampleSize", T::flag, "", "false", {}, {}, "KLD sample size, see [KLD_options]."},
      {"PF_options", "BETA", T::number, "", "0.5", kShare, {}, "Effective sample ratio below which is resampled."},
      {"PF_options", "sampleSize", T::integer, "", "2000", kCount, {}, "Number of particles; see particles_count."},
      {"KLD_options", "KLD_binSize_XY", T::number, "m", "0.2", kPositive, {}, "Size of a bin."},
      {"KLD_options", "KLD_binSize_PHI_deg", T::number, "deg", "10", {0.1, 360}, {}, "Size of a bin."},
      {"KLD_options", "KLD_delta", T::number, "", "0.01", {1e-6, 0.5}, {}, "Probability of exceeding KLD_epsilon."},
      {"KLD_options", "KLD_epsilon", T::number, "", "0.02", kPositive, {}, "Allowed Kullback-Leibler distance."},
      {"KLD_options", "KLD_minSampleSize", T::integer, "", "250", kCount, {}, "Least number of particles."},
      {"KLD_options", "KLD_maxSampleSize", T::integer, "", "100000", kCount, {}, "Largest number of particles."},
      {"MetricMap", "landmarkMap2D_count", T::integer, "", "1", {1, 1}, {}, "Number of landmark maps: one."},
      {"MetricMap_landmarkMap2D_00_creationOpts",
       "landmarks_file",
       T::path,
       "",
       "",
       {},
       {},
       "Map as CSV id,x,y,z,category[,std_x,std_y]; --map wins over it."},
  }};
}
}  // namespace mrpt_ext
