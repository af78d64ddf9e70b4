#pragma once

#include <gtest/gtest.h>

#include <string>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::testing
{
/// The message of the Error that `action` throws; a note when it throws nothing.
template <typename Error, typename Action>
std::string messageOf(Action&& action)
{
  try
  {
    action();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "(nothing was thrown)";
}

/// The message of the mistake in the configuration that `action` throws; a note when it throws nothing.
template <typename Action>
std::string configurationErrorOf(Action&& action)
{
  return messageOf<InputError>(
      [&]
      {
        try
        {
          action();
        }
        catch (const InputError& error)
        {
          EXPECT_EQ(error.kind(), InputError::Kind::configuration);
          throw;
        }
      });
}
}  // namespace mrpt_ext::testing
