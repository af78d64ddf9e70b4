#pragma once

#include "mrpt_ext/configuration/filter_engine.h"
#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/frames/reflector_extraction.h"
#include "mrpt_ext/geometry/identity_level.h"
#include "mrpt_ext/geometry/scan_sweep.h"
#include "mrpt_ext/localizers/running_fix_localizer.h"
#include "mrpt_ext/settings/key_choice.h"

namespace mrpt_ext
{
// The choices of landmark-localization's keys, for the table of keys and for the reader.

[[nodiscard]] NamedValues<InitialMode> initialModes();
[[nodiscard]] NamedValues<FilterEngine> filterEngines();
[[nodiscard]] NamedValues<HeadingSource> headingSources();
[[nodiscard]] NamedValues<MotionType> motionTypes();
[[nodiscard]] NamedValues<ResamplingMethod> resamplingMethods();
[[nodiscard]] NamedValues<IdentityLevel> identityLevels();
[[nodiscard]] NamedValues<ReflectorShape> reflectorShapes();
[[nodiscard]] NamedValues<SweepDirection> sweepDirections();
/// MRPT's numbers of PF_algorithm.
[[nodiscard]] NamedValues<int> mrptAlgorithms();
/// The forms of a file with the ground truth.
[[nodiscard]] std::vector<KeyChoice> truthFormats();
/// Every method that `methods` may name, and `all`.
[[nodiscard]] std::vector<KeyChoice> methodNames();
}  // namespace mrpt_ext
