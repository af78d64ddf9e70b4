#pragma once

#include "movis_methods.h"
#include "sample.h"

namespace mrpt_ext::papers
{
/// Errors of one method over many visits of the lattice. D is the distance of the estimated from the true position.
struct LatticeErrors
{
  Sample mean_d, median_d, rms_d;  ///< over the points, one value per visit [m]
  Sample mean_d_elsewhere;         ///< without the point where the cameras were calibrated [m]
  Sample slope;                    ///< mean |beta| without that point [rad], one per visit
  Sample ball_in_robot;            ///< mean distance of the ball from where it is, seen from the robot [m]
  Sample ball_in_field;            ///< ... in the field [m]
  Sample frame_slip;               ///< mean distance between Table 4 and Table 1 + Table 3 [m], outside that point
  std::vector<Sample> at_point;    ///< D of every point, over the visits [m]
};

struct MovisExperiment
{
  MovisLattice lattice;
  LatticeErrors closed_form;        ///< Table 2: eq 1-7
  LatticeErrors origin_corrected;   ///< Table 3: with eq 8
  LatticeErrors straight_closed;    ///< eq 1-7 after the yaw calibration
  LatticeErrors likeliest;          ///< maximum likelihood, cameras as they are
  LatticeErrors best;               ///< maximum likelihood after the yaw calibration
  LatticeErrors best_told;          ///< ... believing that the robot stands straight
  LatticeErrors bound, bound_told;  ///< at the Cramer-Rao bound, cameras straight
  // Share by which eq 8 lowers D, one value per visit: means, means outside the origin, medians, RMS.
  Sample lower_mean, lower_mean_elsewhere, lower_median, lower_rms;
  std::vector<double> worse;  ///< share of the visits in which eq 8 makes the point worse
};

/// Every visit looks once at each point; eq 8 and the yaw calibration come from its one look at the origin.
[[nodiscard]] MovisExperiment runMovisExperiment(const Settings& settings);
}  // namespace mrpt_ext::papers
