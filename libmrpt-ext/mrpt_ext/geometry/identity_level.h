#pragma once

namespace mrpt_ext
{
/// How much of a landmark's identity a detection carries.
enum class IdentityLevel
{
  known,     ///< id and category
  category,  ///< category only
  anonymous  ///< neither
};
}  // namespace mrpt_ext
