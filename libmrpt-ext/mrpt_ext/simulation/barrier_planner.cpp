#include "mrpt_ext/simulation/barrier_planner.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/simulation/rounding.h"

namespace mrpt_ext
{
namespace
{
constexpr int kTrials = 1000;
constexpr double kPathStep = 0.2;  // [s] between the poses to keep clear of

std::vector<Vector2d> randomRow(const BarrierPlan& plan, const Vector2d& low, const Vector2d& high,
                                RandomStream& random)
{
  const Vector2d centre(random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()));
  const double direction = random.uniform(0, kPi);
  const int posts = 1 + static_cast<int>(plan.length / plan.spacing);
  std::vector<Vector2d> row;
  for (int k = 0; k < posts; ++k)
  {
    const double along = (k - 0.5 * (posts - 1)) * plan.spacing;
    row.emplace_back(rounded(centre.x() + along * std::cos(direction)),
                     rounded(centre.y() + along * std::sin(direction)));
  }
  return row;
}

bool isClear(const Vector2d& post, double clearance, const RobotPath& path)
{
  for (double time = 0; time <= path.duration(); time += kPathStep)
    if ((path.poseAt(time).position() - post).norm() < clearance) return false;
  return true;
}
}  // namespace

std::vector<Vector2d> planBarriers(const BarrierPlan& plan, const Vector2d& low, const Vector2d& high,
                                   const RobotPath& path, RandomStream& random)
{
  std::vector<Vector2d> posts;
  for (int k = 0; k < plan.count; ++k)
  {
    std::vector<Vector2d> row;
    for (int trial = 0; row.empty(); ++trial)
    {
      if (trial == kTrials)
        throw configurationError("[Barriers]: no room beside the path for " + std::to_string(plan.count) +
                                 " barriers, expected fewer, shorter or a smaller clearance_m");
      row = randomRow(plan, low, high, random);
      if (!std::all_of(row.begin(), row.end(), [&](const auto& post) { return isClear(post, plan.clearance, path); }))
        row.clear();
    }
    posts.insert(posts.end(), row.begin(), row.end());
  }
  return posts;
}
}  // namespace mrpt_ext
