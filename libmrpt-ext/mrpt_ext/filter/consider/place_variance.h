#pragma once

#include "mrpt_ext/filter/consider/relevance.h"

namespace mrpt_ext
{
/// [m^2] How well places on a robot are stated, where nobody says: their variance about the stated ones along each
/// axis, one for all. Before anything is told it is `assumed_std` squared. Some robots are measured by a ruler and some
/// by a drawing, so its scale may be anything between a fifteenth and twice of that, each as likely as the other (a
/// scale mixture of normal distributions: Andrews and Mallows, 1974), and what turns tell of some of the places, of
/// which `evidence` holds all and nothing else, makes some scales likelier than others.
[[nodiscard]] double placeVariance(const LinearEvidence& evidence, double assumed_std);
}  // namespace mrpt_ext
