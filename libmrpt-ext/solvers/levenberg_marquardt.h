#pragma once

#include <Eigen/Cholesky>
#include <cmath>

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

struct DescentOptions
{
  int max_iterations = 50;
  double relative_step = 1e-13;  ///< stop when a step promises to lower the cost relatively less than this
  double good_enough = 0;        ///< stop at a cost below this
};

struct DescentReport
{
  int iterations = 0;
  bool converged = false;  ///< false: the iteration limit came first
};

/// Levenberg-Marquardt that never leaves its start for the worse: only steps that lower the cost are taken.
/// `model(state)` returns NormalEquations<N>; `cost(state)` the cost alone; `moved(state, step)` the new state.
/// Damping is relative to the diagonal (with a floor), so that units do not matter.
template <int N, class State, class Model, class Cost, class Moved>
DescentReport descend(State& state, const Model& model, const Cost& cost, const Moved& moved,
                      const DescentOptions& options = {})
{
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  DescentReport report;
  double damping = 1e-6;
  NormalEquations<N> now = model(state);
  for (; report.iterations < options.max_iterations; ++report.iterations)
  {
    const double floor = 1e-12 * now.hessian.trace();
    Matrix damped = now.hessian;
    damped.diagonal().array() += damping * (now.hessian.diagonal().array() + floor);
    const Vector step = -damped.ldlt().solve(now.gradient);
    // What the quadratic model promises; nothing left to gain means converged.
    const double promised = -(2 * now.gradient.dot(step) + step.dot(now.hessian * step));
    const double least = options.relative_step * options.relative_step * now.cost;
    if (!step.allFinite() || now.cost <= options.good_enough || !(promised > least))
    {
      report.converged = step.allFinite();
      return report;
    }
    const State next = moved(state, step);
    const double next_cost = cost(next);
    if (next_cost < now.cost)
    {
      state = next;
      damping = std::max(damping * 0.1, 1e-12);
      const bool settled = promised < options.relative_step * now.cost && damping < 1e-3;
      now = model(state);
      if (settled)
      {
        report.converged = true;
        return report;
      }
    }
    else
    {
      // At the bottom only rounding is left to argue about.
      if (promised < options.relative_step * now.cost || damping > 1e12)
      {
        report.converged = true;
        return report;
      }
      damping = std::max(damping * 10, 1e-6);
    }
  }
  return report;
}
}  // namespace mrpt_ext
