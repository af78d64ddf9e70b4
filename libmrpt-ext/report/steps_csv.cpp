#include "mrpt_ext/report/steps_csv.h"

#include <algorithm>

#include "mrpt_ext/report/csv_field.h"

namespace mrpt_ext
{
namespace
{
struct Row
{
  const MethodTrack* method;
  const TrackPoint* point;
};

std::string rowText(const Row& row)
{
  const TrackPoint& p = *row.point;
  const Matrix3d& P = p.pose.covariance;
  return timeField(p.time) + ',' + textField(row.method->name) + ',' + lengthField(p.pose.mean.x) + ',' +
         lengthField(p.pose.mean.y) + ',' + (p.heading_known ? angleField(p.pose.mean.phi) : "") + ',' +
         covarianceField(P(0, 0)) + ',' + covarianceField(P(0, 1)) + ',' + covarianceField(P(1, 1)) + ',' +
         (p.heading_known ? covarianceField(P(2, 2)) : "") + ',' + std::to_string(p.modes) + ',' +
         shareField(p.best_weight) + ',' + (p.effective_samples ? shareField(*p.effective_samples) : "") + ',' +
         toString(p.verdict) + '\n';
}
}  // namespace

std::string stepsCsv(const RunRecord& record)
{
  std::vector<Row> rows;
  for (const MethodTrack& method : record.methods)
    for (const TrackPoint& point : method.points) rows.push_back({&method, &point});
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.point->time < b.point->time; });

  std::string text = "t,method,x,y,phi_deg,cxx,cxy,cyy,cpp,modes,w_best,ess,verdict\n";
  for (const Row& row : rows) text += rowText(row);
  return text;
}
}  // namespace mrpt_ext
