#include "mrpt_ext/configuration/localization_choices.h"

namespace mrpt_ext
{
NamedValues<InitialMode> initialModes()
{
  return {{InitialMode::analytic, {"analytic", {}, "closed-form poses from the first frames, and a uniform share"}},
          {InitialMode::uniform, {"uniform", 1, "uniform over the init_PDF box"}},
          {InitialMode::gaussian, {"gaussian", {}, "around the known pose init_PDF_mean"}}};
}

NamedValues<FilterEngine> filterEngines()
{
  return {{FilterEngine::batch, {"batch", {}, "this project's particle filter"}},
          {FilterEngine::mrpt, {"mrpt", {}, "MRPT's CMonteCarloLocalization2D, as a reference"}}};
}

NamedValues<HeadingSource> headingSources()
{
  return {{HeadingSource::bearing, {"bearing", {}, "bearings of landmarks, propagated by odometry"}},
          {HeadingSource::compass, {"compass", {}, "a compass, propagated by odometry"}},
          {HeadingSource::filter, {"filter", {}, "the particle filter, on which the estimates then depend"}},
          {HeadingSource::none, {"none", {}, "no heading: a ring of poses, no estimate"}}};
}

NamedValues<MotionType> motionTypes()
{
  return {{MotionType::odometry, {"odometry", {}, "measured displacements"}},
          {MotionType::velocity, {"velocity", {}, "commanded velocities: no noise across the path"}},
          {MotionType::random_walk, {"random_walk", {}, "no odometry at all"}}};
}

NamedValues<ResamplingMethod> resamplingMethods()
{
  return {{ResamplingMethod::multinomial, {"prMultinomial", 0, "independent draws"}},
          {ResamplingMethod::residual, {"prResidual", 1, "whole copies first, then multinomial"}},
          {ResamplingMethod::stratified, {"prStratified", 2, "one draw per stratum"}},
          {ResamplingMethod::systematic, {"prSystematic", 3, "one draw for all strata"}}};
}

NamedValues<IdentityLevel> identityLevels()
{
  return {{IdentityLevel::known, {"known", {}, "id and category"}},
          {IdentityLevel::category, {"category", {}, "the category only"}},
          {IdentityLevel::anonymous, {"anonymous", {}, "neither"}}};
}

NamedValues<ReflectorShape> reflectorShapes()
{
  return {{ReflectorShape::round, {"round", {}, "a post"}},
          {ReflectorShape::flat, {"flat", {}, "a plate that faces the scanner"}}};
}

NamedValues<SweepDirection> sweepDirections()
{
  return {{SweepDirection::counterclockwise, {"counterclockwise", {}, "to the left"}},
          {SweepDirection::clockwise, {"clockwise", {}, "to the right"}}};
}

NamedValues<int> mrptAlgorithms()
{
  return {{0, {"pfStandardProposal", 0, "the motion model"}},
          {1, {"pfAuxiliaryPFStandard", 1, "auxiliary particle filter"}},
          {3, {"pfAuxiliaryPFOptimal", 3, "auxiliary particle filter with the optimal proposal"}}};
}

std::vector<KeyChoice> truthFormats()
{
  return {{"tum", {}, "timestamp tx ty tz qx qy qz qw"},
          {"mrpt-index", {}, "MRPT's `step x y phi`, by the number of the action"}};
}

std::vector<KeyChoice> methodNames()
{
  std::vector<KeyChoice> names{{"all", {}, "every method that the log has measurements for"},
                               {"particle_filter", {}, "Monte Carlo localization"},
                               {"odometry", {}, "dead reckoning from the known start"},
                               {"extended_kalman_filter", {}, "one hypothesis, restarted when lost"},
                               {"iterated_kalman_filter", {}, "the same, with iterated updates"},
                               {"kalman_filter_bank", {}, "one Kalman filter per hypothesis"},
                               {"running_fix", {}, "two ranges to one landmark, with odometry in between"}};
  const std::vector<KeyChoice> closed_forms{
      {"bearing_least_squares", {}, "linear least squares from bearings to identified landmarks"},
      {"bearing_maximum_likelihood", {}, "maximum likelihood from the same bearings"},
      {"interpretation_tree", {}, "search for the association of anonymous bearings"},
      {"two_landmark_pose", {}, "ranges and bearings of two identified landmarks"},
      {"range_least_squares", {}, "position from ranges to identified landmarks"}};
  for (const KeyChoice& method : closed_forms) names.push_back(method);
  for (const KeyChoice& method : closed_forms)
    names.push_back({method.name + "_joined", {}, "the same over join_window_s"});
  return names;
}
}  // namespace mrpt_ext
