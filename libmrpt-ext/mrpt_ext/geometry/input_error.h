#pragma once

#include <stdexcept>
#include <string>

namespace mrpt_ext
{
/// A user's mistake or damaged data, worded as one line: `file:line: what is wrong, what is expected`.
/// Thrown by readers only, caught once per app; never thrown by solvers, likelihoods or filters.
class InputError : public std::runtime_error
{
 public:
  enum class Kind
  {
    configuration,  ///< wrong usage or configuration: exit code 2
    data            ///< unreadable or damaged data: exit code 1
  };
  InputError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  [[nodiscard]] Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

[[nodiscard]] inline InputError configurationError(const std::string& message)
{
  return {InputError::Kind::configuration, message};
}
[[nodiscard]] inline InputError dataError(const std::string& message) { return {InputError::Kind::data, message}; }
}  // namespace mrpt_ext
