#include "mrpt_ext/correspondence/pose_judge.h"

#include <algorithm>
#include <limits>

#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext
{
namespace
{

constexpr double kMinClutter = 1e-6;  // a sensor that never errs would make every evidence infinite
constexpr double kSamePlace = 4;      // poses closer than this many standard deviations are one

}  // namespace
}  // namespace mrpt_ext
