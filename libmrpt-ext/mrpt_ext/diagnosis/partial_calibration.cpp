#include "mrpt_ext/diagnosis/partial_calibration.h"

#include <utility>

#include "mrpt_ext/diagnosis/choice_part.h"

namespace mrpt_ext
{
std::size_t middleOf(const CalibrationProblem& problem) { return problem.readings[problem.readings.size() / 2].pose; }

CalibrationProblem firstPart(const CalibrationProblem& problem, std::size_t end)
{
  CalibrationProblem part = problem;
  part.poses.resize(end);
  std::erase_if(part.readings, [&](const CalibrationReading& r) { return r.pose >= end; });
  return part;
}

CalibrationResult calibrateSome(const CalibrationProblem& problem, const std::vector<CalibrationUnknown>& unknowns,
                                const std::vector<std::size_t>& numbers, const CalibrationResult& otherwise)
{
  std::vector<CalibrationUnknown> some;
  for (const std::size_t k : numbers) some.push_back(unknowns[k]);
  CalibrationResult found = calibrate(problem, some);
  if (found.status != SolveStatus::ok) return otherwise;
  const std::vector<ParameterEstimate> errors = std::exchange(found.errors, otherwise.errors);
  const auto size = static_cast<Eigen::Index>(unknowns.size());
  const Eigen::MatrixXd covariance = std::exchange(found.covariance, Eigen::MatrixXd::Zero(size, size));
  found.covariance(numbers, numbers) = covariance;
  for (std::size_t a = 0; a < numbers.size(); ++a) found.errors[numbers[a]] = errors[a];
  return found;
}

std::vector<std::size_t> withToldRegimes(const std::vector<CalibrationUnknown>& unknowns,
                                         const CalibrationResult& found, double deviations)
{
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < unknowns.size(); ++k)
  {
    const ParameterEstimate& error = found.errors[k];
    const bool differs = unknowns[k].parameter != CalibrationParameter::pivot_scale || strengthOf(error) > deviations;
    if (!isOfRegime(unknowns[k].parameter) || (error.observable && differs)) numbers.push_back(k);
  }
  return numbers;
}

CalibrationResult withoutErrors(CalibrationResult found, const std::vector<std::size_t>& numbers)
{
  for (const std::size_t k : numbers)
  {
    const auto i = static_cast<Eigen::Index>(k);
    const double variance = found.covariance(i, i), value = found.errors[k].value;
    found.errors[k].value = 0;
    if (!(variance > 0)) continue;
    const Eigen::VectorXd follows = found.covariance.col(i) / variance;
    for (std::size_t j = 0; j < found.errors.size(); ++j)
      if (j != k) found.errors[j].value -= value * follows[static_cast<Eigen::Index>(j)];
    found.covariance -= variance * follows * follows.transpose();
  }
  return found;
}
}  // namespace mrpt_ext
