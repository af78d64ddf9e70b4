#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <optional>

namespace mrpt_ext
{
/// Quadratic model of a cost at one state: cost, J^T W r and J^T W J.
template <int N>
struct NormalEquations
{
  double cost = 0;
  Eigen::Matrix<double, N, 1> gradient = Eigen::Matrix<double, N, 1>::Zero();
  Eigen::Matrix<double, N, N> hessian = Eigen::Matrix<double, N, N>::Zero();
};

/// x of A x = b for a positive definite A; not finite when A is not.
template <int N>
Eigen::Matrix<double, N, 1> solvePositive(Eigen::Matrix<double, N, N> A, Eigen::Matrix<double, N, 1> b)
{
  for (int k = 0; k < N; ++k)
  {
    const double inverse = A(k, k) > 0 ? 1 / A(k, k) : std::numeric_limits<double>::quiet_NaN();
    for (int i = k + 1; i < N; ++i)
    {
      const double factor = A(i, k) * inverse;
      for (int j = k + 1; j < N; ++j) A(i, j) -= factor * A(k, j);
      b[i] -= factor * b[k];
    }
    A(k, k) = inverse;
  }
  for (int k = N - 1; k >= 0; --k)
  {
    for (int j = k + 1; j < N; ++j) b[k] -= A(k, j) * b[j];
    b[k] *= A(k, k);
  }
  return b;
}

struct DescentOptions
{
  int max_iterations = 50;
  double relative_step = 1e-13;  ///< stop when a step promises to lower the cost relatively less than this
};

struct DescentReport
{
  int iterations = 0;
  bool converged = false;  ///< false: the iteration limit came first
};

/// Levenberg-Marquardt that never leaves its start for the worse: only steps that lower the cost are taken.
/// `now` is the model at `state` and stays so. `improved(next, cost)` returns the model at `next` if the cost there is
/// lower, else nothing; `moved(state, step)` the new state. Damping is relative to the diagonal (with a floor), so that
/// units do not matter.
template <int N, class State, class Improved, class Moved>
DescentReport descendFrom(State& state, NormalEquations<N>& now, const Improved& improved, const Moved& moved,
                          const DescentOptions& options = {})
{
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  DescentReport report;
  double damping = 1e-6;
  for (; report.iterations < options.max_iterations; ++report.iterations)
  {
    const double floor = 1e-12 * now.hessian.trace();
    Matrix damped = now.hessian;
    damped.diagonal().array() += damping * (now.hessian.diagonal().array() + floor);
    const Vector step = -solvePositive<N>(damped, now.gradient);
    // What the quadratic model promises; nothing left to gain means converged.
    const double promised = -(2 * now.gradient.dot(step) + step.dot(now.hessian * step));
    const double least = options.relative_step * options.relative_step * now.cost;
    if (!step.allFinite() || now.cost <= 0 || !(promised > least))
    {
      report.converged = step.allFinite();
      return report;
    }
    const bool at_the_bottom = promised < options.relative_step * now.cost;  // only rounding is left to argue about
    const State next = moved(state, step);
    if (const std::optional<NormalEquations<N>> there = improved(next, now.cost))
    {
      state = next;
      now = *there;
      damping = std::max(damping * 0.1, 1e-12);
      report.converged = at_the_bottom && damping < 1e-3;
    }
    else
    {
      report.converged = at_the_bottom || damping > 1e12;
      damping = std::max(damping * 10, 1e-6);
    }
    if (report.converged) return report;
  }
  return report;
}

/// The same from `model(state)`, which returns NormalEquations<N>, and `cost(state)`, the cost alone, for costs that
/// are much cheaper than their model.
template <int N, class State, class Model, class Cost, class Moved>
DescentReport descend(State& state, const Model& model, const Cost& cost, const Moved& moved,
                      const DescentOptions& options = {})
{
  NormalEquations<N> now = model(state);
  const auto improved = [&](const State& next, double bound) -> std::optional<NormalEquations<N>>
  {
    if (!(cost(next) < bound)) return std::nullopt;
    return model(next);
  };
  return descendFrom<N>(state, now, improved, moved, options);
}
}  // namespace mrpt_ext
