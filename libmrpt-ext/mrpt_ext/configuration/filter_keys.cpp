#include "mrpt_ext/configuration/filter_keys.h"

#include "mrpt_ext/configuration/configured_files.h"

#include "mrpt_ext/configuration/localization_choices.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/settings/key_section.h"

namespace mrpt_ext
{
KeyTable filterKeys()
{
  const ParticleFilterOptions filter;
  return KeySection("ParticleFilter")
      .number("mode_cell_m", "m", filter.modes.cell_xy, ranges::kPositive,
              "Peaks of the posterior closer than about two cells are one mode.")
      .degrees("mode_cell_deg", "deg", filter.modes.cell_phi, {0.1, 360}, "The same for the heading.")
      .flag("learn_reliability", filter.learn_reliability, "Learn the outlier rate of every landmark.")
      .number("reliability_prior", "", filter.reliability_prior_strength, ranges::kPositive,
              "Weight of clutter_probability, in detections of a landmark. Its learned outlier rate starts from there.")
      .number("reseed_inlier_ratio", "", filter.recovery.reseed_inlier_ratio, ranges::kShare,
              "Inlier ratio below which hypotheses are injected. Of recent detections, relative to the expected ratio.")
      .number("lost_inlier_ratio", "", filter.recovery.lost_inlier_ratio, ranges::kShare,
              "Inlier ratio below which the verdict is `lost`.")
      .number("injected_particle_share", "", filter.recovery.injected_particle_share, ranges::kShare,
              "Injected particles per frame, relative to particles_count.")
      .number("relocalization_prior", "", filter.recovery.relocalization_prior, {1e-9, 1},
              "Prior probability of a jump, per injection. That is: the robot is at a pose that no particle has.")
      .flag("mode_kalman_filters", filter.mode_kalman_filters,
            "Weight the modes by Kalman filters. While several modes are possible, one Kalman filter per mode decides "
            "their weights; the particles keep the shape of each mode.")
      .integer("kalman_proposal_below_ess", "", filter.kalman_proposal_below_ess, {0, 1e9},
               "Effective particles below which a Kalman proposal is used. Particles are drawn around the posterior of "
               "an iterated Kalman update and weighted by importance (up to 4000 particles). 0: never.")
      .number("ok_min_weight", "", filter.verdict.min_best_weight, ranges::kShare,
              "Minimum weight of the best mode for the verdict `ok`. A mode with 0.9, or with this if it is less, is "
              "followed as the only one.")
      .number("ok_max_std_m", "m", kUnset, ranges::kPositive,
              "Maximum standard deviation of the position for `ok`: root of the sum of both variances. Default: "
              "converged_within_m. Raise it where the sensors cannot give that.")
      .degrees("ok_max_std_deg", "deg", kUnset, ranges::kPositive,
               "Maximum standard deviation of the heading for `ok`. Default: converged_within_deg. Raise it where the "
               "sensors cannot give that.");
}

KeyTable mrptKeys()
{
  const ParticleFilterOptions filter;
  const KldOptions& kld = filter.kld;
  KeyTable table =
      KeySection("PF_options")
          .choice("PF_algorithm", LocalizationConfig{}.mrpt_algorithm, mrptAlgorithms(),
                  "Proposal distribution of the mrpt engine. That of the batch engine is chosen by "
                  "kalman_proposal_below_ess.")
          .choice("resamplingMethod", filter.resampling, resamplingMethods(), "Resampling algorithm.")
          .flag("adaptiveSampleSize", filter.adaptive_size, "KLD sampling, see [KLD_options].")
          .number("BETA", "", filter.resample_below, ranges::kShare,
                  "Effective sample ratio below which particles are resampled.")
          .integer("sampleSize", "", filter.particles, ranges::kCount, "Number of particles. See particles_count.");
  table.append(KeySection("KLD_options")
                   .number("KLD_binSize_XY", "m", kld.bin_xy, ranges::kPositive, "Size of a bin.")
                   .degrees("KLD_binSize_PHI_deg", "deg", kld.bin_phi, {0.1, 360}, "Size of a bin.")
                   .number("KLD_delta", "", kld.delta, {1e-6, 0.5}, "Probability of exceeding KLD_epsilon.")
                   .number("KLD_epsilon", "", kld.epsilon, ranges::kPositive, "Maximum Kullback-Leibler distance.")
                   .integer("KLD_minSampleSize", "", kld.min_size, ranges::kCount, "Minimum number of particles.")
                   .integer("KLD_maxSampleSize", "", kld.max_size, ranges::kCount, "Maximum number of particles."));
  table.append(KeySection("MetricMap")
                   .integer("landmarkMap2D_count", "", kLandmarkMaps, {1, 1}, "Number of landmark maps: one."));
  return table.append(KeySection(kMapSection)
                          .path("landmarks_file",
                                "Map: CSV id,x,y,z,category[,std_x,std_y], a WPILib field layout (.json) or tags.yaml. "
                                "--map replaces it.")
                          .forBeginners());
}
}  // namespace mrpt_ext
