#pragma once

#include <optional>

#include "movis_lattice.h"
#include "mrpt_ext/solvers/origin_correction.h"

namespace mrpt_ext::papers
{
/// What a method says at one point of the lattice, robot frame and world as in the paper.
struct MovisAnswer
{
  Vector2d position{0, 0};       ///< world [m]
  double slope = 0;              ///< beta [rad]; the robot stood straight, so this is the error of its heading
  Vector2d ball_in_robot{0, 0};  ///< [m]
  Vector2d ball_in_field{0, 0};  ///< [m]
};

/// Eq 1-7 and 9-10 with the corrected signs, by the right pole, (X_r, Y_r) taken for the position as the paper does.
[[nodiscard]] std::optional<MovisAnswer> paperAnswer(const MovisLattice& lattice, const MovisLook& look,
                                                     const OriginCorrection& correction = {});

/// Eq 8 from one look at the origin.
[[nodiscard]] OriginCorrection paperCorrection(const MovisLattice& lattice, const MovisLook& at_origin);

/// The most likely pose from the azimuths of the poles; `heading_told`: that the robot stands straight is believed.
[[nodiscard]] std::optional<MovisAnswer> likeliestAnswer(const MovisLattice& lattice, const MovisLook& look,
                                                         bool heading_told = false);

/// An answer of an estimator that reaches the Cramer-Rao bound at `place`, cameras straight; drawn.
[[nodiscard]] MovisAnswer answerAtBound(const MovisLattice& lattice, const Vector2d& place, bool heading_told,
                                        RandomStream& random);
}  // namespace mrpt_ext::papers
