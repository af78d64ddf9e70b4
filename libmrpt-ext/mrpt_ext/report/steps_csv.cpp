#include "mrpt_ext/report/steps_csv.h"

#include <algorithm>

#include "mrpt_ext/report/csv_field.h"

namespace mrpt_ext
{
namespace
{
/// A trajectory with the estimate of it that is not written yet.
struct Column
{
  explicit Column(const MethodTrajectory& trajectory) : method(&trajectory), next(trajectory.points.begin()) {}
  [[nodiscard]] bool atEnd() const { return next == method->points.end(); }

  const MethodTrajectory* method;
  DiskBackedSequence<PoseEstimate>::const_iterator next;
};

std::string rowText(const MethodTrajectory& method, const PoseEstimate& p)
{
  const Matrix3d& P = p.pose.covariance;
  return timeField(p.time) + ',' + textField(method.name) + ',' + lengthField(p.pose.mean.x) + ',' +
         lengthField(p.pose.mean.y) + ',' + (p.heading_known ? angleField(p.pose.mean.phi) : "") + ',' +
         covarianceField(P(0, 0)) + ',' + covarianceField(P(0, 1)) + ',' + covarianceField(P(1, 1)) + ',' +
         (p.heading_known ? covarianceField(P(2, 2)) : "") + ',' + std::to_string(p.modes) + ',' +
         shareField(p.best_weight) + ',' + (p.effective_samples ? shareField(*p.effective_samples) : "") + ',' +
         toString(p.verdict) + '\n';
}
}  // namespace

void stepsCsv(const RunRecord& record, const TextSink& write)
{
  write("t,method,x,y,phi_deg,cxx,cxy,cyy,cpp,modes,w_best,ess,verdict\n");
  std::vector<Column> columns(record.methods.begin(), record.methods.end());
  const auto isEarlier = [](const Column& a, const Column& b)
  { return !a.atEnd() && (b.atEnd() || a.next->time < b.next->time); };
  while (!columns.empty())
  {
    Column& first = *std::min_element(columns.begin(), columns.end(), isEarlier);
    if (first.atEnd()) return;
    write(rowText(*first.method, *first.next));
    ++first.next;
  }
}
}  // namespace mrpt_ext
