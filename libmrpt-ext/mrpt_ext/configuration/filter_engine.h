#pragma once

namespace mrpt_ext
{
enum class FilterEngine
{
  batch,  ///< our particle filter
  mrpt    ///< MRPT's CMonteCarloLocalization2D, the reference
};
}  // namespace mrpt_ext
