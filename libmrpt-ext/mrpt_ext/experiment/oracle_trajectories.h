#pragma once

#include <map>
#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/localizers/localizer.h"

namespace mrpt_ext
{
/// What methods with several candidates would reach with perfect selection: the candidate nearest the truth, as a row
/// `oracle_<method>` of its own that is marked as such. Kept apart from the methods, which never see the truth.
class OracleTrajectories
{
 public:
  explicit OracleTrajectories(const Trajectory& truth) : truth_(truth) {}

  void add(const MethodTrajectory& method, const Estimate& estimate, double time);
  /// One trajectory per method that ever had several candidates, in the order of first appearance.
  [[nodiscard]] std::vector<MethodTrajectory> take();

 private:
  struct Entry
  {
    MethodTrajectory trajectory;
    bool several = false;
  };
  const Trajectory& truth_;
  std::vector<Entry> entries_;
};
}  // namespace mrpt_ext
