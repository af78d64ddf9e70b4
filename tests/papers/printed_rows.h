#pragma once

#include <array>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext::papers
{
/// A row each of tables 1 to 4 of paper 001, X and Y [cm] as printed, in the order of the lattice points A to M.
struct PrintedPoint
{
  std::array<double, 2> object_in_robot, before, after, object_in_field;
};

inline constexpr std::array<PrintedPoint, 13> kPrintedPoints{{{{104, 100}, {-2, 198}, {-10, 206}, {39, 317}},
                                                              {{1, 107}, {-34, 179}, {-35, 195}, {-47, 300}},
                                                              {{-112, 116}, {181, 200}, {194, 203}, {20, 328}},
                                                              {{195, 198}, {-220, 64}, {-232, 87}, {-66, 279}},
                                                              {{103, 206}, {-79, 87}, {-78, 106}, {-18, 303}},
                                                              {{7, 218}, {-7, 80}, {0, 98}, {-28, 314}},
                                                              {{-102, 215}, {91, 82}, {111, 100}, {-20, 294}},
                                                              {{-234, 241}, {217, 60}, {248, 76}, {-34, 314}},
                                                              {{213, 309}, {-175, -37}, {-183, -10}, {-29, 315}},
                                                              {{114, 321}, {-113, -50}, {-110, -21}, {-45, 299}},
                                                              {{-25, 330}, {-27, -34}, {0, 0}, {-25, 330}},
                                                              {{-90, 326}, {69, -12}, {100, 11}, {-25, 336}},
                                                              {{-212, 344}, {215, -67}, {253, -45}, {-21, 301}}}};

/// Points whose Y in table 4 is a misprint: no turn of the sum of tables 1 and 3 gives it.
inline constexpr const char* kMisprintedAt = "E G I";

/// Tables 1 and 2 of paper 004: mean and standard deviation of |dx|, |dy| [cm] and |dtheta| [deg], as printed.
struct PrintedPoseErrors
{
  const char *dx, *dy, *heading;
};

inline constexpr std::array<PrintedPoseErrors, 2> kPrintedPoseErrors{
    {{"10.0 ± 10.0", "16.9 ± 15.6", "14.6 ± 11.8"}, {"8.9 ± 6.3", "12.7 ± 10.5", "12.3 ± 7.6"}}};

[[nodiscard]] inline Vector2d inMetres(const std::array<double, 2>& printed)
{
  return {0.01 * printed[0], 0.01 * printed[1]};
}
}  // namespace mrpt_ext::papers
