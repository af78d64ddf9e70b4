#include "mrpt_ext/report/error_series.h"

#include <algorithm>
#include <map>
#include <set>

namespace mrpt_ext
{
namespace
{
void keepWorst(OptionalNumber& kept, const OptionalNumber& error)
{
  if (error && (!kept || *error > *kept)) kept = error;
}
}  // namespace

ErrorSeries errorSeries(const RunContext& context, const RunScore& score, std::size_t max_stamps)
{
  std::set<double> all;
  for (const MethodScore& method : score.methods)
    for (const ErrorSample& error : method.errors) all.insert(error.stamp);
  ErrorSeries series;
  if (all.empty()) return series;
  series.stamps_per_entry = entriesPerPoint(all.size(), max_stamps);
  std::map<double, std::size_t> entry_of;
  for (const double stamp : all)
  {
    const std::size_t count = entry_of.size();
    if (count % series.stamps_per_entry == 0) series.stamps.push_back(stamp - context.start_time);
    entry_of[stamp] = series.stamps.size() - 1;
  }
  for (const MethodScore& method : score.methods)
  {
    std::vector<OptionalNumber> position(series.stamps.size()), heading(series.stamps.size());
    for (const ErrorSample& error : method.errors)
    {
      keepWorst(position[entry_of[error.stamp]], error.position_m);
      keepWorst(heading[entry_of[error.stamp]], error.heading_deg);
    }
    series.position_m.push_back(std::move(position));
    series.heading_deg.push_back(std::move(heading));
  }
  return series;
}
}  // namespace mrpt_ext
