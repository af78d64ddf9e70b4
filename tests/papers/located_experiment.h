#pragma once

#include <array>
#include <vector>

#include "sample.h"
#include "stereo_rig.h"

namespace mrpt_ext::papers
{
/// What may make a trial of paper 004 "located".
enum class LocatedRule
{
  intersects,         ///< the circles meet
  inside,             ///< ... at least once inside the field
  exactly_one_inside  ///< ... exactly once inside the field: no doubt between the candidates
};
inline constexpr int kLocatedRules = 3;

/// Share of the trials that are located, for one way between the two ranges.
struct LocatedShares
{
  double displacement = 0;   ///< [m]
  bool ahead = false;        ///< the robot drives where it looks; else in any direction
  bool any_heading = false;  ///< trials begin with any heading, so that most see no corner; else with a corner in view
  double range_scale = 1;    ///< measured / true range
  std::array<std::vector<double>, kLocatedRules> share;  ///< [rule][image width]

  /// Both printed counts, 176 and 381 of 500, lie within two standard deviations of a repetition.
  [[nodiscard]] bool matchesPaper(LocatedRule rule) const;
};

/// Errors of the trials whose circles meet [m, rad].
struct LocatedErrors
{
  double width = 0;  ///< [px]
  struct Method
  {
    Sample dx, dy, distance, heading;
  };
  Method closed_form;  ///< as measured, ranges too long
  Method best;         ///< maximum likelihood with the bearing, the scale taken off
  Method bound;        ///< drawn; without heading
};

struct LocatedExperiment
{
  static constexpr double kPrinted[2] = {176, 381};  ///< of 500, QVGA and VGA
  static constexpr double kOf = 500;
  std::vector<LocatedShares> tried;
  std::vector<LocatedErrors> errors;  ///< one per image width
  int trials_per_share = 0;
};

/// Tables 1 and 2 of paper 004.
[[nodiscard]] LocatedExperiment runLocatedExperiment(const Settings& settings);
}  // namespace mrpt_ext::papers
